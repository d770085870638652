#!/usr/bin/env python3
"""Tests the view as its user's hand and eye: it is moved by its floor, what is selected is framed where it is, exits that
have closed are seen, and nothing is played where nobody moves."""

import json

import stage
from stage import act, check

DARK, GREEN = 60, (0, 158, 115)


def pixel(state, at):
    origin, right, up = state["floor"]
    return [origin[i] + at[0] * (right[i] - origin[i]) + at[1] * (up[i] - origin[i]) for i in (0, 1)]


def around(state, at, reach):
    x, y = pixel(state, at)
    return [x - reach, y - reach, x + reach, y + reach]


def dragged(a, b):
    """Drags with the left button, as a hand does, in several frames."""
    steps = [[a[i] + (b[i] - a[i]) * part for i in (0, 1)] for part in (0.2, 0.6, 1)]
    return [f"mouse {a[0]} {a[1]}", "wait 3", "press", "wait 3",
            *[line for at in steps for line in (f"mouse {at[0]} {at[1]}", "wait 3")], "release", "wait 10", "state STATE"]


# the floor moves the view, a piece of furniture itself
start = act("start", "until answered", "pause", "wait 5", "state STATE", arguments=["--size", "1280x720"])[0]
floor, sofa = pixel(start, (5.3, 3.2)), pixel(start, (3.55, 1.5))
moved = act("floor", "until answered", "pause", "wait 5", *dragged(floor, (floor[0] + 90, floor[1] + 60)),
            *dragged((sofa[0] + 90, sofa[1] + 60), (sofa[0] + 140, sofa[1] + 60)), arguments=["--size", "1280x720"])
shift = [b - a for a, b in zip(start["floor"][0], moved[0]["floor"][0])]
check(abs(shift[0] - 90) < 3 and abs(shift[1] - 60) < 3 and moved[0]["edits"] == 0 and not moved[0]["selected"],
      "dragging the floor moves the view, and nothing else", (shift, moved[0]["edits"], moved[0]["selected"]))
check(moved[1]["floor"] == moved[0]["floor"] and moved[1]["edits"] == 1 and moved[1]["selected"] == "sofa",
      "dragging a sofa moves the sofa", (moved[1]["edits"], moved[1]["selected"]))

# a wall is framed between its doors, and named at itself
framed = act("wall", "until answered", "pause", 'select "wall w2"', "wait 5", "state STATE", "picture FOLDER/wall.png",
             'select "wall w1"', "wait 5", "state STATE", 'select "exit garden"', "wait 5", "state STATE",
             arguments=["--size", "1280x720"])
open_door = stage.colours(stage.folder / "wall" / "wall.png", around(framed[0], (1.95, 4.095), 8))
dark = sum(count for count, colour in open_door if max(colour) < DARK)
check(dark == 0, "the frame of a wall leaves its doors open", open_door[:4])
label = next(t for t in framed[1]["text_in_view"] if t["kind"] == "selected")
inner, far = around(framed[1], (5.46, 4.5), 0), 30
check(not (label["box"][0] - far < inner[0] < label["box"][2] + far and label["box"][1] - far < inner[1] < label["box"][3] + far),
      "the walls round a house are named at one of them, not in the middle", label)
check(not [t for t in framed[2]["text_in_view"] if t["kind"] == "selected"], "an exit is named once, by its sign",
      framed[2]["text_in_view"])

# an exit is grey once it has closed
house = json.loads(open(stage.house("ube-techno-house")).read())
house["exits"][0]["closes"] = 10
closing = stage.folder / "closing.json"
closing.write_text(json.dumps(house))
seen = act("closing", "until answered", "pause", "seek 5", "wait 5", "state STATE", "picture FOLDER/open.png", "seek 25", "wait 5",
           "picture FOLDER/closed.png", arguments=[closing, "--size", "1280x720"])[0]
at = around(seen, (11.05, 4.9), 3)
shown = [stage.colours(stage.folder / "closing" / f"{name}.png", at)[0][1] for name in ("open", "closed")]
check(shown[0][1] > shown[0][0] + 60 and max(shown[1]) - min(shown[1]) < 40, "an exit that has closed is grey", shown)

# nothing is played where nobody can move
empty = act("empty", "key Ctrl+N", "until idle", "wait 5", "key Space", "wait 5", "state STATE", "texts STATE")
check(not empty[0]["playing"] and empty[0]["message"] == "There is nothing to play yet." and
      "PAUSED" not in [t["string"] for t in empty[1]], "an empty plan is not played, nor paused", empty[0]["message"])

# a hidden panel opens in a smaller window, and the letters on the tools work there as well
small = act("panel", "until answered", "pause", "key H", "wait 5", "resize 1024 700", "wait 5", "key H", "wait 5", "state STATE",
            "key H", "wait 5", "state STATE", arguments=["--size", "1280x720"])
check([state["frame"]["panel"][2] > state["frame"]["panel"][0] for state in small] == [True, False],
      "a panel that was hidden beside a larger view opens over a smaller one", [state["frame"]["panel"] for state in small])
tools = act("tools", "until answered", "pause", "key Ctrl+J", "wait 5", *["key F6", "wait 3", "state STATE"] * 6,
            arguments=["--size", "1280x720"])
steps = next(i for i, state in enumerate(tools) if state["focus"].startswith("rail") or "select" in (state["focus"] or ""))
letter = act("letter", "until answered", "pause", "key Ctrl+J", "wait 5", *["key F6", "wait 3"] * (steps + 1), "key O", "wait 5",
             "state STATE", arguments=["--size", "1280x720"])[0]
check(letter["tool"] == "furniture", "a letter takes up its tool while the toolbar has the focus", (letter["tool"], letter["focus"]))
stage.end()
