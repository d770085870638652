#!/bin/sh
# Compares the digests of two builds with tests/golden/digests: of one at -O0 with one job, without those that take
# minutes there, and of an optimised one with four jobs, for which the C library is told that the processor has less than
# it has, and an optimised LAPACK stands first in the search for libraries if it is installed. A change of behaviour is a
# changed line of that file.
# same_bits.sh PLAIN_CLEARANCE FAST_CLEARANCE
set -u
plain=$1
fast=$2
checks=$(dirname "$0")
golden=$(mktemp -d)
trap 'rm -rf "$golden"' EXIT
failed=0

# compare WHAT PROGRAM OPTION...: the program's digests are the golden ones
compare() {
    what=$1
    shift
    grep -vE "^(${WITHOUT:-}) [0-9a-f]{16}" "$checks/../golden/digests" >"$golden/$what"
    sh "$checks/digests.sh" "$@" | diff "$golden/$what" - && echo "the golden digests: $what" && return
    echo "other digests (>) than the golden ones (<): $what"
    failed=1
    return 1
}

if ldd "$fast" | grep -E 'lib(lapack|lapacke|blas|cblas|openblas)'; then
    echo "the program takes LAPACK from the system, which may be an optimised one"
    failed=1
fi
WITHOUT='shopping-centre|ibs-r|ibs at 305 Hz|ssc'
export WITHOUT
compare "-O0, one job" "$plain" --jobs 1 &
slow=$!
LD_LIBRARY_PATH=$(dirname "$(ls -d /usr/lib/*/openblas-*/liblapack.so.3 2>/dev/null | tail -n 1)"):${LD_LIBRARY_PATH:-}
export LD_LIBRARY_PATH
# Names that a C library does not know, it leaves out; older ones call them _Usable.
GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-FMA_Usable,-AVX2_Usable,-FMA4_Usable
GLIBC_TUNABLES=$GLIBC_TUNABLES,-AVX,-AVX_Usable,-AVX512F,-AVX512F_Usable,-SSE4_1,-SSE4_2,-SSSE3
export GLIBC_TUNABLES
unset WITHOUT
compare "-O2, four jobs, without what came after SSE3" "$fast" --jobs 4
wait "$slow" || failed=1
exit $failed
