#!/usr/bin/env python3
"""Tests that only what people do in a house moves while it is watched: furniture and people are dragged, but walls, doors,
rooms and exits are not; the window says so, and with Edit plan, or after a tool key, they are dragged, too."""

import json

import stage
from stage import act, check

HOUSE = stage.folder / "house.json"
HOUSE.write_text(json.dumps({
    "format": "clearance-house", "version": 1, "name": "two rooms",
    "walls": [{"id": "w1", "points": [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]}, {"id": "w2", "points": [[3, 0], [3, 4]]}],
    "doors": [{"id": "d1", "wall": "w2", "at": 2, "width": 0.9, "kind": "hinged", "swing": "right"},
              {"id": "d2", "wall": "w1", "segment": 1, "at": 2, "width": 1.0, "kind": "opening"}],
    "furniture": [{"id": "f1", "name": "wardrobe", "centre": [1.3, 3.5], "size": [0.8, 0.5], "height": 1.2}],
    "rooms": [{"id": "r1", "name": "bedroom", "outline": [[0, 0], [3, 0], [3, 4], [0, 4]]}],
    "exits": [{"id": "e1", "from": [6.8, 1.4], "to": [6.8, 2.6]}],
    "people": [{"id": "p1", "profile": "manual-chair", "at": [0.8, 2.0]}]}))

THINGS = {"walls": (3, 0.6), "doors": (3, 2), "exits": (6.8, 2.3), "wardrobe": (1.3, 3.5), "person": (0.8, 2)}


def drag(x, y):
    """Selects an item, and drags it or its handle at the same place; looks before and after the release."""
    return [f"at {x} {y}", "press", "release", "wait 2", f"at {x} {y}", "press", f"at {x + 0.06} {y + 0.1}",
            f"at {x + 0.12} {y + 0.2}", "wait 2", "state STATE", "release", "wait 2", "state STATE", "key Escape", "key Escape",
            "key Escape", "key Ctrl+Z", "wait 2"]


for manner, keys in (("watching", []), ("editing", ["key Ctrl+J"]), ("after a tool", ["key W", "key Escape"])):
    found = act(manner.replace(" ", "-"), "until answered", "key 1", "key 1", "pause", "seek 0", *keys, "wait 3",
                *[line for place in THINGS.values() for line in drag(*place)],
                arguments=[HOUSE, "--size", "1280x720"])
    for name, held, left in zip(THINGS, found[::2], found[1::2]):
        moves = manner != "watching" or name in ("wardrobe", "person")
        moved = left["undo_name"] is not None
        check(moved == moves, f"{manner}: {name}: dragged {'it moves' if moves else 'it stays'}", left["undo_name"])
        check(held.get("refused") == (not moves) and not left.get("refused"), f"{manner}: {name}: the pointer tells", held.get("refused"))
        if not moves:
            check((held["message"] or "") == f"{name} are fixed while watching: Edit plan (W)", f"{manner}: {name}: words say why",
                  held["message"])
        check(moves or not any(mark["kind"] == "handle" for mark in held["gesture"]["marks"]), f"{manner}: {name}: no handles",
              held["gesture"]["marks"])

# nor by the arrow keys
for name, item, moves in (("walls", "wall w2", False), ("doors", "door d1", False), ("person", "person p1", True)):
    found = act(f"keys-{name}", "until answered", "pause", f'select "{item}"', "wait 3", "key Left", "wait 5", "state STATE",
                arguments=[HOUSE, "--size", "1280x720"])
    check((found[0]["undo_name"] is not None) == moves, f"watching: {name}: arrows move {'it' if moves else 'nothing'}",
          found[0]["undo_name"])
    check(moves or found[0]["message"] == f"{name} are fixed while watching: Edit plan (W)", f"watching: {name}: words say why",
          found[0]["message"])

# the width of a door is edited in the panel all the same
found = act("width", "until answered", "pause", 'select "door d1"', "wait 3", "key Return", "wait 5", "key Left", "wait 5",
            "until answered", "state STATE", arguments=[HOUSE, "--size", "1280x720"])
check(found[0]["undo_name"] and not found[0]["editing"], "while watching a door's width is edited in the panel",
      found[0]["undo_name"])
stage.end()
