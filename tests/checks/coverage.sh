#!/bin/sh
# Prints the share of the lines and branches that the unit tests and the command line reach, in all, of each folder, and
# of the ten files that they reach least. It takes some ten minutes, so that landings leave it out.
set -eu
cd "$(dirname "$0")/../.."
. app/packages.sh
install_packages gcovr
[ -f build-coverage/build.ninja ] || meson setup build-coverage --buildtype=debugoptimized -Db_coverage=true >/dev/null
ninja -C build-coverage --quiet
find build-coverage -name '*.gcda' -delete
meson test -C build-coverage --suite sanitize --no-rebuild --print-errorlogs -t 3
summary=$(mktemp)
trap 'rm -f "$summary"' EXIT
gcovr --root . --filter engine/ --filter app/ --exclude-unreachable-branches --exclude-throw-branches \
    --json-summary "$summary" build-coverage
python3 tests/checks/coverage.py "$summary"
