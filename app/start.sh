#!/bin/sh
# Installs what is missing, builds, and opens the window; where there is no display, simulates the default house: an
# answer, and pictures and data in out/.
set -eu
cd "$(dirname "$0")/.."
. app/packages.sh

install_packages $build_packages

if [ ! -f build/build.ninja ]; then
    echo "configuring in build/"
    configure meson setup build --buildtype=release -Db_lto=true -Db_lto_threads=2
fi
echo "building"
ninja -C build --quiet app/clearance

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec build/app/clearance
fi

house=houses/ube-techno-house.json
echo "there is no display for a window: running $house"
echo
# 1 is an answer too: not all people are out
build/app/clearance run "$house" --view raised --report --out out || [ $? -eq 1 ]
echo
echo "look at out/report.html, out/plan.png and out/raised.png; other houses: build/app/clearance run houses/NAME.json --out out"
