#!/usr/bin/env python3
"""Tests by a real pointer that the lengths beside what is dragged leave the signs of the picture readable."""

import itertools
import json
import math

import stage
from drawing import Plan
from stage import check


def overlap(a, b):
    return a[0] < b[2] - 0.5 and b[0] < a[2] - 0.5 and a[1] < b[3] - 0.5 and b[1] < a[3] - 0.5


screen = Plan("dragged", stage.house("bedroom-after-earthquake"), minutes=5, texts=True)
screen.until(lambda s: s["complete"] and not s["answer"]["stale"])
screen.drag(1.42, 3.43, 1.52, 3.33, release=False)
held, told = 0, 0
for step in range(12):
    screen.move(1.52 + 0.03 * step, 3.33 - 0.03 * step)
    state = screen.until(lambda s: not s["answer"]["stale"])
    signs = [t for t in state["text_in_view"] if t["kind"] != "name"]
    lengths = [t for t in screen.texts() if t["string"].endswith(" m") and t["string"][0].isdigit()
               and overlap(t["box"], state["frame"]["view"])]
    hidden = [(a["string"], b["string"]) for a, b in itertools.product(signs + lengths, lengths)
              if a != b and overlap(a["box"], b["box"])]
    check(not hidden, f"step {step}: no length lies over a sign or another length", hidden)
    held += "cannot pass" in state["answer"]["title"]
    told += len(lengths)
check(held >= 6 and told >= 36, "the chair is held, and lengths are told", (held, told))
screen.release()
screen.end()

# Escape during a drag: the clock, the chairs and the plan are as before, to the pixel
plan = json.loads(open(stage.house("ube-techno-house")).read())
door = next(door for door in plan["doors"] if door["id"] == "d7")
wall = next(wall for wall in plan["walls"] if wall["id"] == door["wall"])
(ax, ay), (bx, by) = wall["points"][door.get("segment", 0):][:2]
places = [f"at {ax + (bx - ax) * at / math.hypot(bx - ax, by - ay)} {ay + (by - ay) * at / math.hypot(bx - ax, by - ay)}"
          for at in (door["at"], door["at"] + 0.12)]
found = stage.act("cancelled", "until answered", "until idle", "key Ctrl+J", "pause", "seek 3", "wait 5", places[0], "press",
                  "release", "mouse 1278 718", "wait 5", "state STATE", "view FOLDER/before.png", places[0], "press", "wait 2",
                  places[1], "wait 60", "state STATE", "key Escape", "wait 2", "release", "mouse 1278 718", "wait 5",
                  "until answered", "until idle", "wait 5", "state STATE", "view FOLDER/after.png",
                  arguments=[stage.house("ube-techno-house")])
shots = [stage.folder / "cancelled" / f"{name}.png" for name in ("before", "after")]
check([state["gesture"]["active"] for state in found] == [False, True, False], "a door is dragged, and let go by Escape",
      [state["gesture"] for state in found])
check(found[2]["time"] == found[0]["time"] > 0 and stage.differing(*shots, fuzz="0%") == 0,
      "Escape leaves the moment as it was", ([state["time"] for state in found], stage.differing(*shots, fuzz="0%")))

# neither the frame nor the handles of what is selected hide why somebody cannot pass
things = ("door d4", "door d5", "bed", "desk")
found = stage.act("reason", "until answered", "until idle", "pause", "wait 5", "state STATE",
                  *[line for i, thing in enumerate(things) for line in (f'select "{thing}"', "wait 5", f"picture FOLDER/{i}.png")],
                  arguments=[stage.house("flat-0.910-module"), "--size", "1280x720"])
tags = [t["box"] for t in found[0]["text_in_view"] if t["string"].startswith("needs at least")]
check(len(tags) == 1, "the picture tells why somebody cannot pass", found[0]["text_in_view"])
for i, thing in enumerate(things):
    seen = stage.colours(stage.folder / "reason" / f"{i}.png", tags[0])
    dark = sum(count for count, colour in seen if max(colour) < 60)  # of frames, handles and walls
    check(dark < 20, f"{thing} is selected: nothing lies over the reason", dark)
stage.end()
