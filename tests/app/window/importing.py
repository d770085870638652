#!/usr/bin/env python3
"""Tests other programs' drawings in the window, with a real mouse and keyboard: a drawing whose header lies about its
unit, the typed distance between two points, names of blocks, and how few actions a flat needs until it runs."""

import stage
from stage import check


def groups(*pairs):
    return "".join(f"{code}\n{value}\n" for code, value in pairs)


def line(layer, x0, y0, x1, y1):
    return groups((0, "LINE"), (8, layer), (10, x0), (20, y0), (11, x1), (21, y1))


def room(width, height, gap):
    """Returns walls around a room with a gap in its lower wall, which ends there at half its width."""
    corners = [(width / 2 + gap, 0), (width, 0), (width, height), (0, height), (0, 0), (width / 2, 0)]
    return "".join(line("A-WALL", *a, *b) for a, b in zip(corners, corners[1:]))


def drawing(name, entities, blocks="", unit=4):
    path = stage.folder / name
    path.write_text(groups((0, "SECTION"), (2, "HEADER"), (9, "$INSUNITS"), (70, unit), (0, "ENDSEC"), (0, "SECTION"),
                           (2, "BLOCKS")) + blocks + groups((0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")) + entities +
                    groups((0, "ENDSEC"), (0, "EOF")))
    return path


TUB = "xref-Bishop-Overland-08$0$FIXT-OVALBATH"


def block(width, height):
    return (groups((0, "BLOCK"), (2, TUB)) + line("0", 0, 0, width, 0) + line("0", width, 0, width, height) +
            groups((0, "ENDBLK")))


def insert(x, y):
    return groups((0, "INSERT"), (8, "FURN"), (2, TUB), (10, x), (20, y))


def extent(state, axis):
    values = [v for name, v in state["parameters"].items() if name.startswith("furniture.") and name.endswith(f"size.{axis}")]
    return values[0] if values else None


def place(state, x, y):
    """Returns the pixel of a place on the floor, m."""
    origin, right, up = state["floor"]
    return (origin[0] + x * (right[0] - origin[0]) + y * (up[0] - origin[0]),
            origin[1] + x * (right[1] - origin[1]) + y * (up[1] - origin[1]))


# the header says millimetres, the plan is drawn in inches, and it has no doors: the window asks, inches come first
liar = drawing("liar.dxf", room(480, 360, 36) + insert(40, 300), block(66, 30))
screen = stage.Screen("liar", liar)
state = screen.until(lambda s: s["sheet"] == "unit")
check(state["sheet"] == "unit", "a drawing whose unit is in doubt: the window asks how large it is", state["sheet"])
screen.shot("asked")
screen.keys("Return")
state = screen.until(lambda s: s["sheet"] == "none" and extent(s, "x"))
check(abs((extent(state, "x") or 0) - 66 * 0.0254) < 1e-6, "Return takes the likeliest size, that of inches", extent(state, "x"))
names = [t["string"] for t in state["text_in_view"]]
check("bath tub" in names and not any("xref" in n or "$" in n for n in names), "a block is called by its kind", names)

# a typed distance between two clicked points sets the scale of the house
screen.keys("m")
state = screen.state()
state = screen.until(lambda s: s["frame"]["rail"][2] > 0)
panel = state["frame"]["panel"]
screen.click(panel[0] + 90, panel[1] + 93)
state = screen.state()
screen.click(*place(state, 0, 0))
screen.click(*place(state, 12.192, 0))
state = screen.state()
check("as drawn" in state["gesture"]["doing"], "after two points it asks for the real length", state["gesture"]["doing"])
screen.shot("typing")
screen.type("6.096")
screen.keys("Return")
state = screen.until(lambda s: abs((extent(s, "x") or 0) - 33 * 0.0254) < 1e-3)
check(abs((extent(state, "x") or 0) - 33 * 0.0254) < 1e-3, "the typed length scales the whole house", extent(state, "x"))
screen.shot("scaled")
screen.keys("ctrl+z")
state = screen.until(lambda s: abs((extent(s, "x") or 0) - 66 * 0.0254) < 1e-6)
check(abs((extent(state, "x") or 0) - 66 * 0.0254) < 1e-6, "one undo takes it back", extent(state, "x"))
screen.end()

# a flat of a sure unit runs after five actions: opening it, two for an exit, two for a person
flat = drawing("flat.dxf", room(6000, 4000, 900) + insert(600, 3300), block(1700, 750))
screen = stage.Screen("flat", flat)
state = screen.state()
check(state["sheet"] == "none", "a drawing whose unit is sure is opened at once", state["sheet"])
screen.keys("x")
state = screen.state()
screen.click(*place(state, 3.45, 0))
screen.keys("p")
state = screen.state()
screen.click(*place(state, 1.5, 2))
state = screen.until(lambda s: s.get("complete") and s["answer"]["title"].startswith("Out in"))
check(state["answer"]["title"].startswith("Out in"), "an imported flat runs after five actions", state["answer"])
screen.shot("runs")
screen.end()

# another house is open: five actions from the file dialog, where one opening leads outside; undo knows each of them
screen = stage.Screen("dialog", stage.house("closed-door"))
screen.until(lambda s: s.get("complete"))
screen.keys("ctrl+o")
screen.type(str(flat))
screen.keys("Return")
state = screen.until(lambda s: s["answer"]["cure"] == "Add an exit")
screen.keys("Return")
state = screen.until(lambda s: s["answer"]["cure"] == "Place somebody")
check(state["tool"] == "person" and state["undo_name"] == "Place exit",
      "the only opening gets the exit, and the tool for people follows", (state["tool"], state["undo_name"]))
screen.shot("exit")
screen.click(*place(state, 1.5, 2))
state = screen.until(lambda s: s.get("complete") and s["answer"]["title"].startswith("Out in"))
check(state["answer"]["title"].startswith("Out in") and state["edits"] == 2,
      "from the file dialog an imported flat runs after five actions", (state["answer"], state["edits"]))
screen.shot("out")
screen.end()

# two openings lead outside: the house asks on which, and then for somebody
two = drawing("two.dxf", room(6000, 4000, 900).replace(line("A-WALL", 0, 4000, 0, 0), line("A-WALL", 0, 4000, 0, 2500) +
                                                       line("A-WALL", 0, 1500, 0, 0)))
screen = stage.Screen("two", two)
state = screen.until(lambda s: s["answer"]["cure"] == "Add an exit")
screen.keys("Return")
state = screen.state()
check(state["tool"] == "exit" and not state["edits"], "two openings: the tool for exits", (state["tool"], state["edits"]))
screen.click(*place(state, 0, 2))
state = screen.until(lambda s: s["answer"]["cure"] == "Place somebody")
check(state["tool"] == "person", "once the exit lies there, the tool for people follows", state["tool"])
screen.keys("Escape", "x")
screen.click(*place(state, 3.45, 0))
state = screen.until(lambda s: s["edits"] == 2)
check(state["tool"] == "exit", "a tool that was taken by its own key stays", state["tool"])
screen.end()
stage.end()
