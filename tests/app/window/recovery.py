#!/usr/bin/env python3
"""Tests that no edit is lost: the program is killed at random moments, its recovery file always opens, and the edited
file is unchanged."""

import json
import pathlib
import random
import shutil
import signal
import subprocess
import time

import stage
from stage import act, check, environment, folder, program

place = folder / "killed"
place.mkdir()
home = place / "home"
kept = home / ".local" / "state" / "clearance" / "recovery"
house = place / "mine.json"
plan = json.loads(pathlib.Path(stage.house("closed-door")).read_text())
plan["people"][0]["profile"] = "own-chair"  # it lies in the same folder as the house
house.write_text(json.dumps(plan))
shutil.copy(stage.source / "assets" / "profiles" / "manual-chair.json", place / "own-chair.json")
original = house.read_bytes()
random.seed(7)


def left():
    return sorted(kept.glob("*.json")) if kept.exists() else []


def written(path):
    """Returns a value that changes each time the file is written."""
    try:
        return path, path.stat().st_mtime_ns
    except FileNotFoundError:  # the file is being replaced
        return path, 0


def opens(path):
    """Checks a copy of the file in the folder of its profile; returns whether it is a valid house, and the errors."""
    shutil.copy(path, place / "left.json")
    done = subprocess.run([program, "check", str(place / "left.json")], capture_output=True, text=True, timeout=600)
    return done.returncode != 2, done.stderr


def edit_and_kill(writes, seconds):
    """Edits repeatedly and waits after each edit until it is written; kills the program `seconds` after the given
    number of writes."""
    lines = [f'open "{house}"', "wait 5"]
    for i in range(12):
        lines += [f"set door.d1.width {0.8 + 0.01 * i:.2f}", "wait 2000"]
    script = place / "script"
    script.write_text("\n".join(lines) + "\nwait 10000\n")
    seen = {written(path) for path in left()}
    window = subprocess.Popen([program, "open", "--size", "640x400", "--script", str(script)], cwd=place,
                              stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              env=environment(home, SDL_VIDEODRIVER="offscreen"))
    begun = time.monotonic()
    while writes and window.poll() is None and time.monotonic() - begun < 300:
        new = {written(path) for path in left()} - seen
        seen |= new
        writes -= bool(new)
        time.sleep(0.01)
    time.sleep(seconds)  # at any moment
    window.send_signal(signal.SIGKILL)
    window.wait()


turns, whole, found = 5, 0, 0
for turn in range(turns):
    edit_and_kill(turn % 3 + 1, random.uniform(0, 0.5))
    for path in left():
        found += 1
        good, words = opens(path)
        whole += good
        check(good, f"killed at a random moment (turn {turn + 1}), what is left opens", words)
check(found > turns and whole == found, "killed again and again, something is left each time that it had been written",
      (found, whole))
check(house.read_bytes() == original, "the file itself is as it was")

# the next start offers the recovery file, and opens it as unsaved
newest = max(left(), key=lambda path: path.stat().st_mtime)
shutil.rmtree(folder / "next", ignore_errors=True)
(folder / "next").mkdir()
shutil.copytree(home, folder / "next" / "home")
there = sorted((folder / "next" / "home" / ".local" / "state" / "clearance" / "recovery").glob("*.json"))
seen = act("next", "wait 20", "state STATE", "picture FOLDER/sheet.png", "key Tab", "key Shift+Tab", "key Return",
           "until answered", "state STATE", "picture FOLDER/opened.png")
check(seen and seen[0]["sheet"] == "recovered", "the next start asks about it", seen[0]["sheet"] if seen else None)
check(len(seen) > 1 and seen[1]["shown_title"].endswith("[Recovered]") and seen[1]["unsaved"] and not seen[1]["file"],
      "opened, it says that it is recovered, and is not saved", seen[1]["shown_title"] if len(seen) > 1 else None)
check(len(seen) > 1 and "cannot be run" not in seen[1]["answer"]["title"], "what lies beside the file itself is found",
      seen[1]["answer"] if len(seen) > 1 else None)

# a normal exit leaves no recovery file
act("clean", f'open "{house}"', "set door.d1.width 0.85", "wait 200", "state STATE")
rest = folder / "clean" / "home" / ".local" / "state" / "clearance" / "recovery"
check(not list(rest.glob("*")), "a clean end leaves nothing behind", list(rest.glob("*")))

stage.end()
