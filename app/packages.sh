# Sourced by app/start.sh and tests/run.sh: installs the Debian packages that are missing, and says so.

build_packages="meson ninja-build pkg-config gcc g++ libc6-dev libcairo2-dev libpango1.0-dev libbox2d-dev \
libpng-dev libjansson-dev libsqlite3-dev libgeos-dev libcsv-dev libzip-dev libexpat1-dev liblapacke-dev liblapack-dev libblas-dev gfortran libgl-dev libegl-dev libosmesa6-dev \
libsdl2-dev libimgui-dev libgl1 libglx-mesa0 fonts-dejavu-core libosmesa6 libegl1 libegl-mesa0 libgl1-mesa-dri"

# install_packages NAME ...
install_packages() {
    missing=
    for package in "$@"; do
        dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing="$missing $package"
    done
    [ -z "$missing" ] && return 0
    echo "installing:$missing"
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "as root: apt-get install$missing" >&2; return 1; }
        as_root=sudo
    fi
    log=$(mktemp)
    export DEBIAN_FRONTEND=noninteractive
    # shellcheck disable=SC2086 # the lists are words
    if ! $as_root apt-get install -y -q --no-install-recommends $missing >"$log" 2>&1; then
        # a fresh system has no package lists yet
        if ! { $as_root apt-get update -q && $as_root apt-get install -y -q --no-install-recommends $missing; } \
            >"$log" 2>&1; then
            cat "$log" >&2
            return 1
        fi
    fi
    rm -f "$log"
}

# configure COMMAND ...: quiet unless it fails
configure() {
    log=$(mktemp)
    "$@" >"$log" 2>&1 || { cat "$log" >&2; return 1; }
    rm -f "$log"
}
