#!/usr/bin/env python3
"""Tests both laboratories in the window: playing, scrubbing, changing numbers, switching, pictures, sizes; checks 8,
22, 23 and 24 of the window's conventions, and that the digest equals the one without a window."""

import csv
import json
import math
import subprocess

import stage
from stage import act, check, differing

corner = stage.house("corner-0.90-0.90")


def headless(path, *more):
    done = subprocess.run([stage.program, "run", path, "--json", "--quiet", *more], capture_output=True, text=True)
    return json.loads(done.stdout)


# 3. the digest does not depend on actions during playback
digest = headless(corner)["digest"]
found = act("digest", "play", "wait 20", "seek 3", "wait 5", "speed 16", "wait 10", "pause", "seek 0.4", "play",
            "until complete", "state STATE", "seek 9", "wait 3", "seek 1", "wait 3", "state STATE",
            "pause", "seek 0", "wait 3", "set profile.manual-chair.body.width 0.6", "until answered", "wait 5",
            "state STATE", "key Alt+R", "until answered", "wait 5", "state STATE", arguments=[corner])
for i, what in ((0, "played and scrubbed"), (1, "scrubbed after its end"), (3, "reset after a change")):
    check(found[i]["digest"] == digest, f"the digest of a run that was {what} is the headless one",
          (found[i]["digest"], digest))
changed = headless(corner, "--set", "profile.manual-chair.body.width=0.6")["digest"]
check(found[2]["digest"] == changed and changed != digest, "a changed number gives the run with that number")
check("--set profile.manual-chair.body.width=0.6" in found[2]["command"], "the command says so", found[2]["command"])

# 8. a time looks the same however it was reached
found = act("scrub", "until complete", "pause", "seek 4", "wait 3", "view FOLDER/one.png", "seek 9.5", "wait 3",
            "seek 0", "wait 3", "seek 4", "wait 3", "view FOLDER/two.png", "seek 3", "wait 2", "seek 3.5", "wait 2",
            "seek 4", "wait 2", "view FOLDER/three.png", "seek 8", "wait 2", "view FOLDER/late.png")
place = stage.folder / "scrub"
check(differing(place / "one.png", place / "two.png", fuzz="0%") == 0, "back and on again: the same picture")
check(differing(place / "one.png", place / "three.png", fuzz="0%") == 0, "in steps: the same picture")
check(differing(place / "one.png", place / "late.png") > 500, "another moment is another picture")

# errors are reported in the window, and the last valid state stays
broken = stage.folder / "broken.json"
broken.write_text('{"format": "clearance-house", "version": 1, "wals": []}')
found = act("broken", "until complete", f'open "{broken}"', "wait 5", "state STATE",
            "set door.d4.width 9", "wait 5", "state STATE", "set door.d4.at 99", "wait 5", "until idle", "state STATE")
check("ube" in found[0]["file"] and "broken.json:1:" in (found[0]["message"] or ""), "a broken file is said, the house stays",
      found[0]["message"])
other = stage.folder / "other.json"
other.write_text('{"format": "clearance-house", "version": 1,\n "exists": []}')
said = act("two-broken", "until complete", f'open "{broken}"', "wait 5", f'open "{other}"', "wait 5", "state STATE")[0]["message"]
check("other.json:" in (said or ""), "of two broken files the last one is said", said)
check(found[1]["parameters"]["door.d4.width"] == 0.9, "a width out of range changes nothing", found[1]["message"])
check(found[2]["answer"]["title"].startswith("All 4 get out") and found[2]["messages"] > found[1]["messages"],
      "a door past its wall's end is said, the last good state stays", found[2]["message"])

# keys of the view: selection, zoom, oblique, follow, layers, presentation, theme, text size
found = act("looks", "until complete", "pause", "wait 2", "state STATE", "key Tab", "wait 2", "state STATE",
            "key Z", "wait 2", "state STATE", "key Escape", "key Home", "key V", "key E", "wait 2", "state STATE",
            "picture FOLDER/raised.png", "key V", "key F", "wait 2", "state STATE", "key Home", "key F5", "wait 2",
            "state STATE", "picture FOLDER/present.png", "key F5", "key Ctrl+T", "wait 2", "state STATE",
            "picture FOLDER/board.png", "key Ctrl+=", "key Ctrl+=", "wait 2", "state STATE", "key Ctrl+0", "wait 2")
check(not found[0]["selected"] and found[1]["selected"], "Tab selects", found[1]["selected"])
check(found[2]["zoom"] > 2, "Z goes near to it", found[2]["zoom"])
check(found[3]["raised"] and found[3]["azimuth"] == 25, "V raises, E turns by 15 degrees", found[3]["azimuth"])
check(found[4]["follows"], "F follows")
check(found[5]["present"], "F5 presents")
check(found[6]["theme"] == "board", "Ctrl+T is the board")
check(found[7]["text"] == 1.5, "letters grow in steps of a quarter", found[7]["text"])

# V says whose view cannot be raised
for laboratory in ("beam", "crank"):
    found = act(f"flat-{laboratory}", f"laboratory {laboratory}", "key V", "wait 2", "state STATE")
    check(found[0]["said"] == f"A {laboratory} has no raised view.", f"{laboratory}: V says that it stays flat",
          found[0]["said"])

# 22. at twice the size, and in a small window: parts do not overlap, and the answer comes first
for width, height, text in ((1280, 720, 1), (1024, 600, 1), (1280, 720, 2), (1024, 600, 2), (1920, 1080, 3), (3840, 2160, 1)):
    for laboratory in ("house", "beam"):
        found = act(f"size-{width}-{text}-{laboratory}", f"laboratory {laboratory}", "until answered", "wait 3",
                    "state STATE", "picture FOLDER/window.png",
                    arguments=["--size", f"{width}x{height}", "--text", str(text)])
        frame = found[0]["frame"]
        boxes = [frame[name] for name in ("menu", "answer", "view", "timeline", "strip")] + list(frame["plots"].values())
        boxes = [b for b in boxes if b[2] - b[0] > 1 and b[3] - b[1] > 1]
        apart = all(a is b or a[0] > b[2] - 1 or b[0] > a[2] - 1 or a[1] > b[3] - 1 or b[1] > a[3] - 1
                    for a in boxes for b in boxes)
        inside = all(b[0] >= 0 and b[1] >= 0 and b[2] <= found[0]["width"] + 1 and b[3] <= found[0]["height"] + 1 for b in boxes)
        check(apart and inside, f"{laboratory}, {width} x {height}, letters x {text}: nothing overlaps", boxes)
        check(found[0]["width"] == width, "the window is as large as asked for", found[0]["width"])

# 23. the beam: a click on the orbit diagram, boxes by keys, values that persist
found = act("beam", "laboratory beam", "until answered", "state STATE")
orbit, axes = found[0]["frame"]["plots"]["orbit"], found[0]["charts"]["orbit"]["x"]
x, y = orbit[0] + 0.6 * (orbit[2] - orbit[0]), (orbit[1] + orbit[3]) / 2
found = act("orbit", "laboratory beam", "until answered", f"click {x:.0f} {y:.0f}", "wait 10", "state STATE",
            "key Left", "key Left", "wait 2", "state STATE", "key Return", "wait 10", "state STATE",
            "key Z", *["key Right"] * 10, "key Return", *["key Right"] * 10, *["key Up"] * 5, "key Return", "wait 3", "state STATE",
            "wait 60", "state STATE", "key Backspace", "wait 2", "state STATE", "key X", "key K", "wait 5", "state STATE")
clicked = found[0]["parameters"]["drive.frequency"]
check(axes[0] < clicked < axes[1] and abs(clicked - found[0]["charts"]["orbit"]["cursor"]) < 1e-6,
      "a click on the orbit diagram sets the frequency, and the cursor stands there", clicked)
pixel = (axes[1] - axes[0]) / (orbit[2] - orbit[0] - 60)
check(found[1]["parameters"]["drive.frequency"] < clicked and
      abs(found[1]["parameters"]["drive.frequency"] - found[1]["charts"]["orbit"]["cursor"]) < 1e-6,
      "arrows move the cursor and its number", (found[1]["parameters"]["drive.frequency"], found[1]["charts"]["orbit"]))
check(found[2]["parameters"]["drive.frequency"] == found[1]["parameters"]["drive.frequency"], "Return changes nothing",
      found[2]["parameters"]["drive.frequency"])
check(found[3]["charts"]["orbit"]["views"] == 1 and found[3]["charts"]["orbit"]["x"] != axes, "Z zooms to a box by keys")
check(found[4]["charts"]["orbit"]["x"] == found[3]["charts"]["orbit"]["x"], "axes that were chosen stay while it runs")
check(found[5]["charts"]["orbit"]["x"] == axes, "Backspace goes back", found[5]["charts"]["orbit"]["x"])
check(found[0]["end"] > 0 and found[6]["end"] > found[0]["end"], "the beam goes on all the while")

# a running beam changes from period 1 to chaos; scrubbing back shows the earlier beam
found = act("chaos", "laboratory beam", "set drive.frequency 190", "until answered", "speed 256", "wait 200", "state STATE",
            "set drive.frequency 300", "until answered", "wait 200", "state STATE", "speed 1", "pause", "key Shift+Tab", "wait 2", "state STATE")
check(found[0]["answer"]["title"] == "Every cycle alike", "190 Hz is periodic", found[0]["answer"])
check("haotic" in found[1]["answer"]["title"], "300 Hz is chaotic", found[1]["answer"])
check(found[1]["end"] > found[0]["end"] + 0.5, "hundreds of cycles have passed", (found[0]["end"], found[1]["end"]))

# 24. pictures and the files next to them
found = act("picture", "until complete", "pause", "seek 5", "wait 3", "key F9", "wait 5", "state STATE", "key Shift+P", "wait 5",
            "click 800 230", "wait 2",
            "key F9", "wait 5", "state STATE", "key F9", "wait 5", "key Ctrl+C", "wait 2", "state STATE")
made = stage.folder / "picture" / "home" / "clearance"
names = sorted(p.name for p in made.iterdir()) if made.is_dir() else []
check(len([n for n in names if n.endswith(".png")]) == 3 and len([n for n in names if n.endswith(".svg")]) == 3,
      "F9 writes PNG and SVG of the view and of the plot with the focus", names)
notes = [json.loads((made / n).read_text()) for n in names if n.endswith(".json")]
check(notes and all("clearance" in json.dumps(note) for note in notes), "with the command beside them", notes[:1])
tables = [n for n in names if n.endswith(".csv")]
rows = list(csv.reader(open(made / tables[0]))) if tables else []
check(tables and "[s]" in rows[0][0] and len(rows) > 100, "a plot's CSV has units in its header", rows[:1])
pngs = [made / n for n in names if n.endswith(".png")]
check(len(pngs) == 3 and pngs[1].read_bytes() == pngs[2].read_bytes() or pngs[0].read_bytes() == pngs[1].read_bytes(),
      "the same picture twice is the same bytes")
check("Copied: clearance run" in found[2]["message"], "Ctrl+C copies the command", found[2]["message"])

# the question about unsaved edits concerns the shown tab, which no key changes meanwhile
found = act("leave", "until complete", "set door.d4.width 0.85", "until complete", "key Ctrl+Q", "wait 4", "key F3", "wait 4",
            "state STATE")
check(found[-1]["sheet"] == "leave" and found[-1]["laboratory"] == "house", "no key leaves the tab that is asked about",
      (found[-1]["sheet"], found[-1]["laboratory"]))

# a copy has the changed numbers and never overwrites another file
mine = stage.folder / "mine.json"
mine.write_text("mine")
found = act("save", "until complete", "set door.d4.width 0.85", "until complete", "key Ctrl+S", "wait 4", "key Return",
            "wait 10", "state STATE", "key Ctrl+Shift+S", "wait 4", "key Ctrl+A", f'type "{mine}"', "wait 2", "key Return",
            "wait 6", "state STATE")
path = found[0]["message"].partition(": ")[2]
saved = json.loads(open(path).read())
check([d["width"] for d in saved["doors"] if d["id"] == "d4"] == [0.85], "Ctrl+S saves a copy with the changed number")
check(mine.read_text() == "mine" and f"{mine} already exists" in found[1]["message"], "never over another file",
      found[1]["message"])

stage.end()
