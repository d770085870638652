#!/bin/sh
# Installs what the tests need, builds with assertions, and runs the quick tests; with --all the long ones, too.
# A test that is skipped, or leaves files in the temporary folder, is an error.
# run.sh [--all]
set -eu
cd "$(dirname "$0")/.."
. app/packages.sh

case ${1:-} in
'') suites='--suite quick' ;;
--all) suites='--no-suite cluster --no-suite thorough' ;; # which need programs that few machines have, or take longest
*)
    echo "usage: sh tests/run.sh [--all]" >&2
    exit 2
    ;;
esac

install_packages $build_packages python3 python3-jsonschema clang-format poppler-utils libsundials-dev \
    xvfb xauth xdotool imagemagick ffmpeg binutils bash zsh fish

if [ ! -f build-test/build.ninja ]; then
    echo "configuring in build-test/"
    configure meson setup build-test --buildtype=debugoptimized
fi
echo "building"
ninja -C build-test --quiet
if [ ! -x build-test/tests/test_beam_peer ]; then
    echo "run.sh: build-test/ was configured without SUNDIALS, remove that folder and try again" >&2
    exit 1
fi
echo "testing"
. tests/checks/tidy.sh
tidy_begin
status=0
# twice as many as there are processors, since tests of the window wait for the display
meson test -C build-test --no-rebuild --print-errorlogs --num-processes $(($(nproc) * 2)) $suites || status=$?
tidy_end build-test || status=1
exit $status
