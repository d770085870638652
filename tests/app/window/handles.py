#!/usr/bin/env python3
"""Tests each handle of a house with a real mouse and real keys: it is dragged and clicked, undone and redone, and the
answers are compared with those of the command line for the same files."""

import json
import subprocess

import stage
from drawing import Plan
from stage import check

HOUSE = {
    "format": "clearance-house", "version": 1, "name": "two rooms",
    "walls": [{"id": "w1", "points": [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]}, {"id": "w2", "points": [[3, 0], [3, 4]]}],
    "doors": [{"id": "d1", "wall": "w2", "at": 2, "width": 0.9, "kind": "hinged", "swing": "right"},
              {"id": "d2", "wall": "w1", "segment": 1, "at": 2, "width": 1.0, "kind": "opening"}],
    "furniture": [{"id": "f1", "name": "wardrobe", "centre": [2.3, 3.5], "size": [0.8, 0.5], "height": 1.2,
                   "topples": "front"}],
    "exits": [{"id": "e1", "from": [6.8, 1.4], "to": [6.8, 2.6]}],
    "people": [{"id": "p1", "profile": "manual-chair", "at": [0.8, 2.0]}],
    "routes": [{"id": "A", "people": ["p1"], "via": [[4.5, 2.0]], "exit": "e1"}]}


class Hand(Plan):
    """A paused window with the house, while the plan is edited."""

    def __init__(self, name, house=HOUSE, texts=False):
        place = stage.folder / name
        place.mkdir()
        self.house = place / "house.json"
        self.house.write_text(json.dumps(house))
        super().__init__(name, self.house, minutes=9, texts=texts)
        self.until(lambda s: s["complete"] and s["floor"] and not s["answer"]["stale"])
        self.keys("space", "ctrl+j")
        self.settle()

    def settle(self):
        """Waits until all background work is done."""
        self.state()
        return self.until(stage.is_settled)

    def saved(self):
        """Saves the house and returns the contents of its file."""
        self.keys("ctrl+s")
        self.state()
        self.until(lambda s: not s["unsaved"])
        return self.house.read_bytes()

    def choose(self, x, y):
        """Selects the item at a place, then moves the pointer away from it."""
        self.keys("Escape", "Escape", "Escape")
        self.put(x, y)
        self.move(-0.8, 3.5)
        return self.state()

    def width_of_door(self, value):
        """Types a width into the panel; starts with the focus on the plan and uses only keys."""
        self.choose(3, 2)
        self.keys("Return")
        self.until(lambda s: s["focus"] == "panel")
        self.tab_to("width")
        self.keys("Return")
        self.until(lambda s: s["types"])
        self.keys("ctrl+a")
        self.type(value)
        self.keys("Return")
        self.choose(-0.8, 3.5)  # returns the focus to the plan

    def tab_to(self, name):
        """Presses Tab until the number or text of this name has the focus."""
        for _ in range(40):
            if (self.state()["focus_help"] or "").startswith(name):
                return
            self.keys("Tab")

    def redo_to(self, name):
        """Redoes steps until this step is the next one to redo."""
        for _ in range(200):
            if self.state()["redo_name"] in (name, None):
                return
            self.keys("ctrl+y")

    def undo_to(self, name):
        for _ in range(10):
            if self.state()["undo_name"] == name:
                return
            self.keys("ctrl+z")


def has_handle(state, at):
    return any(mark["kind"] == "handle" and abs(mark["at"][0] - at[0]) + abs(mark["at"][1] - at[1]) < 0.02
               for mark in state["gesture"]["marks"])


# 15: the items with handles: place to select the item, handle, target
plan = Hand("handles")
plan.choose(2.3, 3.5)
plan.keys("Left")
plan.saved()  # from here on the file has the program's own formatting
plan.undo_to(None)
start = plan.saved()
for what, at, handle, to in (("piece of furniture", (2.3, 3.5), (2.3, 3.5), (1.3, 0.8)),
                             ("corner of a piece", (2.3, 3.5), (1.9, 3.25), (1.6, 3.0)),
                             ("way that a piece looks", (2.3, 3.5), None, (1.4, 2.9)),
                             ("corner of a wall", (3, 0.6), (3, 4), (4, 3.2)),
                             ("piece of a wall", (1.5, 0), (3, 0), (3, -0.5)),
                             ("door", (3, 2), (3, 2), (3, 2.7)),
                             ("edge of a door", (3, 2), (3, 2.45), (3, 2.3)),
                             ("end of an exit", (6.8, 2.3), (6.8, 2.6), (6.8, 2.9)),
                             ("exit", (6.8, 2.3), (6.8, 2), (7.0, 1.6)),
                             ("person", (0.8, 2.0), (0.8, 2.0), (1.2, 1.2)),
                             ("way that a person looks", (0.8, 2.0), (1.7, 2.0), (0.8, 3.2)),
                             ("point of a route", (0.8, 2.0), (4.5, 2.0), (4.2, 1.0))):
    state = plan.choose(*at)
    if not handle:  # the disc that turns the item
        handle = next((m["at"] for m in state["gesture"]["marks"] if m["kind"] == "handle" and m["at"][1] < 3.2), (0, 0))
    found = has_handle(state, handle)
    plan.drag(*handle, *to)
    plan.keys("Escape", "Escape", "Escape")
    dragged = plan.saved()
    plan.undo_to(None)
    plan.choose(*at)
    plan.put(*handle)
    taken = plan.state()["gesture"]["active"]
    plan.move(0.3 * handle[0] + 0.7 * to[0], 0.3 * handle[1] + 0.7 * to[1])
    plan.put(*to)
    plan.move(-0.8, 3.5)
    left = plan.state()["gesture"]["active"]
    plan.keys("Escape", "Escape", "Escape")
    clicked = plan.saved()
    check(found and taken and not left and dragged == clicked and dragged != start,
          f"15: {what}: click, move, click is dragging",
          (found, taken, left, dragged != start, dragged.decode(), clicked.decode()))
    plan.undo_to(None)
check(plan.saved() == start, "15: all of it undone, the file has its first bytes again")

# 16: the mouse moves a door to another wall
plan.choose(3, 2)
plan.drag(3, 2, 1.5, 0.02)
plan.keys("Escape", "Escape")
door = json.loads(plan.saved())["doors"][0]
check(door["wall"] == "w1" and door.get("segment", 0) == 0 and abs(door["at"] - 1.5) < 0.05,
      "16: dragged to another wall a door is in that wall, along it", door)
plan.undo_to(None)

# 17: keys turn furniture, topple it and stand it up
before = plan.choose(2.3, 3.5)
plan.settle()
plan.keys(*["e"] * 6)
turned = plan.settle()
check(abs(abs(turned["parameters"]["furniture.f1.angle"]) - 90) < 1e-9, "17: E six times is a quarter, and is shown",
      turned["parameters"]["furniture.f1.angle"])
plan.undo_to(None)
upright = plan.settle()
plan.keys("t")
lying = plan.settle()
check(lying["undo_name"] == "Topple wardrobe" and ["fallen", "yes"] in [row[:2] for row in lying["rows"]],
      "17: T topples it", (lying["undo_name"], lying["rows"]))
check((lying["answer"], lying["digest"]) != (upright["answer"], upright["digest"]) and "before" in
      lying["answer"]["detail"], "17: what lies there changes route and answer", lying["answer"])
plan.keys("t", "ctrl+z", "ctrl+z")
again = plan.settle()
check(again["undo_name"] is None and again["answer"] == upright["answer"], "17: undone it is as it was", again["answer"])

# 18: a door that is too narrow: the same numbers as on the command line, and a button that shows the place
plan.width_of_door("0.6")
narrow = plan.settle()
check(narrow["parameters"]["door.d1.width"] == 0.6, "Enter goes to the number of what is selected, Enter types it",
      (narrow["focus"], narrow["message"], narrow["parameters"]["door.d1.width"]))
plan.saved()
told = subprocess.run([str(stage.program), "check", str(plan.house)], capture_output=True, text=True, timeout=600).stdout
words = narrow["answer"]["detail"].split("; ")[-1]
check(narrow["answer"]["title"].endswith(" cannot pass the door d1") and words.startswith("needs at least") and words in told,
      "18: too narrow it says what it needs and has, as the command line does", (narrow["answer"], told))
place = json.loads(subprocess.run([str(stage.program), "check", "--json", str(plan.house)], capture_output=True,
                                  text=True, timeout=600).stdout)["people"][0]["blocked_at"]
x, y, right, bottom = narrow["frame"]["answer"]
plan.click(right - 70, (y + bottom) / 2)
shown = plan.state()
shown = plan.until(lambda s: s["zoom"] > 1)
at, view = plan.point(place["x"], place["y"], shown), shown["frame"]["view"]
middle = ((view[0] + view[2]) / 2, (view[1] + view[3]) / 2)
check(shown["zoom"] > 1 and abs(at[0] - middle[0]) < 60 and abs(at[1] - middle[1]) < 60,
      "18: Show place zooms to where it stops", (shown["zoom"], at, middle))
plan.shot("place")
plan.end()

# 19: before and now, compared as the command line compares the two files
plan = Hand("compare", texts=True)
plan.choose(3, 2)
plan.keys("Return")
plan.until(lambda s: s["focus"] == "panel")
plan.tab_to("width")


def slider(plan):
    """Returns the box of the label of the door's width in the panel."""
    panel = plan.state()["frame"]["panel"]
    return next(t["box"] for t in plan.texts() if t["string"] == "width" and t["box"][0] > panel[0])


was = slider(plan)
plan.keys("Left")
plan.settle()
check(plan.until(lambda s: any("Compare" in row[0] for row in s["rows"])) and slider(plan)[1] == was[1],
      "19: what compares with the run before moves no slider from under the hand", (was, slider(plan)))
plan.choose(-0.8, 3.5)
plan.undo_to(None)
first = plan.place / "first.json"
first.write_bytes(plan.saved())
plan.width_of_door("1.1")
now = plan.settle()
plan.saved()
told = json.loads(subprocess.run([str(stage.program), "compare", "--json", str(first), str(plan.house)],
                                 capture_output=True, text=True, timeout=600).stdout)
before, after = told["a"], told["b"]
was, now_is = (float(f"{run['time']:.1f}") for run in (before, after))
more = f"{now_is - was:+.1f} s".replace("-", "\u2212") if now_is != was else "the same"
check(now["answer"]["title"].startswith(f"Out in {now_is:.1f} s")
      and now["answer"]["detail"].startswith(f"before {was:.1f} s, {more}"),
      "19: what was before and the difference are told unasked, as by the command line", (now["answer"], now_is))
plan.keys("r")
clean = plan.until(lambda s: s["digest"] == after["digest"])
check(clean["digest"] == after["digest"], "19: R runs it from the beginning, as the command line does",
      (now["digest"], clean["digest"], clean["focus"]))
rows = {row[0]: row[1:] for row in plan.until(lambda s: any("Compare" in row[0] for row in s["rows"]))["rows"]}
check(rows.get("last out") == [f"{before['time']:.1f} s", f"{after['time']:.1f} s"]
      and rows.get("touches") == [str(run["people"][0]["contacts"]) for run in (before, after)]
      and rows.get("personal space pressed for") == [f"{run['people'][0]['ring_time']:.1f} s" for run in (before, after)],
      "19: the table of both has the same numbers", (rows, before["people"], after["people"]))
plan.end()

# 14: twenty edits of many kinds, undone and redone to the same bytes
plan = Hand("mixed")
start = plan.saved()


def word(plan, x, y, value):
    """Types another name into the panel's first text field."""
    plan.choose(x, y)
    plan.keys("Return")
    plan.until(lambda s: s["focus"] == "panel")
    plan.tab_to("name")
    plan.keys("Return")
    plan.until(lambda s: s["types"])
    plan.keys("ctrl+a")
    plan.type(value)
    plan.keys("Return")
    plan.choose(-0.8, 3.5)


def put(plan, tool, *places):
    plan.keys(tool)
    for place in places:
        plan.put(*place)
    plan.keys("Escape", "Escape", "Escape")


plan.choose(2.3, 3.5)
plan.keys("Left", "shift+Down", "q", "shift+e", "t", "t", "ctrl+d", "Delete")
plan.choose(0.8, 2.0)
plan.keys("ctrl+Up", "e")
plan.width_of_door("1.05")
word(plan, 2.3, 3.4, "tall wardrobe")
plan.choose(2.3, 3.4)
plan.keys("ctrl+c")
plan.move(5, 0.8)
plan.keys("ctrl+v")
put(plan, "w", (3, 1), (4.2, 1))
plan.choose(3.6, 1)
plan.keys("shift+w", "Up")
put(plan, "p", (5, 3.2))
put(plan, "x", (-0.8, 1), (-0.8, 2))
put(plan, "d", (0, 1.5))
plan.choose(6.8, 2.3)
plan.keys("Right")
plan.choose(3, 0.5)
plan.drag(3, 0.5, 3.2, 0.5)
plan.keys("Escape", "Escape")
plan.keys("alt+r")
plan.keys("ctrl+z")
edited = plan.settle()
check(edited["edits"] >= 20, "14: twenty edits and more of many kinds", (edited["edits"], edited["undo_name"]))
check(edited["redo_name"] == "Reset scene", "14: Alt+R puts all back as a step, which is undone, too", edited["redo_name"])
plan.undo_all()
check(plan.saved() == start, "14: undone, the file has its first bytes")
plan.redo_to(edited["redo_name"])
last = plan.saved()
plan.undo_all()
plan.redo_to(edited["redo_name"])
check(plan.saved() == last and last != start, "14: undone and done again, the last bytes")
plan.end()

stage.end()
