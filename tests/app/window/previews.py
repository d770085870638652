#!/usr/bin/env python3
"""Tests that each tool says what a click will do before it, by a real pointer and by keys alone, and that it comes true
(checks 18 and 19 of the calm window)."""

import json

import stage
from drawing import Plan
from stage import check

HOUSE = {"format": "clearance-house", "version": 1, "name": "rooms",
         "walls": [{"id": "w1", "points": [[-3, -2], [3, -2], [3, 2], [-3, 2], [-3, -2]], "thickness": 0.12},
                   {"id": "mid", "points": [[0, -2], [0, 2]], "thickness": 0.12}]}


def opened(name, **more):
    path = stage.folder / f"{name}.json"
    path.write_text(json.dumps({**HOUSE, **more}))
    plan = Plan(name, path, minutes=9, texts=True)
    plan.until(lambda s: s["title"] == "rooms" and s["floor"])
    return plan


def preview(plan, x, y):
    plan.move(x, y)
    return plan.until(lambda s: "preview" in s["gesture"])["gesture"]["preview"]


def begun(state, *fields):
    return state["gesture"]["active"] and set(fields) <= set(state["gesture"]["fields"])


# 18: by the pointer
plan = opened("pointed")
said = preview(plan, 1, 1) if plan.keys("y") is None else None
check(said["refused"] and said["words"] == "nobody is here: P places somebody", "18: a route needs somebody", said)
plan.put(1, 1)
check(not plan.state()["gesture"]["active"], "18: and the click does nothing")
for key, at, words, fields in (("w", (-2, 0.5), "wall begins here", ("length", "angle")),
                               ("m", (-2, 0.6), "distance begins here", ("length", "angle")),
                               ("a", (-2, 0.7), "first corner of a room; twice: all between these walls", ("length",))):
    plan.keys(key)
    said = preview(plan, *at)
    state = plan.state()
    check(said["words"] == words and not said["refused"] and state["edits"] == 0 and not state["changed"],
          f"18: {key} says what begins, and changes nothing", (said, state["edits"]))
    plan.put(*at)
    plan.move(at[0] + 0.5, at[1])
    check(begun(plan.state(), *fields), f"18: {key}: and that it does", plan.state()["gesture"])
    plan.keys("Escape", "Escape", "Escape")
    while plan.state()["undo_name"]:
        plan.keys("ctrl+z")
plan.keys("a")
said = preview(plan, 4.5, 0.2)
check(said["words"] == "first corner of a room", "18: outside there is no room to make", said)
plan.keys("Escape")

for key, at, words, made in (("d", (0, 0.5), "door 0.80 m", "door"), ("p", (-1.5, 0), "person here, drag to turn", "person")):
    plan.keys(key)
    said = preview(plan, *at)
    state = plan.state()
    check(said["words"].startswith(words.split(" ")[0]) and not state["edits"] and state["gesture"]["marks"],
          f"18: {key} shows what it places", (said, state["edits"]))
    plan.put(*at)
    state = plan.until(lambda s: s["undo_name"])
    check(made in (state["undo_name"] or "").lower(), f"18: {key}: and that it places", state["undo_name"])
    plan.keys("Escape", "Escape")
    plan.undo_all()
plan.keys("b")  # which gives the focus to the field of the picture's file
said = preview(plan, 1, 1.1)
check(said["refused"] and said["words"].startswith("no picture yet"), "18: a picture is asked for", said)
plan.end()

# 19: by keys alone the ghost stands in the middle of the view; arrows move it, Return places it
keys = opened("keyed")
keys.point_to(0, 0)
for key, name in (("d", "door"), ("p", "person"), ("x", "exit"), ("o", "place")):
    keys.keys(key, "Return")
    first = keys.state()["gesture"]
    check(first["active"] and first["fields"], f"19: {key}, Return begins in the middle of the view", first)
    # an exit goes to the wall at x = 0
    aside = ["shift+Left"] * round(10 * first["fields"]["x"]) if key == "x" else ["shift+Right"] * 6
    keys.keys(*["shift+Up"] * 3, *aside)
    moved = keys.state()["gesture"]["fields"]
    check(moved != first["fields"], f"19: {key}: arrows move it", (first["fields"], moved))
    keys.keys("Return")
    state = keys.state()
    if not state["gesture"]["active"]:
        check(name in (state["undo_name"] or "").lower(), f"19: {key}: and Return places it", state["undo_name"])
    else:
        check(False, f"19: {key}: and Return places it", state["gesture"])
    keys.keys("Escape", "Escape")
    keys.undo_all()
for key, name in (("w", "Draw walls"), ("a", "Draw room")):
    keys.keys(key, "Return")
    first = keys.state()["gesture"]["fields"]
    keys.keys("shift+Up", "shift+Right")
    moved = keys.state()["gesture"]["fields"]
    check(moved != first, f"19: {key}: arrows move the first point", (first, moved))
    keys.keys("Return")
    for length in ("1", "0.8", "1"):
        keys.type(length)
        keys.keys("Return")
    keys.keys("Escape", "Escape")
    check(keys.state()["undo_name"] == name, f"19: {key}: and lengths draw the rest", keys.state()["undo_name"])
    keys.keys("Escape")
    keys.undo_all()

# what is drawn by keys is seen where it begins and where it goes, and the arrows move both
keys.keys("w", "Return")
cross = [mark["at"] for mark in keys.state()["gesture"]["marks"] if mark["kind"] == "place"]
check(len(cross) == 1, "19: a cross marks where a wall would begin", keys.state()["gesture"]["marks"])
keys.keys("shift+Right")
moved = [mark["at"] for mark in keys.state()["gesture"]["marks"] if mark["kind"] == "place"]
check(len(moved) == 1 and abs(moved[0][0] - cross[0][0] - 0.1) < 1e-6, "19: an arrow moves the cross", (cross, moved))
keys.keys("Return")
marks = {mark["kind"]: mark["at"] for mark in keys.state()["gesture"]["marks"]}
check(marks.get("start") == moved[0] and marks.get("place") == moved[0], "19: the wall's start stays marked", marks)
keys.keys(*["shift+Up"] * 3, *["shift+Right"] * 4)
gesture = keys.state()["gesture"]
marks = {mark["kind"]: mark["at"] for mark in gesture["marks"]}
check(abs(gesture["fields"]["length"] - 0.5) < 1e-6 and marks["start"] == moved[0]
      and abs(marks["place"][0] - moved[0][0] - 0.4) < 1e-6 and abs(marks["place"][1] - moved[0][1] - 0.3) < 1e-6,
      "19: then arrows move the wall's end", gesture)

def fields(screen):
    """Returns the lines of the numbers of what is being drawn."""
    return [t["string"] for t in screen.texts() if t["string"].startswith(("length ", "angle "))]


check(fields(keys) and not any("typed" in line for line in fields(keys)), "what arrows have moved is not said to be typed",
      fields(keys))
keys.type("0.7")
keys.keys("Tab")
check({line for line in fields(keys) if "typed" in line} == {"length 0.700 m (typed)"}, "what is typed is said to be",
      fields(keys))
keys.keys("Return", "Escape", "Escape")
check(keys.state()["undo_name"] == "Draw walls", "19: and Return draws it", keys.state()["undo_name"])
keys.end()
stage.end()
