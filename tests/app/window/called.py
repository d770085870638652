#!/usr/bin/env python3
"""Tests that the window calls doors, walls, furniture and people by their names, never by the ids of the file: after
edits, while something is dragged, with each tool in hand, and in the undo history. Only the panel's field of the id has
it."""

import json
import pathlib
import re

import stage
from stage import act, check

MANY = 60  # people of the largest house that is tested


def along(plan, door):
    """Returns the middle of a door's opening, m."""
    (ax, ay), (bx, by) = next(w["points"] for w in plan["walls"] if w["id"] == door["wall"])[door.get("segment", 0):][:2]
    part = door["at"] / ((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5
    return ax + part * (bx - ax), ay + part * (by - ay)


def ids_of(plan):
    """Returns the ids that are no words: w1, p-a, chair-1."""
    found = [e["id"] for kind in ("walls", "doors", "furniture", "people", "rooms") for e in plan.get(kind, [])]
    return [id for id in found if re.search(r"[0-9]|^p-", id)]


def drag(x, y, to_x, to_y):
    return [f"at {x} {y}", "wait 1", "press", f"at {(x + to_x) / 2} {(y + to_y) / 2}", f"at {to_x} {to_y}", "wait 3", *LOOK,
            "release", "wait 3", *LOOK, "key Escape", "key Escape"]


LOOK = ["texts FOLDER/texts", "state STATE"]


def steps_of(plan):
    """Returns the lines of a script that edits a house in many ways, and looks after each."""
    steps = []
    for door in plan.get("doors", [])[:3]:
        x, y = along(plan, door)
        steps += [f'select "door {door["id"]}"', "wait 2", "key Right", "key Up", "wait 3", *LOOK, *drag(x, y, x + 0.1, y + 0.1)]
    wall = plan["walls"][0]["points"]
    middle = [(wall[0][i] + wall[1][i]) / 2 for i in (0, 1)]
    steps += [*drag(*middle, middle[0] + 0.05, middle[1] + 0.05), "key Shift+W", "wait 3", *LOOK]
    for piece in plan.get("furniture", [])[:3]:
        x, y = piece["centre"]
        steps += drag(x, y, x + 0.15, y + 0.1) + ["key Left", "key T", "key E", "wait 3", *LOOK]
    for person in plan.get("people", [])[:2]:
        x, y = person["at"]
        steps += drag(x, y, x + 0.1, y) + [f'select "person {person["id"]}"', "wait 2", "key Left", "wait 3", *LOOK]
    for tool in "DWXP":
        steps += [f"key {tool}", f"at {middle[0]} {middle[1]}", "wait 3", *LOOK, f"at {wall[0][0] + 0.02} {wall[0][1]}",
                  "wait 3", *LOOK, "key Escape", "key Escape"]
    return steps + ["key Ctrl+Shift+H", "wait 4", *LOOK]


for path in sorted(pathlib.Path(stage.source / "houses").glob("*.json")):
    plan = json.loads(path.read_text())
    if plan.get("crowds") or len(plan.get("people", [])) > MANY or path.stem.startswith("corner-1"):
        continue
    found = act(path.stem, "until answered", "pause", "key Ctrl+J", "wait 3", *steps_of(plan),
                arguments=[str(path), "--size", "1280x720"])
    looks = stage.states(stage.folder / path.stem / "texts")
    wrong, internal = {}, re.compile(r"-chair\b|xref|ghost|locus|(?<![\w.-])(" + "|".join(map(re.escape, ids_of(plan))) + r")(?![\w-])")
    for texts, state in zip(looks, found):
        fields = [t["box"] for t in texts if t["string"] == "id" and t["box"][0] > state["frame"]["panel"][0]]
        words = [t["string"] for t in texts
                 if not any(0 < t["box"][1] - field[1] < 40 and t["box"][0] > field[0] for field in fields)]
        words += [t["string"] for t in state["text_in_view"]] + [cell for row in state["rows"] for cell in row]
        gesture = state["gesture"] or {}
        words += [str(state.get(key)) for key in ("undo_name", "redo_name", "message", "hovered")]
        words += [str(gesture.get(key)) for key in ("doing", "refusal")]
        for word in words:
            if internal.search(word):
                wrong.setdefault(word, state["undo_name"])
    check(looks and len(looks) == len(found), f"{path.stem}: the texts are written", (len(looks), len(found)))
    check(any(state["undo_name"] for state in found), f"{path.stem}: it is edited")
    check(any(state["gesture"]["active"] for state in found), f"{path.stem}: something is dragged")
    check(not wrong, f"{path.stem}: nothing is called by its id", list(wrong)[:12])
stage.end()
