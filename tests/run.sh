#!/bin/sh
# Installs what the tests need, builds with assertions, and runs the quick tests; with --all the long ones, too.
# run.sh [--all]
set -eu
cd "$(dirname "$0")/.."
. app/packages.sh

case ${1:-} in
'') suite=quick ;;
--all) suite= ;;
*)
    echo "usage: sh tests/run.sh [--all]" >&2
    exit 2
    ;;
esac

install_packages $build_packages python3 python3-jsonschema clang-format poppler-utils libsundials-dev \
    xvfb xauth xdotool imagemagick ffmpeg binutils

if [ ! -f build-test/build.ninja ]; then
    echo "configuring in build-test/"
    configure meson setup build-test --buildtype=debugoptimized
fi
echo "building"
ninja -C build-test --quiet
echo "testing"
meson test -C build-test --no-rebuild --print-errorlogs ${suite:+--suite $suite}
