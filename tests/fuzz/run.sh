#!/bin/sh
# Fuzzes the readers, and what works with what they have read, for SECONDS (default 60) a target, as many targets at once
# as there are processors: run.sh [SECONDS [TARGET ...]]. A target is one thread, so that SECONDS are processor time on a
# machine with nothing else to do. The inputs that reached new code are kept in build-fuzz/corpus/; what was found is in
# build-fuzz/found/.
set -eu
cd "$(dirname "$0")/../.."
. app/packages.sh
seconds=${1:-60}
[ $# -eq 0 ] || shift
all="plan profile population beam crank parameters set observed measured timed script dxf sh3d vadere wkt journey world draft settings recovery progress store rules lesson"
targets=${*:-$all}
build=build-fuzz

for t in $targets; do
    case " $all " in
    *" $t "*) ;;
    *)
        echo "run.sh: the target \"$t\" is unknown, the targets are $all" >&2
        exit 2
        ;;
    esac
done
install_packages $build_packages clang libclang-rt-14-dev

if [ ! -f $build/build.ninja ]; then
    echo "configuring in $build/"
    # casts of numbers too large for a whole one are not among "undefined", and how plans go wrong
    instrument="-fsanitize=fuzzer-no-link,float-cast-overflow"
    CC=clang CXX=clang++ configure meson setup $build --buildtype=debugoptimized -Db_sanitize=address,undefined \
        -Db_lundef=false -Dc_args=$instrument -Dcpp_args=$instrument
fi
echo "building"
# shellcheck disable=SC2046 # a list of words
ninja -C $build --quiet app/clearance $(for t in $targets; do echo "tests/fuzz/fuzz_$t"; done)

export CLEARANCE_SOURCE="$PWD" ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
for schema in house profile beam crank rules lesson; do
    $build/app/clearance schema $schema
done | grep -oE '"[A-Za-z0-9_.-]+"' | sort -u | sed 's/.*/"\\&/; s/"$/\\""/' >$build/dictionary
cat tests/fuzz/imports.txt tests/fuzz/desk.txt >>$build/dictionary
rm -rf $build/seeds $build/found
mkdir -p $build/found
for t in $all; do
    mkdir -p $build/seeds/"$t" $build/corpus/"$t"
done
cp houses/*.json tests/data/bad/houses/*.json $build/seeds/plan/
cp houses/*.json $build/seeds/journey/
cp houses/*.json $build/seeds/world/
cp assets/profiles/*.json tests/data/bad/profiles/*.json $build/seeds/profile/
cp assets/populations/*.json tests/data/bad/populations/*.json $build/seeds/population/
cp assets/beams/*.json tests/data/bad/beams/*.json $build/seeds/beam/
cp assets/cranks/*.json tests/data/bad/cranks/*.json $build/seeds/crank/
cp assets/rules/*.json tests/data/bad/rules/*.json $build/seeds/rules/
cp assets/lessons/*.json tests/data/bad/lessons/*.json $build/seeds/lesson/
cp tests/data/bad/observed/*.csv $build/seeds/observed/
cp tests/data/bad/measured/*.csv $build/seeds/measured/
cp tests/data/bad/timed/*.csv $build/seeds/timed/
cp tests/data/bad/scripts/*.script $build/seeds/script/
for ending in dxf wkt sh3d; do
    cp tests/data/imports/*.$ending tests/data/bad/imports/*.$ending $build/seeds/$ending/
done
cp tests/data/imports/*.xml $build/seeds/sh3d/
cp tests/data/imports/*.scenario tests/data/bad/imports/*.scenario $build/seeds/vadere/
split -l 1 -a 3 tests/fuzz/values.txt $build/seeds/parameters/
split -l 2 -a 3 tests/fuzz/settings.txt $build/seeds/set/
split -l 1 -a 3 tests/fuzz/desk-files.txt $build/seeds/settings/
cp $build/seeds/settings/* $build/seeds/recovery/
split -l 1 -a 3 tests/fuzz/progress.txt $build/seeds/progress/
for bytes in 0 1 2 3; do # edits, and damages, of a few hundred arbitrary bytes
    tail -c +$((bytes * 400 + 1)) README.md | head -c 400 | tee $build/seeds/draft/$bytes >$build/seeds/store/$bytes
done

# a seed that is longer than the longest input would be cut off
longest=$(find $build/seeds -type f -printf '%s\n' | sort -n | tail -n 1)
longest=$((longest + longest / 4))
TMPDIR=$(mktemp -d)
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT

echo "fuzzing each target for $seconds s"
# shellcheck disable=SC2016,SC2086 # xargs passes the words
printf '%s\n' $targets | BUILD=$build SECONDS_EACH=$seconds LONGEST=$longest xargs -P "$(nproc)" -I TARGET sh -c '
    # these two plan and step whole houses, which with sanitizers takes some seconds for a large one
    case TARGET in world | journey) patience=20 ;; *) patience=10 ;; esac
    $BUILD/tests/fuzz/fuzz_TARGET -max_total_time="$SECONDS_EACH" -timeout=$patience -rss_limit_mb=2048 -max_len="$LONGEST" \
        -dict=$BUILD/dictionary -artifact_prefix=$BUILD/found/TARGET- -print_final_stats=1 \
        $BUILD/corpus/TARGET $BUILD/seeds/TARGET >$BUILD/TARGET.log 2>&1
    echo $? >$BUILD/TARGET.status'

bad=0
for t in $targets; do
    log=$build/$t.log
    found=$(find $build/found -name "$t-*" | wc -l)
    printf '%-10s %9s executions, coverage %5s, %s found\n' "$t" \
        "$(sed -n 's/^stat::number_of_executed_units: //p' "$log")" "$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 | cut -c 6-)" "$found"
    if [ "$found" -ne 0 ] || [ "$(cat $build/"$t".status)" -ne 0 ]; then
        bad=1
        grep -E -A 12 'does not hold|ERROR|runtime error|SUMMARY|out of memory' "$log" | head -n 40
        find $build/found -name "$t-*"
    fi
done
exit $bad
