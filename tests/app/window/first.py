#!/usr/bin/env python3
"""Tests the window as at first use: checks 1 to 9 of the window's conventions, with a real mouse and keyboard."""

import time

import stage
from stage import check, contrast, differing

screen = stage.Screen("first")


def play(wanted):
    """Starts or pauses playback, which may have stopped at the end of the record."""
    for _ in range(10):
        if screen.state()["playing"] == wanted:
            return
        screen.keys("space")



# 1. the default house is playing, nothing covers it, and the next action is named
state = screen.until(lambda s: s.get("complete") and s["time"] > 0.5)
check(state["laboratory"] == "house" and "ube" in state["file"], "the default house is open", state.get("file"))
check(state["playing"] and state["sheet"] == "none", "it runs, and nothing lies over it", state)
check(state["answer"]["title"].startswith("All 4 get out"), "the answer is there", state["answer"])
one = screen.shot("one")
begun = screen.state()["time"]
screen.until(lambda s: not begun <= s["time"] < begun + 0.5)
two = screen.shot("two")
view = state["frame"]["view"]
check(differing(one, two, view) > 200, "something moves in the view", differing(one, two, view))
check(len(stage.colours(one, state["frame"]["strip"])) > 5, "the strip of keys has words")

# 2. the answer is large enough to be read from the back row
answer = state["frame"]["answer"]
title = [answer[0], answer[1], answer[0] + 300, answer[3] - 4]
height = stage.magick("convert", str(one), "-crop", stage.crop(title), "+repage", "-trim", "-format", "%h", "info:").stdout
check(int(height) >= 29, "the answer's letters are at least 29 pixels high", height)

# 4. texts and shapes have enough contrast
for name, box, least in (("answer", title, 4.5), ("menu", state["frame"]["menu"], 4.5),
                         ("panel", state["frame"]["panel"], 4.5), ("strip", state["frame"]["strip"], 4.5),
                         ("timeline", state["frame"]["timeline"], 3.0), ("view", view, 3.0)):
    found = stage.colours(one, box)
    most = max(contrast(found[0][1], other) for _, other in found[:40])
    check(most >= least, f"{name}: the contrast is at least {least}", most)

# 6. Space, also after a click on a button, and Alt+K while a field is open
screen.keys("space")
state = screen.state()
check(not state["playing"], "Space pauses")
paused = screen.shot("paused")
corner = [view[2] - 140, view[1], view[2], view[1] + 50]
check(differing(two, paused, corner) > 500, "the view says that it is paused")
screen.keys("space")
check(screen.state()["playing"], "Space plays")
x, y = state["frame"]["timeline"][2] - 60, sum(state["frame"]["timeline"][1::2]) / 2
screen.click(x, y)
screen.point_to(640, 300)
before = screen.state()["playing"]
screen.keys("space")
check(screen.state()["playing"] != before, "Space still toggles after a click on a button of a panel")

# 7. steps
screen.keys("r")
state = screen.until(lambda s: s["time"] > 1)
play(False)
begin = screen.state()
at_first = screen.shot("at-first")
screen.keys(*["period"] * 10)
on = screen.state()
check(abs(on["time"] - begin["time"] - 10 * begin["step"]) < 1e-9, "ten steps are ten frames", (begin["time"], on["time"]))
check(differing(at_first, screen.shot("ten-on"), view) > 100, "ten steps show something else")
screen.keys(*["comma"] * 10)
back = screen.state()
check(abs(back["time"] - begin["time"]) < 1e-9, "ten steps back are the same moment", (begin["time"], back["time"]))
check(differing(at_first, screen.shot("ten-back"), view, "0%") == 0, "and the same picture, to the pixel")

# 8. scrubbing
track = state["frame"]["timeline"]
middle = [(track[0] + track[2]) / 2, (track[1] + track[3]) / 2]
screen.click(*middle)
there = screen.state()
check(2 < there["time"] < there["end"], "a click on the timeline goes there", there["time"])
screen.point_to(640, 300)
seen = screen.shot("scrubbed")
screen.keys("period", "period", "comma", "comma")
check(abs(screen.state()["time"] - there["time"]) < there["step"], "steps round a place that was scrubbed to")
screen.keys("End")
check(screen.state()["time"] == there["end"], "End goes to the end of the record")

# 9. speed
screen.keys("r", *["bracketright"] * 6)
check(screen.state()["speed"] == 16, "the ladder ends at 16", screen.state()["speed"])
screen.keys("r", "space")  # at the beginning, since R at the end of the record plays
play(False)
first = screen.state()
screen.keys("1", "r")
state = screen.state()
check(state["speed"] == 16 and not state["playing"] and state["layers"] != first["layers"],
      "running again keeps speed, pause and layers", (state["speed"], state["playing"], state["layers"]))
screen.keys("1", "backslash")
check(screen.state()["speed"] == 1, "backslash is speed 1")
screen.keys("bracketleft", "bracketleft")
play(True)
screen.keys("r")
state = screen.state()
check(state["speed"] == 0.25 and state["playing"], "running again keeps playing", (state["speed"], state["playing"]))
screen.keys("backslash")
screen.keys("r")
screen.state()
screen.until(lambda s: s["playing"] and 0.2 < s["time"] < 10)
for attempt in range(20):  # another program may use the processor between the two measurements
    first, begun = screen.state(), time.monotonic()
    second = screen.until(lambda s: not first["time"] <= s["time"] < first["time"] + 1)
    moved = (second["time"] - first["time"]) / (time.monotonic() - begun)
    if second["achieved"] is not None and abs(second["achieved"] - moved) < 0.15 * max(moved, 0.1):
        break
    if second["end"] - second["time"] < 3:
        screen.keys("r")
check(second["achieved"] is not None and abs(second["achieved"] - moved) < 0.15 * max(moved, 0.1),
      "the achieved speed is what a watch says", (second["achieved"], moved))

# the other laboratory, the gallery, a picture, a dialog, and quitting
screen.keys("F3")
state = screen.until(lambda s: s["laboratory"] == "beam" and not s["answer"]["stale"])
check(state["laboratory"] == "beam" and not state["answer"]["stale"], "F3 is the beam, and it is answered", state["answer"])
screen.keys("F4")
check(screen.state()["sheet"] == "gallery", "F4 is the gallery")
screen.keys("Escape", "F9")
check("Written" in (screen.state()["message"] or ""), "F9 writes a picture", screen.state()["message"])
screen.keys("ctrl+o")
screen.until(lambda s: s["sheet"] == "open")
screen.type("abc")
before = screen.state()
screen.keys("alt+k")
state = screen.state()
check(state["field"] == "abc" and state["playing"] != before["playing"], "6: Alt+K plays or pauses while a field is open, and is not typed",
      (state["field"], before["playing"], state["playing"]))
screen.keys("alt+k", "Escape", "Escape")
screen.keys("ctrl+e", "Escape", "ctrl+t", "F2")
check(screen.state()["laboratory"] == "house", "F2 is the house again")

screen.end()
stage.end()
