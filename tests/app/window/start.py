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
stage.end()
