#!/bin/sh
# Compares the digests of two builds with tests/golden/digests: of one at -O0 with one job, of an optimised one with
# two jobs and with four. A change of behaviour is a changed line of that file.
# same_bits.sh PLAIN_CLEARANCE FAST_CLEARANCE
set -u
plain=$1
fast=$2
checks=$(dirname "$0")
failed=0

# compare WHAT COMMAND...: the command prints the golden digests
compare() {
    what=$1
    shift
    "$@" | diff "$checks/../golden/digests" - && echo "the golden digests: $what" && return
    echo "other digests than the golden ones (<): $what"
    failed=1
}

compare "-O0, one job" sh "$checks/digests.sh" "$plain" --jobs 1
compare "-O2, two jobs" sh "$checks/digests.sh" "$fast" --jobs 2
compare "-O2, four jobs" sh "$checks/digests.sh" "$fast" --jobs 4
exit $failed
