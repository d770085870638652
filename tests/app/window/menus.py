#!/usr/bin/env python3
"""Tests the menus, the card of keys, the history of edits and the messages, with a real mouse and real keys."""

import stage
from drawing import Plan
from stage import act, check

# 14: every menu fits into a small window, and its last row is inside
for size in ("1024x600", "1280x720", "1920x1080"):
    steps = ["until answered", "wait 5", "key F10", "wait 5", "state STATE"]
    for _ in range(5):
        steps += ["key Right", "wait 5", "state STATE"]
    found = act(f"menus-{size}", *steps, arguments=["--size", size])
    height = int(size.split("x")[1])
    for state in found:
        box = state["menu_box"]
        check(box[1] >= 0 and box[3] <= height and not state["menu_scrolls"], f"14: {size}: {state['menu']} fits", box)
    check({s["menu"] for s in found} >= {"File", "Edit", "View", "Run", "Help"}, f"14: {size}: Right goes through all menus")

plan = Plan("menus", stage.house("flat-0.910-widened"))
plan.until(lambda s: s.get("complete"))

# a row that cannot be used says why; a letter jumps to its row
plan.click(74, 15)
plan.keys("d")
state = plan.state()
check(state["menu"] == "Edit" and state["focus_row"] == "Edit plan", "a letter of rows that cannot be used jumps nowhere",
      state["focus_row"])
plan.keys("p")
check(plan.state()["focus_row"] == "Paste", "a letter jumps to its row", plan.state()["focus_row"])
plan.keys("p")
check(plan.state()["focus_row"] == "Previous object", "again: to the next one", plan.state()["focus_row"])
plan.keys("Escape")

# F1: a field finds a key
plan.keys("F1")
plan.until(lambda s: s["sheet"] == "keys")
before = plan.shot("all-keys")
plan.type("histo")
check(plan.state()["field"] == "histo", "typing on the card of keys finds", plan.state()["field"])
check(stage.differing(before, plan.shot("found-keys")) > 5000, "and leaves only what is found")
plan.keys("Escape", "Escape")
check(plan.until(lambda s: s["sheet"] == "none")["sheet"] == "none", "Escape closes the card")

# each edit has a message with Undo
begun = plan.state()["digest"]
plan.keys("Tab", "Tab", "Tab", "Tab", "Tab", "Tab", "Tab")
for _ in range(40):
    if "furniture" in (plan.state()["selected"] or ""):
        break
    plan.keys("Tab")
plan.keys("Right")
state = plan.until(lambda s: s["said"] == "Nudge")
check(state["said"] == "Nudge" and state["undo_name"] == "Nudge", "an edit is told", (state["said"], state["undo_name"]))
strip = state["frame"]["strip"]
plan.click(strip[2] - 80, (strip[1] + strip[3]) / 2)
state = plan.until(lambda s: not s["undo_name"])
check(not state["undo_name"] and state["redo_name"] == "Nudge", "its button undoes it", state["undo_name"])

# 15: five edits; the third row is the plan of three undos, and redo brings all back
plan.keys(*["Right"] * 5)
whole = plan.until(lambda s: s["edits"] == 5)
file = plan.place / "whole.json"
plan.save_as(file)
plan.keys(*["ctrl+z"] * 3)
plan.save_as(plan.place / "three.json")
plan.keys(*["ctrl+y"] * 3)
plan.keys("ctrl+shift+h")
plan.until(lambda s: s["sheet"] == "history")
plan.shot("history")
plan.keys("Down", "Down", "Return")
state = plan.until(lambda s: s["sheet"] == "none")
plan.save_as(plan.place / "third.json")
check((plan.place / "third.json").read_text() == (plan.place / "three.json").read_text(),
      "15: the third row of the history is the plan of three undos")
plan.redo_all()
plan.save_as(plan.place / "again.json")
check((plan.place / "again.json").read_text() == file.read_text(), "15: and redo brings all back")

# several faults wait for one another
plan.keys("Escape", "Escape", "Escape", "ctrl+o")
plan.until(lambda s: s["sheet"] == "open")
plan.type("/nowhere/a.json")
plan.keys("Return", "ctrl+o")
plan.until(lambda s: s["sheet"] == "open")
plan.keys("ctrl+a")
plan.type("/nowhere/b.json")
plan.keys("Return")
state = plan.until(lambda s: s["faults"] == 2)
check(state["faults"] == 2 and "a.json" in state["said"], "the first of two faults is shown", (state["faults"], state["said"]))
plan.shot("two-faults")
while plan.state()["sheet"] != "none":
    plan.keys("Escape")
plan.click(strip[2] - 20, (strip[1] + strip[3]) / 2)
state = plan.until(lambda s: s["faults"] == 1)
check(state["faults"] == 1 and "b.json" in state["said"], "then the next one", (state["faults"], state["said"]))
plan.end()
stage.end()
