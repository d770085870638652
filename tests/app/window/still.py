#!/usr/bin/env python3
"""Tests what stands still (checks 2, 11 and 30 of the calm window) with real keys, at two sizes: while a house is played, no
text, plot or pane moves, except for people, the clock and the tips of curves; a quick answer comes without a ring; a window
that is made larger shows more."""

import json

import stage
from stage import Screen, check

FRAMES = 100
LEAST = 20


def lines(path, begin):
    """Returns the states in a file after so many bytes."""
    with open(path, "rb") as file:
        file.seek(begin)
        whole = file.read().rpartition(b"\n")[0]
    return [json.loads(line) for line in whole.split(b"\n") if line]


def size_of(path):
    return path.stat().st_size


def is_person(text):
    return text["kind"] == "disc" and text["string"].isalpha()


def moved(before, now):
    """Returns the strings of which one state has other places than the other."""
    return {t for t in set(before) ^ set(now)}


def placed(texts):
    """Returns the texts with their places, to a pixel."""
    return {(t["string"], *(round(v) for v in t["box"])) for t in texts if t["string"].strip()}


for width, height in ((1280, 720), (1920, 1080)):
    size = f"{width} x {height}"
    screen = Screen(f"still-{height}", stage.house("ube-techno-house"), width=width, height=height, minutes=20, texts=True)
    screen.until(lambda s: s["complete"] and not s["answer"]["stale"] and not s["answer"]["grading"])
    screen.point_to(width - 2, height - 2)
    screen.keys("r")
    screen.until(lambda s: s["playing"] and s["time"] > 3.2 and not s["said"])
    begin, texts_begin = size_of(screen.log), size_of(screen.place / stage.TEXTS)
    count = screen.log_count
    screen.until(lambda s: screen.log_count >= count + FRAMES + 4)
    states, texts = lines(screen.log, begin)[1:FRAMES], lines(screen.place / stage.TEXTS, texts_begin)[1:FRAMES]
    # on a busy machine the run ends before so many frames are drawn; a line of texts may belong to the next state
    playing = sum(s["playing"] for s in states)
    states, texts = states[:playing], texts[:max(playing - 1, 1)]
    check(playing >= LEAST, f"30: {size}: it is seen to run", playing)
    first, last = states[0], states[-1]
    check(last["time"] > first["time"], f"30: {size}: it runs", (first["time"], last["time"]))
    labels = [placed([t for t in s["text_in_view"] if not is_person(t)]) for s in states]
    check(all(shown == labels[0] for shown in labels), f"30: {size}: no label of the plan moves, comes or goes",
          [moved(labels[0], shown) for shown in labels if shown != labels[0]][:2])
    check(all(s["frame"] == first["frame"] for s in states), f"30: {size}: no pane moves")
    axes = [{name: (chart["x"], chart["y"], placed(chart["texts"])) for name, chart in s["charts"].items()} for s in states]
    check(all(shown == axes[0] for shown in axes), f"30: {size}: no axis and no text of a plot moves", axes[0].keys())
    track = first["frame"]["timeline"]
    rest = [placed([t for t in shown if not (track[1] <= t["box"][1] and t["box"][3] <= track[3])]) for shown in texts]
    check(all(shown == rest[0] for shown in rest), f"30: {size}: no other text moves, comes or goes",
          [moved(rest[0], shown) for shown in rest if shown != rest[0]][:2])
    clocks = [{(t[0], t[1]) for t in placed(shown) if t[0].endswith(" s")} for shown in texts]
    lefts = {left for clock in clocks for _, left in clock}
    check(len(lefts) <= 1 + max(len(clock) for clock in clocks), f"30: {size}: the clock counts at its place", sorted(lefts))
    screen.end()

# 11: a quick answer: the one before holds, then the new one stands
screen = Screen("quick", stage.house("closed-door"), minutes=20)
screen.until(lambda s: s["complete"] and not s["answer"]["stale"])
screen.keys("space", "Tab")
greys = []
for turn in range(12):
    begin, digest = size_of(screen.log), screen.state()["runs"]["answer"]
    screen.keys("Right" if turn % 2 == 0 else "Left")
    screen.until(lambda s: s["complete"] and not s["answer"]["stale"] and s["runs"]["answer"] != digest, patience=30)
    seen = lines(screen.log, begin)
    rings = sum(s["answer"]["grey"] or bool(s["answer"]["doing"]) for s in seen)
    greys.append((rings, sum(s["answer"]["stale"] for s in seen)))
    check(all(len(set(s["runs"][part] for part in ("answer", "picture", "rows", "plots"))) == 1 for s in seen),
          f"11: edit {turn + 1}: each frame is of one run")
check(min(greys)[0] == 0, "11: a quick answer comes without a ring", greys)
print("     frames with a ring, frames that wait:", greys)
screen.end()

# 2: a window that is made larger shows more
screen = Screen("grown", width=1920, height=1080, whole=False)
screen.tool("windowsize", screen.window, 1280, 720)
small = screen.until(lambda s: s["width"] == 1280 and s["complete"] and not s["answer"]["stale"])
screen.keys("space")
small = screen.state()
screen.tool("windowsize", screen.window, 1920, 1080)
screen.until(lambda s: s["width"] == 1920 and s["height"] == 1080)
large = screen.until(lambda s: s["frame"]["plots"] and abs(s["unit"] - 1.22) < 0.01)
view = large["frame"]["view"]
check(large["frame"]["plots"] and not small["frame"]["plots"], "2: plots come with the size",
      (small["frame"]["plots"], large["frame"]["plots"]))
check(view[2] - view[0] >= 0.5 * 1920 and abs(large["unit"] - 1.22) < 0.01, "2: the view keeps half the width, letters grow to 1.22",
      (view, large["unit"]))
large = screen.state()
check(len(large["text_in_view"]) > len(small["text_in_view"]), "2: and more is named",
      (len(large["text_in_view"]), len(small["text_in_view"])))
screen.end()
stage.end()
