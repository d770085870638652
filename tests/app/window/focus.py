#!/usr/bin/env python3
"""Tests the keyboard alone: checks 6 (an open field), 20 and 21 of the window's conventions, each key of the card."""

import re
import subprocess

import stage
from stage import act, check, differing

# 21. the focus visits all controls and returns, and is always framed
tabs = []
for i in range(100):
    tabs += ["key Tab", "wait 2", "state STATE"] + ([f"picture FOLDER/tab-{i}.png"] if i % 4 == 0 else [])
found = act("tabs", "until complete", "pause", "wait 3", "picture FOLDER/none.png", *tabs,
            arguments=[stage.house("corner-0.90-0.90"), "--size", "1920x1080"])
panes = [state["focus"] for state in found]
for pane in ("view", "plot:speed", "plot:clearance", "panel", "timeline", "menu", "answer"):
    check(pane in panes, f"Tab comes to {pane}", sorted(set(panes)))
first = stage.folder / "tabs" / "none.png"
for i in range(0, 100, 4):
    picture = stage.folder / "tabs" / f"tab-{i}.png"
    check(differing(first, picture) > 50, f"after {i + 1} Tabs a frame is seen")
found = act("panes", "until complete", "key Shift+P", "wait 2", *(["key F6", "wait 2", "state STATE"] * 12))
panes = [state["focus"] for state in found]
check(len(set(panes)) >= 6 and panes[0] in panes[1:], "F6 goes round all panes", panes)
back = act("panes-back", "until complete", "key Shift+P", "wait 2", *(["key Shift+F6", "wait 2", "state STATE"] * 12))
check(set(state["focus"] for state in back) == set(panes), "and Shift+F6 back", panes)

# Escape closes any open menu or dialog, but never the window
for key, sheet in (("F1", "keys"), ("F4", "gallery"), ("F7", "messages"), ("F10", "menu"), ("Ctrl+O", "open"),
                   ("Ctrl+E", "export"), ("Ctrl+S", "save"), ("Shift+F1", "explain"), ("Ctrl+I", "about")):
    found = act(f"sheet-{sheet}", "until complete", f"key {key}", "wait 4", "state STATE", "picture FOLDER/open.png",
                "key Escape", "wait 2", "key Escape", "wait 2", "state STATE")
    check(found[0]["sheet"] == sheet, f"{key} opens {sheet}", found[0]["sheet"])
    check(found[1]["sheet"] == "none", f"Escape closes {sheet}", found[1]["sheet"])

# no key of the table breaks the program, in both laboratories
table = (stage.source / "app" / "window" / "keys.c").read_text()
keys = re.findall(r'\{ACTION_\w+,\s*KEY_\w+,\s*"((?:[^"\\]|\\.)+)"', table)
check(len(keys) > 90, "the table has keys", len(keys))
keys = [key.replace("\\\\", "\\") for key in keys if key not in ("Ctrl+Q", "Shift+F9")]
for laboratory, focus in (("house", "view"), ("house", "plot"), ("beam", "timeline")):
    steps = {"view": 0, "plot": 1, "timeline": 3}[focus]
    opened = ["key Shift+P", "wait 2"] if laboratory == "house" else []  # a beam's plots are open at first
    lines = [f"laboratory {laboratory}", "until answered", "wait 5", *opened, *(["key F6", "wait 1"] * steps)]
    for key in keys:
        quoted = '"' + key.replace("\\", "\\\\") + '"'
        lines += [f"key {quoted}", "wait 1", "key Escape", "wait 1"]
    found = act(f"all-keys-{laboratory}-{focus}", *lines, "state STATE")
    check(found and found[0]["sheet"] == "none", f"{laboratory}, {focus}: every key of the card was pressed")

# 6. Alt+K while a field is open starts or pauses playback and keeps the typed text
found = act("field", "until complete", "pause", "key Ctrl+O", "wait 3", "type abc", "wait 2",
            "state STATE", "key Alt+K", "wait 2", "state STATE", "picture FOLDER/field.png")
check(found[0]["types"] and found[1]["types"], "a field is open, before and after", found[0])
check(found[1]["playing"], "Alt+K plays while it is")

# 7. Return on a selection goes to its numbers or texts, not to a button for somebody who is blocked
found = act("blocked", "until answered", "until idle", "pause", "at 1.79 6.04", "press", "release", "wait 3", "key Return", "wait 5",
            "state STATE", arguments=[stage.house("flat-0.910-module")])
check(found[0]["focus"] == "panel" and (found[0]["focus_help"] or "").startswith(("name", "place")),
      "7: Return on a selection goes to its first number or text", (found[0]["focus"], found[0]["focus_help"]))

# a benchmark tells how busy the machine was, and takes no picture in which nothing moves for a moving one
done = subprocess.run([stage.program, "open", stage.house("corner-1.20-1.20"), "--benchmark-window", "0.2"], text=True,
                      capture_output=True, timeout=600,
                      env=stage.environment(stage.folder / "busy", SDL_VIDEODRIVER="offscreen"))
check(re.search(r"used [0-9.]+ of [0-9]+ processors, load [0-9.]+$", done.stdout.strip()), "a benchmark says how busy the machine was",
      done.stdout + done.stderr)
check(re.search(r"\n[0-9.]+ frames/s while the view is moved", done.stdout), "and those in which the view is moved",
      done.stdout + done.stderr)
check(re.search(r"the first that moves after [0-9.]+ s, [0-9.]+ frames/s while something moves", done.stdout),
      "and counts the frames in which something moves", done.stdout + done.stderr)

# 20. texts that are not numbers
name = "profile.manual-chair.width"
for words in ("abc", "9e99", "-1", "", "1e400", "1,2,3", "nan", "0.6 kg"):
    found = act("number-" + "".join(c for c in words if c.isalnum()), "until complete", "pause", "key Tab", "wait 2", "key Return", "wait 2", "state STATE", "key Return", "wait 2", "key Ctrl+A",
                f'type "{words}"' if words else "key Delete", "wait 2", "key Return", "wait 3", "state STATE", "picture FOLDER/wrong.png", "key Escape", "wait 2",
                "key Escape", "wait 2", "state STATE", arguments=[stage.house("corner-1.20-1.20")])
    check(found[1]["parameters"] == found[0]["parameters"], f"{words!r} is no number: nothing has changed")
    check(not found[2]["types"], f"{words!r}: Escape takes it back")

stage.end()
