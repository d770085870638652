#!/bin/sh
# One raised frame, with plots and a report, under valgrind: no error and no leak but those of libraries.
# valgrind.sh CLEARANCE
set -eu
cd "$(dirname "$0")/../.."
. app/packages.sh
install_packages valgrind

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
valgrind --quiet --error-exitcode=9 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
    --suppressions=tests/checks/valgrind.supp \
    "$1" run houses/straight-corridor.json --frames 1 --to 0 --size 640x360 --view raised \
    --plots speed --report --out "$out" >/dev/null
