#!/usr/bin/env python3
"""Tests that the window survives random keys, clicks, drags, wheel steps, sizes and files, and still responds: check 25
of the window's conventions in a short form."""

import json
import os
import pathlib
import random
import subprocess

import stage
from chance import anything
from stage import act, check

chance = random.Random(0)
found = act("random", "until complete", *[anything(chance) for _ in range(400)], "key Escape", "key Escape", "wait 5",
            f'open "{stage.house("corner-1.20-1.20")}"', "until complete", "state STATE")
check(found and found[0]["answer"]["title"].startswith(("Out in", "All ", "The house", "p1 ")) and
      found[0]["sheet"] == "none", "after random input it is alive and answers", found[0]["answer"] if found else "nothing")

# damaged settings or session files must not prevent opening
home = stage.folder / "broken-home" / "home"
for place, name in ((".config", "settings.json"), (".local/state", "state.json")):
    (home / place / "clearance").mkdir(parents=True)
    (home / place / "clearance" / name).write_text('{"theme": "pink", "width": -5, "recent": 3')
found = act("broken-home", "until complete", "state STATE")
check(found and found[0]["theme"] == "paper" and found[0]["messages"] >= 1, "broken settings are said, and put aside")

# pipes that nobody writes must not hold the window up: as a picture to trace, as settings, as a file, beside files
place = stage.folder / "pipes"
settings = place / "home" / ".config" / "clearance" / "settings.json"
settings.parent.mkdir(parents=True)
for pipe in (settings, place / "picture.png", place / "house.json"):
    os.mkfifo(pipe)
plan = json.loads(pathlib.Path(stage.house("corner-1.20-1.20")).read_text())
plan["background"] = {"image": "picture.png", "at": [0, 0], "width": 4}
(place / "traced.json").write_text(json.dumps(plan))
found = act("pipes", f'open "{place / "traced.json"}"', "until complete", "wait 5", "state STATE",
            f'open "{place / "house.json"}"', "wait 5", "key F4", "wait 20", "state STATE")
check(len(found) == 2 and "traced" in found[0]["file"], "a house whose picture to trace is a pipe is shown", found)
check(len(found) == 2 and found[1]["messages"] > found[0]["messages"], "a pipe that is opened is refused", found)

# a house whose people stand in each other is shown as a plan, and told in words that hold whatever was read
plan = json.loads(pathlib.Path(stage.house("flat-0.910-module")).read_text())
first = plan["people"][0]
plan["people"].append({**first, "id": "p2", "at": [first["at"][0] + 0.1, first["at"][1]]})
(stage.folder / "inside.json").write_text(json.dumps(plan))
found = act("inside", f'open "{stage.folder / "inside.json"}"', "until answered", "wait 5", "state STATE")
answer = found[0]["answer"] if found else {}
check(answer.get("title") == "This house cannot be run"
      and answer["detail"] == "person p2 stands inside person p1, must stand apart", "who stands where is told", answer)
named = [text["string"] for text in found[0]["text_in_view"]] if found else []
check({"p1", "p2", "bed", "EXIT"} <= set(named), "and the plan is seen", named)

# without a display the program prints a sentence, with exit code 2
done = subprocess.run([stage.program, "open"], capture_output=True, text=True, timeout=600,
                      env=stage.environment(stage.folder / "nobody"))
check(done.returncode == 2 and done.stderr.count("\n") == 1 and "clearance run" in done.stderr,
      "without a display: one line that says what to do", done.stderr)

stage.end()
