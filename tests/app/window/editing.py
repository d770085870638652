#!/usr/bin/env python3
"""Tests editing a house with a real mouse and a real keyboard: checks 10 to 19 of the window's conventions, and a flat
of four rooms drawn from an empty plan, once with the mouse and once with the keyboard alone."""

import json
import math
import pathlib
import subprocess

import stage
from drawing import Plan
from stage import check, differing


def read(path):
    return json.loads(path.read_text())


def chain(plan, *points):
    """Draws walls from point to point."""
    plan.keys("w")
    for x, y in points:
        plan.put(x, y)
    plan.keys("Escape", "Escape", "Escape")


def length(wall):
    (ax, ay), (bx, by) = wall["points"][:2]
    return math.hypot(bx - ax, by - ay)


def gesture_words(state, kind):
    return [mark.get("words") for mark in state["gesture"]["marks"] if mark["kind"] == kind]


# 10: a length is typed while the wall is drawn
for number, typed in enumerate(("2.5", "2,5", "250cm")):
    plan = Plan(f"length-{number}")
    plan.keys("ctrl+n")
    plan.until(lambda s: s["answer"]["title"] == "No plan yet" and s["floor"])
    plan.keys("w")
    plan.put(-2, 0)
    plan.move(1, 0)
    plan.type(typed)
    plan.keys("Return", "Escape", "Escape")
    saved = plan.place / "typed.json"
    plan.save_as(saved)
    wall = read(saved)["walls"][0] if saved.exists() else {"points": [[0, 0], [0, 0]]}
    check(abs(length(wall) - 2.5) < 1e-9, f"10: {typed} typed while drawing is 2.5 m", wall)
    plan.end()

# the flat, by mouse: four outer walls, two inner walls, doors, an exit, a person
plan = Plan("flat", minutes=9)
plan.keys("ctrl+n")
plan.until(lambda s: s["answer"]["title"] == "No plan yet" and s["floor"])
chain(plan, (-3, -2), (3, -2), (3, 2), (-3, 2), (-3, -2))
chain(plan, (0, -2), (0, 2))
chain(plan, (-3, 0), (3, 0))
plan.keys("d")
for place in ((0, 1), (0, -1), (-1.5, 0), (3, 1)):
    plan.put(*place)
# 13: numbers change while a door is dragged, the clock is paused, Escape restores the plan
plan.keys("Escape", "Escape", "Escape")
plan.put(0, 1)
plan.move(-2.8, -2.6)
state = plan.until(stage.is_settled)
chosen = plan.shot("chosen")
plan.drag(0, 1, 0, 0.7, release=False)
held = plan.state()
check(held["gesture"]["active"] and held["held"] and gesture_words(held, "dimension"),
      "13: dragged, a door tells its distances and the clock is held", held["gesture"])
plan.shot("dragged")
plan.keys("Escape")
plan.release()
plan.move(-2.8, -2.6)
let_go = plan.until(lambda s: not s["gesture"]["active"] and stage.is_settled(s))
after = plan.shot("after")
check(let_go["undo_name"] == state["undo_name"] and differing(chosen, after, state["frame"]["view"]) == 0,
      "13: Escape leaves the plan as it was", (let_go["gesture"], differing(chosen, after, state["frame"]["view"])))
plan.keys("Escape", "Escape")

plan.keys("x")
plan.put(3, 1)
plan.keys("p")
plan.put(-2, -1)
plan.keys("Escape", "Escape", "Escape")
drawn = plan.until(lambda s: s["answer"]["title"].startswith("Out in") and not s["answer"]["stale"])
check(drawn["answer"]["title"].startswith("Out in"), "a flat of four rooms, drawn by mouse, is left", drawn["answer"])
shot = plan.shot("flat")
first = plan.place / "flat.json"
plan.save_as(first)
house = read(first)
check(len(house["walls"]) == 3 and len(house["doors"]) == 4 and len(house["exits"]) == 1 and len(house["people"]) == 1,
      "it is saved with its walls, doors, exit and person", {k: len(v) for k, v in house.items() if isinstance(v, list)})
check(plan.state()["shown_title"] == "new house", "what is saved is not said to be edited", plan.state()["shown_title"])

check(drawn["undo_name"] and drawn["edits"] >= 8, "14: each of the steps can be undone", drawn["edits"])

# 14: undo and redo restore the same bytes
plan.undo_all()
empty = plan.place / "empty.json"
plan.save_as(empty)
check(not read(empty).get("walls") and not read(empty).get("people"), "14: all of it undone is an empty plan")
plan.redo_all()
again = plan.place / "again.json"
plan.save_as(again)
check(first.read_bytes() == again.read_bytes(), "14: undone and done again it has the same bytes")

# 12: snapping is named, and can be switched off
plan.keys("w")
plan.put(-2.5, 1.5)
plan.move(0.04, 1.97)
state = plan.state()
check(gesture_words(state, "snap"), "12: a snap is named", gesture_words(state, "snap"))
plan.hold("ctrl")
plan.move(0.045, 1.965)
free = plan.state()
plan.let_go("ctrl")
check(not gesture_words(free, "snap"), "12: with Ctrl held the hand is free", gesture_words(free, "snap"))
plan.keys("n")
off = plan.state()
check(off["snaps"] is False and "off" in (off["message"] or ""), "12: N says that snapping is off", off["message"])
plan.keys("n")
check(plan.state()["snaps"] is True, "12: N again, and it is on")
plan.keys("Escape", "Escape", "Escape")

# 15: click, move, click has the same effect as dragging
plan.put(0, 1)
plan.drag(0, 1, 0, 0.6)
plan.keys("Escape")
dragged = plan.place / "dragged.json"
plan.save_as(dragged)
plan.keys("ctrl+z")
plan.keys("Escape")
plan.put(0, 1)
plan.put(0, 1)
plan.move(0, 0.8)
plan.put(0, 0.6)
plan.keys("Escape")
clicked = plan.place / "clicked.json"
plan.save_as(clicked)
check(dragged.read_bytes() == clicked.read_bytes() and dragged.read_bytes() != first.read_bytes(),
      "15: click, move, click on a door does what dragging does")

# 16: a door stays on its wall, has limits, and can move to another wall
plan.keys("Escape", "Escape")
plan.put(-2.8, -2.6)
plan.drag(0, 0.6, 0, 1.95, release=False)
past = plan.state()
plan.release()
plan.keys("Escape", "Escape", "Escape")
check(past["gesture"].get("refusal") or "at" in past["gesture"]["doing"], "16: past the end of its wall it stops",
      past["gesture"])
plan.end()

# 16 to 19: numbers and texts of a wide house, with a script that presses the same keys
house = stage.house("closed-door")
seen = stage.act("limits", f'open "{house}"', "until complete", "set door.d1.width 9", "wait 5", "state STATE",
                 "set door.d1.width 0.6", "wait 5", "until answered", "until idle", "state STATE", "set door.d1.width 0.9",
                 "until answered", "wait 10", "state STATE", "key Ctrl+Z", "until answered", "state STATE")
check(len(seen) == 4 and "9" in (seen[0]["message"] or "") and seen[0]["parameters"]["door.d1.width"] != 9,
      "16: a door of 9 m is refused with its limits", seen[0]["message"] if seen else None)
answer = seen[1]["answer"]
told = subprocess.run([str(stage.program), "check", house, "--set", "door.d1.width=0.6"], capture_output=True, text=True,
                      timeout=600)
check("door" in answer["title"], "18: too narrow, the answer names the door", answer)
print("     18: seen", answer["title"], "|", answer["detail"], "| check says", told.stdout.strip()[:300])
check("before" in seen[2]["answer"]["detail"], "19: after the first edit what was before is compared unasked",
      seen[2]["answer"])
check(seen[3]["answer"]["title"] == seen[1]["answer"]["title"], "19: undone it is as it was", seen[3]["answer"])

# 17: keys turn and topple furniture
seen = stage.act("furniture", "until complete", "pause", "wait 5", "at 9.2 8.7", "press", "release", "wait 3",
                 "state STATE", *["key E", "wait 2"] * 6, "state STATE", "key Ctrl+Z", "key Ctrl+Z", "key Ctrl+Z",
                 "key Ctrl+Z", "key Ctrl+Z", "key Ctrl+Z", "wait 3", "key T", "wait 50", "state STATE",
                 "picture FOLDER/toppled.png", "key T", "wait 5", "key Ctrl+Z", "key Ctrl+Z", "wait 5",
                 "until answered", "state STATE")
check(seen and seen[0]["selection"], "17: a wardrobe is selected by a click", seen[0]["selection"] if seen else None)
check(len(seen) == 4 and seen[1]["edits"] + seen[1]["messages"] > 0, "17: E turns it, or says why it cannot",
      (seen[1]["edits"], seen[1]["message"]))
print("     17: after E x6:", seen[1]["undo_name"], "|", seen[1]["message"], "; after T:", seen[2]["undo_name"], "|",
      seen[2]["message"])
check(seen[3]["digest"] == seen[0]["digest"] and not seen[3]["undo_name"], "17: undone, all is as before",
      (seen[3]["undo_name"], seen[3]["digest"], seen[0]["digest"]))

# falling furniture is animated, and comes to rest where it does without animation; nobody is in the room, so that no
# answer changes the picture
room = stage.folder / "room.json"
room.write_text(json.dumps({
    "format": "clearance-house", "version": 1, "name": "room",
    "walls": [{"id": "w1", "points": [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]}],
    "doors": [{"id": "d1", "wall": "w1", "segment": 1, "at": 2, "width": 1.0}],
    "furniture": [{"id": f"f{i}", "name": "shelf", "centre": [0.7 + 1.1 * i, 3.7], "size": [0.8, 0.4], "height": 1.2,
                   "topples": "front"} for i in range(4)],
    "exits": [{"id": "e1", "from": [6.5, 1.4], "to": [6.5, 2.6]}]}))


def falls(name, view, *arguments):
    """Topples a shelf, shakes the house, and takes pictures; returns how many pixels differ from one to the next."""
    rest = ["until idle", "wait 5"]
    seen = stage.act(name, "until complete", "pause", "seek 0", *view, "at 0.7 3.7", "press", "release", "wait 3",
                     "at 4.5 -1", *rest, "view FOLDER/0.png", "key T", "until answered", "view FOLDER/1.png", "wait 2",
                     "view FOLDER/2.png", "state STATE", *rest, "view FOLDER/3.png", "wait 20", "view FOLDER/4.png",
                     "state STATE", "key Shift+T", "wait 15", "state STATE", "picture FOLDER/shake.png", *rest,
                     "view FOLDER/5.png", "state STATE", "key Ctrl+Z", *rest, "view FOLDER/6.png", arguments=[*arguments,
                     str(room)])
    place = stage.folder / name
    return seen, [differing(place / f"{i}.png", place / f"{i + 1}.png", fuzz="0") for i in range(6)]


for view, keys in (("flat", ()), ("raised", ("key V", "wait 5"))):
    seen, steps = falls(f"falls-{view}", keys)
    still, jumps = falls(f"falls-{view}-still", keys, "--reduced-motion")
    check(len(seen) == 4 and seen[0]["animation"] == "" and steps[1] > 0, f"{view}: a piece is seen to fall", steps)
    check(seen[1]["animation"] is None and steps[3] == 0, f"{view}: then it rests", steps)
    check(seen[2]["animation"] == "shaking (seed 1)" and seen[3]["animation"] is None and
          seen[3]["message"].startswith("Shake 1: fallen pieces: ") and seen[3]["message"].endswith(" of 4"),
          f"{view}: a shake says its seed while it lasts, then what fell", [s["animation"] for s in seen])
    check(jumps[1] == jumps[3] == 0 and all(s["animation"] is None for s in still),
          f"{view}: with --reduced-motion nothing is seen to fall", jumps)
    pairs = [differing(stage.folder / f"falls-{view}" / f"{i}.png", stage.folder / f"falls-{view}-still" / f"{i}.png",
                       fuzz="0") for i in (3, 5, 6)]
    check(pairs == [0, 0, 0], f"{view}: at rest both are the same to the pixel", pairs)

# 11: the same flat by keys alone, guided by the strip's texts
def numbers(plan, *values):
    """Types values into the fields of the gesture and completes it."""
    for i, value in enumerate(values):
        if i:
            plan.keys("Tab")
        plan.type(value)
    plan.keys("Return")


def walls(plan, start, *sides):
    plan.keys("w", "Return")
    numbers(plan, *start)
    for side in sides:
        numbers(plan, *side)
    plan.keys("Escape", "Escape", "Escape")


plan = Plan("keys", minutes=9)
plan.point_to(0, 0)
plan.keys("ctrl+n")
plan.until(lambda s: s["answer"]["title"] == "No plan yet" and s["floor"])
walls(plan, ("-3", "-2"), ("6", "0"), ("4", "90"), ("6", "180"), ("4", "-90"))
walls(plan, ("0", "-2"), ("4", "90"))
walls(plan, ("-3", "0"), ("6", "0"))
for place in (("0", "1"), ("0", "-1"), ("-1.5", "0"), ("3", "1")):
    plan.keys("d", "Return")
    numbers(plan, *place)
    plan.keys("Escape", "Escape")
plan.keys("x", "Return")
numbers(plan, "3", "1")
plan.keys("Escape", "Escape", "p", "Return")
numbers(plan, "-2", "-1")
plan.keys("Escape", "Escape", "Escape")
done = plan.until(lambda s: s["answer"]["title"].startswith("Out in") and not s["answer"]["stale"])
plan.shot("keys")
check(done["answer"]["title"].startswith("Out in"), "11: the flat is drawn, and left, by keys alone",
      (done["answer"], done["edits"], done["undo_name"]))
plan.keys("F9")
told = plan.until(lambda s: (s["message"] or "").startswith("Written: "))["message"] or ""
picture = told.removeprefix("Written: ").split(",")[0]
check(picture.endswith(".png") and open(picture, "rb").read(8) == b"\x89PNG\r\n\x1a\n", "11: F9 writes its picture", told)
about = read(pathlib.Path(picture).with_suffix(".json"))
check(about["command"] is None, "no command is told of a house that no file holds", about)
plan.keys("shift+F9")
written = pathlib.Path(picture).parent / "new-house.house.json"
plan.until(lambda s: "frames (" in (s["message"] or ""))
check(written.exists() and len(read(written)["walls"]) == 3, "a house that no file holds is written beside its frames", written)
typed = plan.place / "keys.json"
plan.save_as(typed)
house = read(typed) if typed.exists() else {}
counts = [len(house.get(part, [])) for part in ("walls", "doors", "exits", "people")]
check(counts == [3, 4, 1, 1], "11: saved by keys alone: three chains of walls, four doors, an exit, a person", counts)
plan.undo_all()
plan.redo_all()
plan.save_as(plan.place / "again.json")
check(typed.read_bytes() == (plan.place / "again.json").read_bytes(), "14: undone and redone by keys: the same bytes")
plan.end()

stage.end()
