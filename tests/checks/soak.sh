#!/bin/sh
# Leaves the window to random input, and a long study running, for MINUTES (default 60): memory has to stay flat.
# soak.sh [MINUTES [CLEARANCE [SEED]]]
set -eu
cd "$(dirname "$0")/../.."
program=${2:-build-test/app/clearance}
[ -x "$program" ] || { echo "soak.sh: $program is missing, run tests/run.sh first" >&2; exit 2; }
CLEARANCE_SOURCE=$PWD LP_NUM_THREADS=0 python3 tests/app/window/soak.py "$program" "${1:-60}" "${3:-1}"
