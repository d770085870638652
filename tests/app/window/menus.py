#!/usr/bin/env python3
"""Tests the menus, the card of keys, the history of edits and the messages, with a real mouse and real keys."""

import json

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

# with large letters it scrolls, and what the focus is on is seen
act("menus-large", "wait 3", "key F10", "wait 3", "key q", "wait 5", "texts FOLDER/texts", "wait 2",
    arguments=["--size", "1280x720", "--text", "3"])
seen = [text for line in (stage.folder / "menus-large" / "texts").read_text().splitlines() for text in json.loads(line)]
last = [text for text in seen if text["string"].strip() == "Quit"]
check(last and all(text["clip"][1] <= text["box"][1] and text["box"][3] <= text["clip"][3] for text in last),
      "the last row of a large menu is scrolled into view", last)

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
plan.keys("Escape")
state = plan.state()
check(state["sheet"] == "keys" and state["field"] == "" and state["types"], "Escape empties the field, which stays in use",
      (state["sheet"], state["field"], state["types"]))
plan.keys("Next")
down = plan.shot("keys-below")
check(stage.differing(before, down) > 5000, "PageDown scrolls the card while its field has the focus")
plan.keys("Prior")
check(stage.differing(down, plan.shot("keys-above")) > 5000, "PageUp scrolls back")
plan.keys("Escape")
check(plan.state()["sheet"] == "none", "one Escape closes the card while its field is empty", plan.state()["sheet"])

plan.end()

# the first window is as large as suits its screen, and one that was larger before stays within the screen
first = stage.Screen("large-screen", width=1600, height=1000, whole=False)
state = first.state()
check(1280 <= state["width"] <= 1600 and state["width"] >= 0.75 * 1600 and 0.75 * 1000 <= state["height"] <= 1000,
      "8: the first window takes most of a large screen", (state["width"], state["height"]))
first.end()
kept = first.place / "home" / ".config" / "clearance" / "settings.json"
settings = json.loads(kept.read_text())
kept.write_text(json.dumps({**settings, "width": 3000, "height": 2000}))
first.log.unlink()
first = stage.Screen("large-screen", width=1024, height=600, whole=False)
state = first.state()
check((state["width"], state["height"]) == (1024, 600), "8: a remembered size stays within a smaller screen",
      (state["width"], state["height"]))
first.end()

# each edit has a message with Undo; the history goes back to the house as it was opened
found = act("history", "until answered", "pause", "click 690 480", "wait 3", "key Delete", "wait 3", "state STATE",
            "click 1208 705", "wait 3", "state STATE", "key Ctrl+Y", "wait 3", "key Ctrl+Shift+H", "wait 3",
            "state STATE", "key Return", "wait 3", "state STATE", arguments=["--size", "1280x720"])
check(found[0]["said"] == found[0]["undo_name"] and found[0]["said"].startswith("Remove "), "an edit is told",
      (found[0]["said"], found[0]["undo_name"]))
check(not found[1]["undo_name"] and found[1]["redo_name"], "its button undoes it", found[1]["undo_name"])
check(found[2]["sheet"] == "history" and found[2]["undo_name"], "15: the history opens", found[2]["sheet"])
check(found[3]["sheet"] == "none" and not found[3]["undo_name"] and found[3]["redo_name"],
      "15: its first row is the house as opened, and redo is there", found[3]["undo_name"])
stage.end()
