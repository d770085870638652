#!/bin/sh
# Prints the digest of a run of every house and beam, and of a study: the same bits are asked of every build and any
# number of jobs. Fails when one gives none. Of thousands of people two seconds are enough.
# digests.sh CLEARANCE [OPTION ...]
set -u
program=$1
shift
for house in "$(dirname "$0")"/../../houses/*.json; do
    until=600
    grep -q '"crowds"' "$house" && until=2
    digest=$("$program" run "$house" --json --until "$until" "$@" | sed -n 's/.*"digest": "\([0-9a-f]*\)".*/\1/p')
    [ -n "$digest" ] || exit 1
    echo "$(basename "$house" .json) $digest"
done
for beam in "$(dirname "$0")"/../../assets/beams/*.json; do
    digest=$("$program" run "$beam" --json | sed -n 's/.*"digest": "\([0-9a-f]*\)".*/\1/p')
    [ -n "$digest" ] || exit 1
    echo "$(basename "$beam" .json) $digest"
done
houses=$(dirname "$0")/../../houses
digest=$("$program" study "$houses/corner-1.20-1.20.json" --vary profile.manual-chair.width=0.5:0.7:3 --runs 2 \
    --spread profile.manual-chair.free_speed=0.1 --json "$@" | sed -n 's/.*"digest": "\([0-9a-f]*\)".*/\1/p')
[ -n "$digest" ] || exit 1
echo "study of a corner $digest"
digest=$("$program" study "$(dirname "$0")/../../assets/beams/ibs.json" --vary drive.frequency=200:320:25 --sweep reset,up \
    --json "$@" | sed -n 's/.*"digest": "\([0-9a-f]*\)".*/\1/p')
[ -n "$digest" ] || exit 1
echo "study of a beam $digest"
