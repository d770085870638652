#!/bin/sh
# Builds the Debian packages clearance and clearance-data from a copy of the sources, in which debian/ lies where the tools
# look for it. Installs what the build needs.
# build.sh [--install] [DIR]: where to put the packages, by default build-package/
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/app/packages.sh"

install=
if [ "${1:-}" = --install ]; then
    install=1
    shift
fi
mkdir -p "${1:-$root/build-package}"
into=$(cd "${1:-$root/build-package}" && pwd)

# shellcheck disable=SC2086 # the list is words
install_packages $build_packages debhelper dpkg-dev

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/clearance"
(cd "$root" && tar -cf - --exclude='./build*' --exclude=./out --exclude=./.git --exclude=__pycache__ .) |
    tar -xf - -C "$work/clearance"
mv "$work/clearance/app/package/debian" "$work/clearance/debian"
echo "building the packages"
export CCACHE_DIR="${CCACHE_DIR:-$HOME/.cache/ccache}" # debhelper has another home
log=$work/log
if ! (cd "$work/clearance" && dpkg-buildpackage -us -uc -b) >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    exit 1
fi
cp "$work"/*.deb "$work"/*.changes "$work"/*.buildinfo "$into"
ls "$into"/*.deb
[ -z "$install" ] && exit 0
as_root=
[ "$(id -u)" -eq 0 ] || as_root=sudo
$as_root apt-get install -y --no-install-recommends "$into"/clearance_*.deb "$into"/clearance-data_*.deb
