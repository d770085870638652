#!/bin/sh
# Prints the digest of a run of every house, of a run of every beam and two of a crank with their largest forces, and of
# three studies. Every build, every processor and every number of jobs has to print the same, and tests/golden/digests
# keeps it. Fails if a run gives no digest. For a crowd of thousands two seconds are enough. WITHOUT, in the
# environment, is a regular expression of the names that are left out.
# digests.sh CLEARANCE [OPTION ...]
set -u
program=$1
shift
houses=$(dirname "$0")/../../houses
beams=$(dirname "$0")/../../assets/beams
crank=$(dirname "$0")/../../assets/cranks/ssc.json

# answer NAME ARGUMENT...: the name and the digest of an answer, and the largest force of one that has it
answer() {
    name=$1
    shift
    ! echo "$name" | grep -qxE "${WITHOUT:-}" || return 0
    "$program" "$@" --json | awk -v name="$name" '
        /"digest": "/ { split($0, part, "\""); digest = part[4] }
        /"peaks": \{/ { inside = 1 }
        inside && /"max": / { sub(/.*: /, ""); sub(/,.*/, ""); peak = " " $0 " N"; inside = 0 }
        END { if (digest == "") exit 1; print name, digest peak }'
}

for house in "$houses"/*.json; do
    until=600
    grep -q '"crowds"' "$house" && until=2
    answer "$(basename "$house" .json)" run "$house" --until "$until" "$@" || exit 1
done
for beam in "$beams"/*.json; do
    answer "$(basename "$beam" .json)" run "$beam" --lanes 0 "$@" || exit 1
done
answer "ibs at 305 Hz" run "$beams/ibs.json" --set drive.frequency=305 --lanes 0 "$@" || exit 1
answer "study of a corner" study "$houses/corner-1.20-1.20.json" --vary profile.manual-chair.width=0.5:0.7:3 --runs 2 \
    --spread profile.manual-chair.free_speed=0.1 "$@" || exit 1
answer "study of a beam" study "$beams/ibs.json" --vary drive.frequency=200:320:25 --sweep reset,up "$@" || exit 1
answer "ssc" run "$crank" --lanes 0 "$@" || exit 1
answer "ssc at 600 rpm" run "$crank" --set drive.frequency=10 --set joint.clearance=1e-4 "$@" || exit 1
answer "study of a crank" study "$crank" --vary drive.frequency=9:12:5 --set run.transient_cycles=20 \
    --set run.cycles=10 "$@" || exit 1
