#!/bin/sh
# The Debian packages as a new user meets them: built twice in different folders to the same bytes, clean by lintian,
# installed in a fresh Debian 12, used, removed and purged, which leaves nothing. As root.
# package.sh
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/app/packages.sh"
[ "$(id -u)" -eq 0 ] || { echo "package.sh: must be run as root: a fresh system is a chroot" >&2; exit 1; }
install_packages debootstrap lintian desktop-file-utils appstream mandoc

work=$(mktemp -d)
fresh=$work/fresh
failed=0
finish() {
    for place in proc dev; do
        if mountpoint -q "$fresh/$place"; then umount "$fresh/$place"; fi
    done
    rm -rf "$work"
}
trap finish EXIT

# check WHAT COMMAND ...: the command succeeds
check() {
    what=$1
    shift
    if ! "$@" >"$work/log" 2>&1; then
        echo "FAIL $what"
        tail -n 20 "$work/log"
        failed=$((failed + 1))
    fi
}

within() {
    chroot "$fresh" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"
}

# as_user COMMANDS: in the home of a new user, without a display
as_user() {
    within su - user -c "export SDL_VIDEODRIVER=offscreen SDL_AUDIODRIVER=dummy LP_NUM_THREADS=1; $1"
}

# Everything but what apt and dpkg keep of their work, and the user's own.
list_files() {
    find "$fresh" -xdev \( -path "$fresh/var/lib/apt" -o -path "$fresh/var/lib/dpkg" -o -path "$fresh/var/cache" -o \
        -path "$fresh/var/log" -o -path "$fresh/home" -o -path "$fresh/root" -o -path "$fresh/tmp" -o \
        -path "$fresh/proc" -o -path "$fresh/dev" \) -prune -o -print | sort
}

# The menu entry, started by the desktop's own means, opens the file.
open_by_desktop() {
    as_user "gio launch /usr/share/applications/org.clearance.Clearance.desktop \$HOME/flat.house.json" &
    launched=$!
    begun= tries=0
    while [ -z "$begun" ] && [ $tries -lt 300 ]; do
        sleep 0.1
        tries=$((tries + 1))
        for process in /proc/[0-9]*; do
            [ "$(readlink "$process/root")" = "$fresh" ] || continue
            if tr '\0' ' ' <"$process/cmdline" | grep -qx 'clearance open /home/user/flat.house.json '; then
                begun=${process#/proc/}
            fi
        done
    done
    [ -n "$begun" ] && kill "$begun"
    wait $launched || true
    [ -n "$begun" ]
}

# complete WORD ...: what the completion of bash offers for the last word
complete() {
    as_user "bash -c '. /usr/share/bash-completion/bash_completion; . /usr/share/bash-completion/completions/clearance
        COMP_WORDS=($*); COMP_CWORD=\$((\${#COMP_WORDS[@]} - 1)); _clearance; printf \"%s\\\\n\" \"\${COMPREPLY[@]}\"'"
}

offers() {
    wanted=$1
    shift
    complete "$@" | grep -qxF -- "$wanted"
}

echo "building twice"
sh "$root/app/package/build.sh" "$work/one" >/dev/null
CCACHE_DISABLE=1 sh "$root/app/package/build.sh" "$work/another place" >/dev/null # nothing is taken from the first
for package in "$work"/one/*.deb; do
    check "the same bytes: ${package##*/}" cmp "$package" "$work/another place/${package##*/}"
done

echo "reading"
# there is no public address yet, and root is who may make a chroot
check "lintian" lintian --allow-root -I --pedantic --fail-on error,warning,info,pedantic \
    --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog "$work"/one/*.changes
dpkg-deb -x "$work"/one/clearance_*.deb "$work/tree"
check "the menu entry" desktop-file-validate "$work/tree/usr/share/applications/org.clearance.Clearance.desktop"
check "the metadata" appstreamcli validate --no-net "$work/tree/usr/share/metainfo/org.clearance.Clearance.metainfo.xml"
gunzip -c "$work/tree/usr/share/man/man1/clearance.1.gz" >"$work/clearance.1"
check "the manual page" mandoc -T lint -W warning "$work/clearance.1"

echo "a fresh Debian 12"
if ! debootstrap --variant=minbase bookworm "$fresh" >"$work/log" 2>&1; then
    tail "$work/log"
    echo "package.sh: a fresh system could not be made; it needs a mirror of Debian" >&2
    exit 1
fi
mount -t proc proc "$fresh/proc"
mount --bind /dev "$fresh/dev"
cp "$work"/one/clearance_*.deb "$work"/one/clearance-data_*.deb "$fresh/root/"
cp /etc/resolv.conf "$fresh/etc/"
within useradd -m user
depends=$(dpkg-deb -f "$work"/one/clearance_*.deb Depends | sed 's/clearance-data[^,]*, //')
check "what it depends on" within apt-get satisfy -y -q --no-install-recommends \
    "$depends, libegl1, libgl1, libgl1-mesa-dri, libosmesa6, man-db, bash-completion, desktop-file-utils, shared-mime-info, libglib2.0-bin, autopkgtest"
list_files >"$work/before"

echo "installing and using it"
check "install" within sh -c 'apt-get install -y -q --no-install-recommends /root/*.deb'
cp "$root"/houses/flat-0.910-module.json "$fresh/home/user/flat.house.json"
chmod a+r "$fresh/home/user/flat.house.json"
check "help" as_user 'clearance help studies | grep -q "clearance study"'
check "a house" as_user 'clearance run /usr/share/clearance/houses/straight-corridor.json --out out && test -s out/plan.png'
check "the menu entry's command" as_user \
    "printf 'wait 5\nstate states\nquit\n' >script && clearance open --script script && grep -q message states"
check "the type of a house" as_user 'gio info -a standard::content-type flat.house.json | grep -q "vnd.clearance.house+json"'
check "the type of a house without an ending" as_user \
    'cp flat.house.json flat && gio info -a standard::content-type flat | grep -q "vnd.clearance.house+json"'
check "who opens a house" as_user \
    'gio mime application/vnd.clearance.house+json | grep -q "org.clearance.Clearance.desktop"'
check "a double click" open_by_desktop
check "the manual" as_user 'MANWIDTH=80 man --warnings clearance 2>&1 | grep -q "EXIT STATUS"'
check "completion of a verb" offers study clearance st
check "completion of an option" offers --shake clearance study --sh
check "completion of a choice" offers miura clearance run x.json --driving m
check "completion of a file" offers flat.house.json clearance run fla
check "completion of a name" offers door.d3.width= clearance run flat.house.json --set door.d3.w

echo "removing it"
check "remove" within apt-get remove -y -q clearance clearance-data
check "install it again" within sh -c 'dpkg -i /root/*.deb'
check "purge" within apt-get purge -y -q clearance clearance-data
list_files >"$work/after"
check "nothing is left" diff "$work/before" "$work/after"
echo "its own tests" # last, since they install what they need and leave it
check "install it for its tests" within sh -c 'dpkg -i /root/*.deb'
mkdir "$fresh/tmp/source"
cp -r "$root/app/package/debian" "$fresh/tmp/source"
check "autopkgtest" within autopkgtest --no-built-binaries --summary-file /tmp/tests /tmp/source/ -- null
for test in run study files window; do
    check "autopkgtest $test" grep -Eq "^$test +PASS" "$fresh/tmp/tests"
done
echo "$failed failures"
[ "$failed" -eq 0 ]
