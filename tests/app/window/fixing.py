#!/usr/bin/env python3
"""Tests the fix beside the plan by a real mouse and keyboard: two pictures by one clock, numbers as `check --suggest`
has them, the plan unchanged until the fix is used, as one step."""

import json
import subprocess

import stage
from stage import check

FLAT = stage.house("flat-0.910-module")
told = json.loads(subprocess.run([stage.program, "check", FLAT, "--suggest", "--json"], capture_output=True, text=True,
                                 timeout=stage.PATIENCE).stdout)["suggestions"]


def ask(screen):
    """Presses "Suggest a fix" in the panel by keys, and waits for the picture with the fix."""
    for _ in range(12):
        if screen.state()["focus"] == "panel":
            break
        screen.keys("F6")
    for _ in range(20):
        if (screen.state()["focus_help"] or "").startswith("Suggest a fix"):
            break
        screen.keys("Tab")
    screen.keys("Return")
    return screen.until(lambda s: s["split"] and not s["split"]["stale"] and s["split"]["title"].startswith("Out"))


def hull(box):
    return [round(v) for v in box]


screen = stage.Screen("fix", FLAT)
before = screen.until(lambda s: s.get("complete") and "cannot" in s["answer"]["title"].lower()
                      and s["answer"]["detail"])
state = ask(screen)
left, right = hull(state["frame"]["view"]), hull(state["split"]["beside"])
check(left[2] <= right[0] and left[1] == right[1] and left[3] == right[3] and abs((left[2] - left[0]) - (right[2] - right[0])) <= 2,
      "23: two pictures of one size stand side by side", (left, right))
check(state["answer"]["title"] == before["answer"]["title"] and not state["unsaved_edits"] and state["zoom"] > before["zoom"],
      "23: the answer and the plan are as before, and the place is near", (state["answer"], state["zoom"]))
check(state["split"]["title"].startswith(f"Out in {told[0]['time']:.1f} s") and state["proposals"] == len(told),
      "23: the numbers are those of check --suggest", (state["split"], told))
screen.until(lambda s: s["time"] > 1)
screen.keys("space")
state = screen.state()
check(state["split"]["time"] == state["time"] and state["end"] == state["split"]["end"] and state["time"] > 0,
      "23: one clock, as long as the longer run", (state["time"], state["split"]["time"], state["end"]))
first = screen.shot("first")
screen.keys("period", "period")
screen.shot("second")
wanted = [screen.place / "first.png", screen.place / "second.png"]
check(stage.differing(*wanted, right) > 0, "23: the chair moves with the fix")
check(stage.differing(*wanted, left) == 0, "23: and stands still as it is")
screen.keys("Escape")
dropped = screen.state()
check(not dropped["split"] and dropped["digest"] == before["digest"] and dropped["zoom"] == before["zoom"]
      and dropped["undo_name"] is None, "23: Escape drops the fix: plan and camera are as before",
      (dropped["split"], dropped["undo_name"], dropped["zoom"]))

ask(screen)
screen.keys("Return")
done = screen.until(lambda s: s["answer"]["title"].startswith("Out in") and not s["answer"]["stale"])
check(not done["split"] and done["answer"]["title"].startswith(f"Out in {told[0]['time']:.1f} s") and done["edits"] == 1,
      "23: Return uses the fix, as one step", (done["answer"]["title"], done["edits"]))
check((done["undo_name"] or "").startswith("Widen bedroom door"), "23: the step is called as what it does", done["undo_name"])
screen.keys("ctrl+z")
back = screen.until(lambda s: not s["answer"]["stale"] and "cannot" in s["answer"]["title"].lower())
check(back["edits"] == 0 and not back["changed"], "23: one undo takes it back", back["edits"])
screen.end()
stage.end()
