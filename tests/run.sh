#!/bin/sh
# Installs what the tests need, builds with assertions, and runs all tests.
set -eu
cd "$(dirname "$0")/.."
. app/packages.sh

install_packages $build_packages python3 python3-jsonschema clang-format poppler-utils libsundials-dev \
    xvfb xauth xdotool imagemagick

if [ ! -f build-test/build.ninja ]; then
    echo "configuring in build-test/"
    configure meson setup build-test --buildtype=debugoptimized
fi
echo "building"
ninja -C build-test --quiet
echo "testing"
meson test -C build-test --no-rebuild --print-errorlogs
