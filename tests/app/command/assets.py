#!/usr/bin/env python3
"""Tests where the program looks for its shipped files: each place in order, from moved installations, and never in the
folder of its source.

assets.py CLEARANCE
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

from program import check, end, house, program, source

build = program.parent.parent
options = json.loads((build / "meson-info" / "intro-buildoptions.json").read_text())
configured = {option["name"]: option["value"] for option in options}
installed = pathlib.Path(configured["prefix"], configured["datadir"], "clearance")


def ask(copy, *arguments, **environment):
    """Runs that copy of the program; only the given variables name a place."""
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "CLEARANCE_", "DISPLAY", "WAYLAND_"))}
    return subprocess.run([copy, *arguments], capture_output=True, text=True, timeout=120, cwd=copy.parent,
                          env={**kept, "HOME": "/nonexistent", **{k: str(v) for k, v in environment.items()}})


def place_program(folder, *path):
    """Copies the program to a place below the folder."""
    copy = folder.joinpath(*path, "clearance")
    copy.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(program, copy)
    return copy


def place_assets(folder):
    """Makes assets with an empty profile: the program's error about the profile shows that it was opened."""
    (folder / "profiles").mkdir(parents=True)
    (folder / "profiles" / "manual-chair.json").write_text("{}")
    return folder


def opened(copy, **environment):
    """Returns the assets folder that the program uses when it reads a house whose person has a shipped profile."""
    done = ask(copy, "check", house("straight-corridor"), **environment)
    path, found, _ = done.stderr.partition("/profiles/manual-chair.json:")
    return pathlib.Path(path) if done.returncode == 2 and found else None


def check_order(folder):
    """All places have assets; when the first one is removed, the program uses the next one."""
    copy = place_program(folder, "build", "app")
    (folder / "build" / "build.ninja").write_text("")
    given, own, first, second = (folder / name for name in ("given", "own", "first", "second"))
    variables = {"CLEARANCE_ASSETS": given, "XDG_DATA_HOME": own, "XDG_DATA_DIRS": f"here:{first}::{second}"}
    places = [("CLEARANCE_ASSETS", given), ("share beside the program", folder / "build" / "share" / "clearance"),
              ("beside the build folder", folder / "assets"), ("XDG_DATA_HOME", own / "clearance"),
              ("the first of XDG_DATA_DIRS", first / "clearance"), ("the second of XDG_DATA_DIRS", second / "clearance")]
    for _, place in places:
        place_assets(place)
    place_assets(copy.parent / "here" / "clearance")  # a relative folder must be ignored
    for number, (name, place) in enumerate(places):
        found = opened(copy, **variables)
        check(found == place, f"{name} comes {number + 1}.", found)
        shutil.rmtree(place)
        if name == "CLEARANCE_ASSETS":
            del variables[name]
    done = ask(copy, "check", house("straight-corridor"), **variables)
    if installed.joinpath("profiles").exists():
        print(f"the configured folder {installed} has files: what is said when nothing is found is not tested")
        return
    check(done.returncode == 2, "nothing is found", done)
    last = done.stderr.splitlines()[-1]
    looked = [folder / "build" / "share" / "clearance", f"{folder}/build/../assets", own / "clearance",
              first / "clearance", second / "clearance", installed]
    check(": " + ", ".join(map(str, looked)) + "; set CLEARANCE_ASSETS to " in last,
          "one line names the places, the configured one last", last)
    wrong = ask(copy, "check", house("straight-corridor"), CLEARANCE_ASSETS=folder / "wrong").stderr.splitlines()[-1]
    check(f": {folder}/wrong; " in wrong, "a wrong CLEARANCE_ASSETS is the only place", wrong)
    script, states = folder / "script", folder / "states"
    script.write_text(f"wait 5\nstate {states}\nquit\n")
    ask(copy, "open", "--script", script, SDL_VIDEODRIVER="offscreen", SDL_AUDIODRIVER="dummy", LP_NUM_THREADS="1",
        ASAN_OPTIONS="detect_leaks=0", **variables)
    message = json.loads(states.read_text())["message"] if states.exists() else ""
    check(f", {installed}; set CLEARANCE_ASSETS to " in message, "the window says so, too", message)


def check_home(folder):
    """Without XDG_DATA_HOME the program uses ~/.local/share."""
    copy = place_program(folder, "bin")
    place = place_assets(folder / ".local" / "share" / "clearance")
    found = opened(copy, HOME=folder, XDG_DATA_DIRS="/nonexistent")
    check(found == place, "~/.local/share is the default of XDG_DATA_HOME", found)


def check_strange_folders(folder):
    """The program ignores folders next to it if it does not lie in a build folder."""
    copy = place_program(folder, "build", "app")
    place_assets(folder / "assets")
    check(opened(copy, XDG_DATA_DIRS="/nonexistent") is None, "without build.ninja it is no build folder")
    (folder / "build" / "build.ninja").write_text("")
    check(opened(copy, XDG_DATA_DIRS="/nonexistent") == folder / "assets", "with build.ninja it is one")
    if os.geteuid() == 0:
        os.chown(folder / "assets", 65534, 65534)
        check(opened(copy, XDG_DATA_DIRS="/nonexistent") is None, "somebody else's assets are not read")
        os.chown(folder / "assets", 0, 0)
        os.chown(folder / "build" / "build.ninja", 65534, 65534)
        check(opened(copy, XDG_DATA_DIRS="/nonexistent") is None, "with somebody else's build.ninja it is none")


def check_own(folder):
    """Profiles of a person and of a site stand beside the shipped ones, which win where names are equal."""
    shipped = json.loads((source / "assets" / "profiles" / "manual-chair.json").read_text())
    personal, site = folder / "own" / "clearance" / "profiles", folder / "site" / "clearance" / "profiles"
    plan = json.loads(pathlib.Path(house("straight-corridor")).read_text())
    for place, name in ((personal, "person-s-chair"), (site, "site-s-chair")):
        place.mkdir(parents=True)
        (place / f"{name}.json").write_text(json.dumps(shipped))
        (place / "manual-chair.json").write_text("{}")
        plan["people"][0]["profile"] = name
        (folder / f"{name}.house.json").write_text(json.dumps(plan))
    variables = {"XDG_DATA_HOME": folder / "own", "XDG_DATA_DIRS": folder / "site"}
    for name in ("person-s-chair", "site-s-chair"):
        done = ask(program, "check", folder / f"{name}.house.json", **variables)
        check(done.returncode == 0, f"{name} is found", done.stderr)
        done = ask(program, "check", folder / f"{name}.house.json")
        check(done.returncode == 2 and f"there is no {name}.json" in done.stderr, f"{name} is of these folders", done.stderr)
    check(ask(program, "check", house("straight-corridor"), **variables).returncode == 0, "a shipped name stays shipped")
    done = ask(program, "check", folder / "site-s-chair.house.json", CLEARANCE_ASSETS=source / "assets", **variables)
    check(done.returncode == 2, "with CLEARANCE_ASSETS there are no others", done.stderr)


def check_source_is_unknown():
    """The program's data contain no path of the source or of the build; debugging information does, but is not read."""
    words = subprocess.run(["strings", "-d", program], capture_output=True, text=True, check=True).stdout
    for path in (source, build):  # as a whole: /clearance does not occur in share/clearance
        check(not re.search(rf"(?<![\w%.~-]){re.escape(str(path))}(?![\w.-])", words), f"{path} is not compiled in")


def check_moved(folder):
    """An installed program still runs after its tree was moved, with the files that were installed with it."""
    subprocess.run(["meson", "install", "-C", build, "--no-rebuild", "--quiet", "--destdir", folder / "staged"], check=True,
                   capture_output=True)
    prefix = configured["prefix"].lstrip("/")
    tree = folder / "moved to" / "another place"
    tree.parent.mkdir()
    (folder / "staged" / prefix).rename(tree)
    copy, share = tree / configured["bindir"] / "clearance", tree / "share" / "clearance"
    done = ask(copy, "run", share / "houses" / "straight-corridor.json")
    check(done.returncode == 0, "a moved tree runs a house of its own", done.stderr)
    done = ask(copy, "run", share / "beams" / "ibs.json", "--set", "drive.frequency=290", "--quiet")
    check(done.returncode == 0, "and a beam", done.stderr)
    (share / "profiles" / "manual-chair.json").write_text("{}")
    check(opened(copy, XDG_DATA_HOME=folder) == share, "its profiles are those of the moved tree")


for part in (check_order, check_home, check_strange_folders, check_moved, check_own):
    with tempfile.TemporaryDirectory(prefix="clearance-assets-") as directory:
        part(pathlib.Path(directory).resolve())
check_source_is_unknown()
end()
