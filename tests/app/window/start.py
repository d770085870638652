#!/usr/bin/env python3
"""Tests the start page and the open dialog by real keys: groups in their order, keys that try, and finding by typing."""

import stage
from stage import check

GROUPS = ["# Try this", "# Lessons", "# Houses", "# Crowds", "# Beams", "# Cranks", "# Your files"]

screen = stage.Screen("start", stage.house("corner-0.90-0.90"))
screen.until(lambda s: s.get("complete"))
screen.keys("F4")
state = screen.until(lambda s: s["sheet"] == "gallery" and "# Crowds" in s["listed"])
shown = state["listed"]
check([name for name in shown if name.startswith("# ")] == GROUPS, "22: the groups stand in their order", shown)
check(sum(name.lower().startswith("corner") for name in shown) == 1, "22: the corners have one card", shown)

# arrows choose, Return opens
screen.keys("Right", "Return")
state = screen.until(lambda s: s["sheet"] == "none" and s["file"].endswith("flat-0.910-module.json"))
check(state["file"].endswith("flat-0.910-module.json"), "22: Right and Return open the second", state["file"])
screen.keys("F4")
screen.until(lambda s: s["sheet"] == "gallery")
screen.keys("Down", "Return")
state = screen.until(lambda s: s["sheet"] == "none" and s["lesson"])
check(state["lesson"], "22: Down goes to the row below", (state["file"], state["sheet"]))
screen.keys("Escape")
if screen.state()["sheet"] == "lesson":
    screen.keys("Return")
screen.until(lambda s: not s["lesson"] and s["sheet"] == "none")

# keys that try
screen.keys("F4")
screen.until(lambda s: s["sheet"] == "gallery")
screen.type("3")
state = screen.until(lambda s: s["sheet"] == "none" and s["file"].endswith("bedroom-after-earthquake.json")
                     and s.get("complete") and not s["answer"]["stale"])
check(state["answer"]["title"].startswith("Out in"), "22: 3 opens the third, with its result", (state["file"], state["answer"]))

# typing finds
screen.keys("F4")
screen.until(lambda s: s["sheet"] == "gallery" and "# Crowds" in s["listed"])
screen.type("shop")
state = screen.state()
cards = [name for name in state["listed"] if not name.startswith("# ")]
check(len(cards) == 1 and "shop" in cards[0].lower(), "22: typing leaves what has this in its name", state["listed"])
screen.keys("BackSpace", "Escape")
check(screen.state()["sheet"] == "gallery" and screen.state()["field"] == "", "Escape first takes back what is typed",
      screen.state()["field"])
screen.type("straight c")
screen.keys("Return")
state = screen.until(lambda s: s["sheet"] == "none" and s["file"].endswith("straight-corridor.json"))
check(state["file"].endswith("straight-corridor.json"), "Return opens what is found; Space belongs to the name", state["file"])

# the open dialog finds by a part of a name, too
screen.keys("ctrl+o")
screen.until(lambda s: s["sheet"] == "open")
while not screen.state()["types"]:
    screen.keys("Tab")
screen.type("two-ch")
state = screen.state()
check(state["listed"] == ["two-chairs-corridor.json"], "typing in the open dialog leaves what has this in its name",
      state["listed"])
screen.keys("Return")
state = screen.until(lambda s: s["sheet"] == "none" and s["file"].endswith("two-chairs-corridor.json"))
check(state["file"].endswith("two-chairs-corridor.json"), "and Return opens it", state["file"])
screen.end()

# a house that is being edited comes first, with the number of its edits
page, after = stage.act("continue", "until answered", "set door.d7.width 0.9", "wait 5", "until answered", "key F4", "wait 20",
                        "texts FOLDER/texts", "state STATE", "key Return", "wait 5", "state STATE")
texts = [t["string"] for t in stage.states(stage.folder / "continue" / "texts")[0]]
check(page["listed"][0].startswith("Continue: ") and "1 edit" in texts, "22: a house that is being edited comes first",
      page["listed"][:3])
check(after["sheet"] == "none" and after["edits"] == 1, "22: Return goes back to it", (after["sheet"], after["edits"]))

# an empty plan lacks walls: Return takes their tool, as the button of the answer does
state = stage.act("lacking", "until answered", "key Ctrl+N", "wait 5", "until answered", "key Return", "wait 5", "state STATE")[0]
check(state["tool"] == "wall", "20: Return takes the tool for what a house lacks", state["tool"])

# a requested file that is not there or not right: its faults are shown with the default house, until another one opens
bad = stage.folder / "bad.json"
bad.write_text('{"format": "clearance-house", "version": 1,\n "walls": 7}')
for path, says in ((bad, f"{bad}:2:"), (stage.folder / "none.json", "No such file")):
    first, later = stage.act(f"asked-{path.stem}", "until answered", "wait 5", "texts FOLDER/texts", "state STATE",
                             f"open {stage.house('corner-0.90-0.90')}", "until answered", "wait 5", "state STATE",
                             arguments=[str(path)])
    texts = [t["string"] for t in stage.states(stage.folder / f"asked-{path.stem}" / "texts")[0]]
    check(says in first["said"] and any(says in text for text in texts), "the requested file's fault is shown",
          (first["said"], texts[:3]))
    check(says not in (later["said"] or ""), "it is gone once another house is opened", later["said"])
stage.end()
