#!/usr/bin/env python3
"""Tests what the window survives (check 25 of the window's conventions) with a real mouse and real keys: a kill, broken files,
other sizes, a shake that nobody's eyes must follow, and random input.

endure.py CLEARANCE [ACTIONS]"""

import json
import random
import subprocess
import sys
import time

import stage
from drawing import Plan
from stage import Screen, check

ACTIONS = int(sys.argv[2]) if len(sys.argv) > 2 else 150
SHOTS = 60
FLASHES_MOST = 3  # a second


def settle(screen):
    return screen.until(stage.is_settled)


# killed after an edit, the next start offers it, and the file is as it was
house = stage.folder / "mine.json"
house.write_text(open(stage.house("closed-door")).read())
original = house.read_bytes()
lost = Plan("lost", house)
settle(lost)
lost.keys("space", "Tab", "Right")
settle(lost)
lost.until(lambda s: s["unsaved_edits"] == 1)
place = lost.state()["parameters"]
lost.crash()
check(house.read_bytes() == original, "25: killed, the file is as it was")
lost = Plan("lost", minutes=20)
state = lost.until(lambda s: s["sheet"] == "recovered")
check(state["sheet"] == "recovered", "25: the next start offers what was lost", state["sheet"])
lost.keys("Return")
lost.until(lambda s: s["sheet"] == "none")
state = settle(lost)
check(state["parameters"] == place and state["unsaved"] and house.read_bytes() == original,
      "25: it has the edit, is not saved, and the file is as it was", state["shown_title"])

lost.save_as(lost.place / "kept.json")

# a broken file: all its faults by line and column, and the house that was open stays
broken = stage.folder / "broken.json"
broken.write_text('{"format": "clearance-house", "version": 1,\n "wals": [],\n "exits": [{"id": "e"}]}\n')
lost.keys("ctrl+o")
lost.until(lambda s: s["sheet"] == "open")
lost.keys("ctrl+a")
lost.type(str(broken))
lost.keys("Return")
state = lost.until(lambda s: s["sheet"] == "messages")
told = subprocess.run([stage.program, "check", broken], capture_output=True, text=True, timeout=600).stderr
faults = [line[line.index("broken.json:"):] for line in told.splitlines() if "broken.json:" in line]
check(len(faults) >= 3 and state["faults"] == len(faults), "25: a broken file: all faults are told", (state["faults"], faults))
check(all(any(fault[12:].split(" ")[0] in line for fault in faults) for line in faults), "25: by line and column", faults)
lost.keys("Escape")
check(lost.state()["parameters"] == place, "25: and what was open stays")
for _ in faults:
    lost.keys("Escape")
lost.end()

# from one size to the next, the parts lie beside one another and in the window
sizes = Screen("sizes", stage.house("ube-techno-house"), width=1920, height=1080, whole=False, minutes=20)
settle(sizes)
for width, height in ((800, 600), (1024, 600), (1920, 1080), (1280, 720), (800, 1080), (1920, 600)):
    sizes.tool("windowsize", sizes.window, width, height)
    sizes.until(lambda s: (s["width"], s["height"]) == (width, height))
    frame = sizes.state()["frame"]
    boxes = [frame[name] for name in ("menu", "answer", "view", "timeline", "strip")] + list(frame["plots"].values())
    boxes = [b for b in boxes if b[2] - b[0] > 1 and b[3] - b[1] > 1]
    apart = all(a is b or a[0] > b[2] - 1 or b[0] > a[2] - 1 or a[1] > b[3] - 1 or b[1] > a[3] - 1 for a in boxes for b in boxes)
    inside = all(-1 <= b[0] and -1 <= b[1] and b[2] <= width + 1 and b[3] <= height + 1 for b in boxes)
    check(apart and inside and frame["view"][2] - frame["view"][0] > 0.4 * width, f"25: resized to {width} x {height}", frame)
sizes.end()


def luminance(path):
    """Returns a small grey copy of a picture."""
    return subprocess.run(["convert", str(path), "-resize", "320x180!", "-colorspace", "gray", "-depth", "8", "gray:-"],
                          capture_output=True, timeout=600).stdout


# with --reduced-motion nothing flashes while the house shakes, and the panel stands still
calm = Screen("shaken", stage.house("ube-techno-house"), "--reduced-motion", minutes=20)
settle(calm)
calm.keys("space", "Home")
calm.point_to(1278, 718)
begun = time.monotonic()
calm.keys("shift+t")
panel = calm.state()["frame"]["panel"]
paths = [calm.shot(f"shake-{i}") for i in range(SHOTS)]
took = time.monotonic() - begun
pictures = [luminance(path) for path in paths]
turns = [0] * len(pictures[0])
last = [0] * len(pictures[0])
for a, b in zip(pictures, pictures[1:]):
    if a == b:
        continue
    for i, (p, q) in enumerate(zip(a, b)):
        if abs(q - p) > 25 and (q > p) != (last[i] > 0):
            turns[i] += 1
            last[i] = q - p
check(max(turns) / 2 <= FLASHES_MOST * took, "25: with --reduced-motion nothing flashes", (max(turns), took))
settled = [stage.differing(a, b, panel, "0%") for a, b in zip(paths[-10:], paths[-9:])]
check(not any(settled), "25: and the panel stands still", settled)
check(calm.state()["animation"] is None, "25: what falls lies at once", calm.state()["animation"])
calm.end()

# random keys, clicks and drags: it is alive, saves and opens again
chance = random.Random(25)
KEYS = ["space", "Tab", "Return", "Escape", "Delete", "Left", "Right", "Up", "Down", "Home", "End", "F1", "F2", "F3", "F4", "F5", "F6",
        "F7", "F8", "F10", "period", "comma", "bracketleft", "bracketright", "ctrl+z", "ctrl+y", "ctrl+a", "ctrl+c", "ctrl+v", "ctrl+d",
        "ctrl+e", "ctrl+o", "ctrl+t", "ctrl+j", "alt+k", "alt+r", "shift+p", "shift+t", *"wdopxmabrtkgchv123456789qen"]
wild = Plan("wild", house, minutes=20)
settle(wild)
for _ in range(ACTIONS):
    if wild.program.poll() is not None:
        break
    kind = chance.random()
    if kind < 0.6:
        wild.keys(chance.choice(KEYS))
    elif kind < 0.9:
        wild.click(chance.randrange(1270), chance.randrange(40, 700))
    else:
        wild.point_to(chance.randrange(10, 960), chance.randrange(100, 600))
        wild.press()
        wild.point_to(chance.randrange(10, 960), chance.randrange(100, 600))
        wild.release()
check(wild.program.poll() is None, f"25: after {ACTIONS} random actions it is alive")
wild.keys("Escape", "Escape", "Escape", "Escape")
copy = wild.place / "copy.json"
if wild.state()["present"]:
    wild.keys("F5")
wild.keys("F2", "Escape", "Escape", "Escape")
wild.save_as(copy)
check(copy.exists() and json.loads(copy.read_text())["format"] == "clearance-house", "25: it saves")
wild.keys("ctrl+o")
wild.until(lambda s: s["sheet"] == "open")
wild.keys("ctrl+a")
wild.type(stage.house("corner-0.90-0.90"))
wild.keys("Return")
state = wild.until(lambda s: "corner" in (s["file"] or "") and s["complete"] and not s["answer"]["stale"])
check(state["answer"]["title"].startswith("Out in "), "25: and opens and answers", state["answer"])
wild.end()
stage.end()
