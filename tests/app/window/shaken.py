#!/usr/bin/env python3
"""Tests by a real pointer what the window tells after an earthquake: what fell, who leaves how often in a hundred of
them, and what to fix to the wall, with the numbers of the command line."""

import json
import subprocess

import stage
from drawing import Plan
from stage import check

HOUSE = {
    "format": "clearance-house", "version": 1, "name": "a room and two shelves",
    "walls": [{"id": "w1", "points": [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]}],
    "doors": [{"id": "d1", "wall": "w1", "segment": 1, "at": 1.5, "width": 1.0, "kind": "opening"}],
    "furniture": [{"id": "f1", "name": "tall shelf", "centre": [2.6, 2.8], "size": [0.6, 0.3], "height": 2.3,
                   "topples": "front"},
                  {"id": "f2", "name": "low shelf", "centre": [0.4, 2.85], "size": [0.5, 0.2], "height": 0.5,
                   "topples": "front"}],
    "exits": [{"id": "e1", "from": [4.8, 1.0], "to": [4.8, 2.0]}],
    "people": [{"id": "p1", "profile": "manual-chair", "at": [0.9, 1.5]}],
    "routes": [{"id": "A", "people": ["p1"], "via": [], "exit": "e1"}]}


def told(*settings):
    """Returns what the command line tells of a hundred shakes of the house."""
    done = subprocess.run([str(stage.program), "study", str(house), "--shake", "100", "--json", *settings],
                          capture_output=True, text=True, timeout=600)
    return json.loads(done.stdout)


def rows(state, title):
    """Returns the rows below a heading of the panel."""
    at = [row[0] for row in state["rows"]].index(title)
    titles = ("This shake", "In 100 shakes", "What to fix to the wall", "Compare: before, now", "People", "Key")
    below = [row for row in state["rows"][at + 1:]]
    return below[:next((i for i, row in enumerate(below) if row[0] in titles), len(below))]


def press(words):
    """Clicks on the button with these words."""
    box = next(text["box"] for text in window.texts() if text["string"] == words)
    window.click((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)


def shaken(number):
    """Waits until that shake is shown with what a hundred of them do."""
    return window.until(lambda s: s["complete"] and not s["answer"]["stale"] and not s["answer"]["shaking"]
                        and [row[:2] for row in s["rows"]].count(["This shake", f"shake {number}"]))


house = stage.folder / "shelves.json"
house.write_text(json.dumps(HOUSE))
window = Plan("shaken", house, height=900, minutes=9, texts=True)
window.until(stage.is_settled)
check("This shake" not in [row[0] for row in window.state()["rows"]], "an unshaken house has no rows about earthquakes")
window.keys("shift+t")
first = shaken(1)
answer = told()
share = {person["id"]: person["out"]["shakes"] for person in answer["people"]}
check(0 < share["p1"] < 100, "the wheelchair leaves after some of the shakes", share)
check(rows(first, "In 100 shakes")[0][1] == f'{share["p1"]} of 100', "the window tells how often, as the command line does",
      (rows(first, "In 100 shakes"), share))
pieces = [[piece["name"], f'fell {piece["toppled"]}', f'blocks {piece["blocks"]["shakes"]}'] for piece in answer["furniture"]]
check(len(pieces) == 2 and rows(first, "What to fix to the wall")[:2] == pieces, "and which piece stops people how often",
      (rows(first, "What to fix to the wall"), pieces))

# another shake of the same house has other fallen pieces, and the hundred are known already
press("Another shake")
second = shaken(2)
check(rows(second, "In 100 shakes") == rows(first, "In 100 shakes"), "another shake leaves the hundred as they are",
      rows(second, "In 100 shakes"))

# a shake in which the tall shelf falls
shakes = 2
while "tall shelf" not in rows(window.state(), "This shake")[0][0] and shakes < 20:
    press("Another shake")
    shakes += 1
    shaken(shakes)
fallen = window.state()
check("tall shelf" in rows(fallen, "This shake")[0][0] and "cannot pass" in fallen["answer"]["title"],
      "the tall shelf bars the way", (fallen["answer"], rows(fallen, "This shake")))
window.shot("fallen")

# fixed to the wall it stands in the same shake, and never bars the way
press("Fix the tall shelf")
fixed = shaken(shakes)
check(fixed["undo_name"] == "Fix tall shelf to the wall" and "tall shelf" not in rows(fixed, "This shake")[0][0],
      "the piece is fixed, in one step, and the same shake is shown", (fixed["undo_name"], rows(fixed, "This shake")))
check(fixed["answer"]["title"].startswith("Out in"), "and the wheelchair leaves", fixed["answer"])
answer = told("--set", "furniture.f1.topples=no")
check(rows(fixed, "In 100 shakes")[0][1] == f'{answer["people"][0]["out"]["shakes"]} of 100' == "100 of 100",
      "in each of a hundred", (rows(fixed, "In 100 shakes"), answer["people"]))
window.shot("fixed")

# undone it lies again; stood up, the house is as it was before
window.keys("ctrl+z")
back = shaken(shakes)
check(rows(back, "This shake") == rows(fallen, "This shake") and rows(back, "In 100 shakes") == rows(first, "In 100 shakes"),
      "undone, the shelf lies again, and the hundred are those of before", back["rows"])
press("Stand up")
stood = window.until(lambda s: s["complete"] and not s["answer"]["stale"] and "This shake" not in [r[0] for r in s["rows"]])
check(stood["answer"]["title"].startswith("Out in") and stood["undo_name"] == "Stand up what fell",
      "stood up, the house is left as before, in one step", (stood["answer"], stood["undo_name"]))
window.keys("ctrl+s")
window.until(lambda s: not s["unsaved"])
pieces = json.loads(house.read_text())["furniture"]
check(not any(piece.get("toppled") for piece in pieces), "nothing lies in the saved file", pieces)
window.end()
stage.end()
