#!/usr/bin/env python3
"""Tests that the window survives random keys, clicks, drags, wheel steps, sizes and files, and still responds: check 25
of the window's conventions in a short form."""

import random
import re
import subprocess

import stage
from stage import act, check

table = (stage.source / "app" / "window" / "keys.c").read_text()
keys = [key.replace("\\\\", "\\") for key in re.findall(r'\{ACTION_\w+,\s*KEY_\w+,\s*"((?:[^"\\]|\\.)+)"', table)]
keys = [key for key in keys if key not in ("Ctrl+Q", "Shift+F9", "F9")] + ["Return", "Delete", "PageUp", "PageDown", "F6"]
files = [stage.house("corner-0.90-0.90"), stage.house("closed-door"), stage.beam("ibs-r"), stage.house("there-is-none"),
         str(stage.source / "README.md")]
sizes = ["800 600", "1280 720", "1024 600", "1920 1080"]


def quoted(words):
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"'


def anything(chance):
    x, y, other, down = (chance.randrange(limit) for limit in (1280, 720, 1280, 720))
    return chance.choice(
        [f"key {quoted(chance.choice(keys))}"] * 8 +
        [f"click {x} {y}", f"click {x} {y} double", f"click {x} {y} right", f"drag {x} {y} {other} {down}",
         f"wheel {chance.choice([-3, -1, 1, 2])}", f'type {quoted(chance.choice(["1.25", "abc", "1e400", "-", "0,9"]))}',
         "wait 3", f"seek {chance.uniform(0, 30):.2f}"] +
        ([f'open "{chance.choice(files)}"', f"resize {chance.choice(sizes)}"] if chance.random() < 0.2 else []))


for seed in range(2):
    chance = random.Random(seed)
    lines = [anything(chance) for _ in range(300)]
    found = act(f"random-{seed}", "until complete", *lines, "key Escape", "key Escape", "wait 5",
                f'open "{stage.house("corner-0.90-0.90")}"', "until complete", "state STATE")
    check(found and found[0]["answer"]["title"].startswith(("Out in", "All ", "The house", "p1 ")) and
          found[0]["sheet"] == "none", f"seed {seed}: it is alive and answers", found[0]["answer"] if found else "nothing")

# damaged settings or session files must not prevent opening
home = stage.folder / "broken-home" / "home"
for place, name in ((".config", "settings.json"), (".local/state", "state.json")):
    (home / place / "clearance").mkdir(parents=True)
    (home / place / "clearance" / name).write_text('{"theme": "pink", "width": -5, "recent": 3')
found = act("broken-home", "until complete", "state STATE")
check(found and found[0]["theme"] == "paper" and found[0]["messages"] >= 1, "broken settings are said, and put aside")

# without a display the program prints a sentence, with exit code 2
done = subprocess.run([stage.program, "open"], capture_output=True, text=True, timeout=600,
                      env=stage.environment(stage.folder / "nobody"))
check(done.returncode == 2 and done.stderr.count("\n") == 1 and "clearance run" in done.stderr,
      "without a display: one line that says what to do", done.stderr)

stage.end()
