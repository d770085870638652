#!/usr/bin/env python3
"""Tests the importers against plans of known size, in the shapes that other programs write: areas and corners of rooms,
widths and places of doors, to 1 mm, also turned, mirrored and far from the origin.

truth.py CLEARANCE
"""

import json
import math
import pathlib
import re
import tempfile
import zipfile

from drawn_dxf import Drawing
from drawn_files import area, home, scenario
from drawn_flat import Flat, Placing, box, crossing, flat
from program import check, end, expect

MILLIMETRE = 0.001

place = tempfile.TemporaryDirectory()
folder = pathlib.Path(place.name)


def import_file(name, content, *options, code=0, says=""):
    """Imports a file; returns the answer with the house and the shift of the plan, or None if the file is refused."""
    file, out = folder / name, folder / "house.json"
    out.unlink(missing_ok=True)
    if name.endswith(".sh3d"):
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("Home.xml", content)
    else:
        file.write_text(content)
    done = expect(code, "import", str(file), str(out), "--json", *options, says=says)
    if code or done.returncode:
        check(len(done.stderr.splitlines()) == 1 and not out.exists(), f"{name}: one line, no house", done.stderr)
        return None
    answer = json.loads(done.stdout)
    moved = next((m for note in answer["notes"] if (m := re.search(r"moved by \((\S+), (\S+)\) m", note))), None)
    answer["moved"] = tuple(map(float, moved.groups())) if moved else (0, 0)
    answer["house"] = json.loads(out.read_text())
    return answer


def noted(answer, part):
    check(any(part in note for note in answer["notes"]), f"a note contains {part!r}", answer["notes"])


def rings_of(wkt):
    """The outer rings of a geometry, and with them those of its holes."""
    return [[tuple(map(float, pair.split())) for pair in ring.split(",")] for ring in re.findall(r"\(([^()]+)\)", wkt)]


def area_of(ring):
    return abs(sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(ring, ring[1:] + ring[:1]))) / 2


def length_of(ring):
    return sum(math.dist(p, q) for p, q in zip(ring, ring[1:] + ring[:1]))


def check_rooms(what, answer, rooms, put):
    """With all doors locked, the exported area is the rooms."""
    house = folder / "locked.json"
    for door in answer["house"].get("doors", []):
        door["state"] = "locked"
    house.write_text(json.dumps(answer["house"]))
    rings = rings_of(expect(0, "export", str(house)).stdout)
    check(len(rings) == len(rooms), f"{what}: {len(rings)} rooms, expected {len(rooms)}", rings)
    left = list(rings)
    for room in rooms if len(rings) == len(rooms) else []:
        corners = [tuple(p + m for p, m in zip(put(corner), answer["moved"])) for corner in room]
        middle = tuple(sum(c[i] for c in corners) / len(corners) for i in range(2))
        ring = min(left, key=lambda r: abs(area_of(r) - area_of(corners)) + max(min(math.dist(c, p) for p in r) for c in corners))
        left.remove(ring)
        off = max(min(math.dist(corner, point) for point in ring) for corner in corners)
        check(off < MILLIMETRE, f"{what}: a corner of the room at {middle} is off by {off:.6f} m", ring)
        area = area_of([(p[0] - middle[0], p[1] - middle[1]) for p in ring])
        wanted = area_of([(c[0] - middle[0], c[1] - middle[1]) for c in corners])
        check(abs(area - wanted) < MILLIMETRE * length_of(corners), f"{what}: an area is {area:.4f} m2, expected {wanted:.4f} m2")


def door_ends(house, door):
    points = next(wall["points"] for wall in house["walls"] if wall["id"] == door["wall"])
    a, b = points[door.get("segment", 0)], points[door.get("segment", 0) + 1]
    along = [(q - p) / math.dist(a, b) for p, q in zip(a, b)]
    return [tuple(p + (door["at"] + side * door["width"] / 2) * d for p, d in zip(a, along)) for side in (-1, 1)]


def check_doors(what, answer, wanted, kind="hinged"):
    """`wanted` are the ends of the doors on the axes of their walls."""
    doors = answer["house"].get("doors", [])
    check(len(doors) == len(wanted), f"{what}: {len(doors)} doors, expected {len(wanted)}", answer["left_out"])
    left = list(wanted)
    for door in doors if len(doors) == len(wanted) else []:
        ends = [tuple(p - m for p, m in zip(end, answer["moved"])) for end in door_ends(answer["house"], door)]
        distance = lambda line: min(max(math.dist(ends[0], a), math.dist(ends[1], b)) for a, b in (line, line[::-1]))
        nearest = min(left, key=distance)
        left.remove(nearest)
        off = distance(nearest)
        check(off < MILLIMETRE, f"{what}: the door {door['id']} is off by {off:.6f} m", ends)
        check(door.get("kind", "opening") == kind, f"{what}: the door {door['id']} is {door.get('kind')}")


def door_lines(plan, put):
    """The ends of the openings on the axes of their walls."""
    lines = []
    for (x0, y0, x1, y1), *_ in plan.doors:
        wall = next(w for w in plan.walls if w[0] <= x0 and w[1] <= y0 and w[2] >= x1 and w[3] >= y1)
        upright = wall[3] - wall[1] > wall[2] - wall[0]
        x, y = (x0 + x1) / 2, (y0 + y1) / 2
        lines.append(tuple(map(put, ((x, y0), (x, y1)) if upright else ((x0, y), (x1, y)))))
    return lines


# Drawings -----------------------------------------------------------------------------------------------------------


def draw_double(plan, style, unit, says, put, as_block=False, doors=True):
    drawing = Drawing(style, unit, says, put)
    for a, b in plan.faces():
        drawing.line("A-WALL", a, b)
    for _, hinge, shut, opened in plan.doors if doors else []:
        drawing.door("A-DOOR", hinge, shut, opened, as_block)
    for x0, y0, x1, y1 in plan.windows:
        for y in (y0, (y0 + y1) / 2, y1):
            drawing.line("A-GLAZ", (x0, y), (x1, y))
    return drawing


PLACINGS = {"plain": Placing(), "turned": Placing(31.7), "mirrored": Placing(0, (12.3, 0), True),
            "far": Placing(0, (412345.678, 987654.321)), "turned and far": Placing(17.3, (412345.678, 987654.321)),
            "mirrored, turned and far": Placing(-63.1, (-212345.678, 587654.321), True)}


def check_double_lines():
    for name, plan in (("flat", flat()), ("crossing", crossing())):
        for where, put in PLACINGS.items():
            for style, unit, as_block in (("r12", "mm", False), ("r2000", "cm", True), ("librecad", "m", False), ("qcad", "inch", True)):
                what = f"{name}, {where}, {style}, {unit}"
                answer = import_file("double.dxf", str(draw_double(plan, style, unit, unit, put, as_block)))
                if not answer:
                    continue
                noted(answer, f"the unit is {unit}, as the file says")
                noted(answer, "walls drawn as two lines became walls")
                check_doors(what, answer, door_lines(plan, put))
                check_rooms(what, answer, plan.rooms, put)


def check_outlines():
    """Faces as closed polylines: one for each room and one around the house, without doors."""
    for style in ("r12", "librecad"):
        for where, put in PLACINGS.items():
            plan = flat()
            drawing = Drawing(style, "mm", "mm", put)
            for outline in plan.rooms + [box(0, 0, 10, 7)]:
                drawing.polyline("WALLS", outline)
            answer = import_file("outlines.dxf", str(drawing))
            check_rooms(f"outlines, {where}, {style}", answer, plan.rooms, put)


def check_single_lines():
    """Centre lines with gaps for doors, as in sketches; the area of a room reaches to the lines."""
    for where, put in PLACINGS.items():
        drawing = Drawing("qcad", "cm", "cm", put)
        for a, b in (((0, 0), (2, 0)), ((2.9, 0), (8, 0)), ((8, 0), (8, 5)), ((8, 5), (0, 5)), ((0, 5), (0, 0)), ((5, 0), (5, 2)),
                     ((5, 2.8), (5, 5))):
            drawing.line("Wand", a, b)
        drawing.door("Tuer", (2, 0), (2.9, 0), (2, 0.9))
        drawing.door("Tuer", (5, 2.8), (5, 2), (4.2, 2.8))
        answer = import_file("single.dxf", str(drawing))
        noted(answer, "walls are the lines that are drawn")
        check_doors(f"single lines, {where}", answer, [tuple(map(put, ends)) for ends in (((2, 0), (2.9, 0)), ((5, 2), (5, 2.8)))])
        check_rooms(f"single lines, {where}", answer, [box(0, 0, 5, 5), box(5, 0, 8, 5)], put)


def check_units():
    """The dimensions decide, then the doors; a header with a false unit is noted."""
    plan, put = flat(), Placing(17.3, (41.2, -9.7))
    for unit, text in (("inch", "32'-9 3/4\""), ("mm", "10.00 m"), ("cm", "10000"), ("m", "10 000 mm"), ("ft", "10000")):
        for says in (None, "cm", "inch"):
            for in_block in (False, True):
                drawing = draw_double(plan, "r2000", unit, says, put, doors=False)
                drawing.dimension((0, -1), (10, -1), text.replace("10 000", "10000"), in_block)
                if text.isdigit():  # a single number may be chance
                    drawing.dimension((-1, 0), (-1, 7), "7000", in_block)
                what = f"dimensions, {unit}, the header says {says}"
                answer = import_file("dimensions.dxf", str(drawing))
                if not answer:
                    continue
                noted(answer, f"the unit is {unit}, as the dimensions say")
                check((says in (None, unit)) == (not any("the file says" in note for note in answer["notes"])), what, answer["notes"])
                check_doors(what, answer, door_lines(plan, put), "opening")
                check_rooms(what, answer, plan.rooms, put)
    for unit in ("mm", "cm", "m", "inch", "ft"):
        answer = import_file("doors.dxf", str(draw_double(plan, "qcad", unit, None, put)))
        noted(answer, f"the unit is {unit}, as the doors say")
        check_rooms(f"the doors say {unit}", answer, plan.rooms, put)
    exploded = draw_double(plan, "librecad", "inch", "mm", Placing(), doors=False)
    for a, b, text, turned in (((0, -1), (10, -1), "32'-9 3/4\"", 0), ((-1, 0), (-1, 7), "22'-11 5/8\"", 90)):
        exploded.line("0", a, b)
        exploded.text("TEXT", ((a[0] + b[0]) / 2 - 0.1 * (turned > 0), (a[1] + b[1]) / 2 + 0.1 * (turned == 0)), 0.2, text, turned)
    answer = import_file("exploded.dxf", str(exploded))
    noted(answer, "the unit is inch, as the dimensions say: 32'-9 3/4\" measures 393.701")
    check_rooms("exploded dimensions", answer, plan.rooms, Placing())
    lines = [((0, 0), (8, 0)), ((8, 0), (8, 6)), ((8, 6), (0, 6)), ((0, 6), (0, 0))]
    bare = Drawing("librecad", "mm", None)
    for a, b in lines:
        bare.line("WALL", a, b)
    import_file("bare.dxf", str(bare), code=2, says="8 m by 6 m in mm, 80 m by 60 m in cm, say --unit")
    check_rooms("a unit that is given", import_file("bare.dxf", str(bare), "--unit", "mm"), [box(0, 0, 8, 6)], Placing())


def check_false_units():
    """A single number beside a plausible header does not decide; a header that the walls contradict is refused."""
    room, put = box(0.3, 0.3, 9.7, 7.7), Placing()
    for unit, texts in (("m", ["0.5"]), ("m", ["10 cm", "<>", "<>", "<>"]), ("mm", ["254"]), ("mm", ["<>", "10000", "25.4"])):
        drawing = draw_double(shell(), "r2000", unit, unit, put)
        for i, text in enumerate(texts):
            at = -1 - i
            length = 5 if text == "0.5" else 1 if text == "25.4" else 10
            drawing.dimension((0, at), (length, at), text)
        check_plan(f"the texts {texts}", drawing, [room], put, notes=[f"the unit is {unit}, as the file says"])
    drawing = draw_double(shell(), "r2000", "m", "m", put)
    for at in (-1, -2):
        drawing.dimension((0, at), (10, at), "10 cm")
    import_file("false.dxf", str(drawing), code=2, says="the dimensions say that the unit is cm: 10 cm measures 10; this would make")
    inch = 0.0254
    for unit, says, plan, why in (("inch", "cm", shell(384 * inch, 288 * inch, thickness=6.5 * inch), "all walls thinner than 7 cm"),
                                  ("cm", "inch", shell(8, 6), "the distances of the lines are not those of a wall's faces"),
                                  ("ft", "m", shell(), "the distances of the lines are not those of a wall's faces")):
        drawing = draw_double(plan, "r2000", unit, says, put)
        import_file("false.dxf", str(drawing), code=2, says=why)
        answer = import_file("false.dxf", str(drawing), "--unit", unit)
        check_rooms(f"the header says {says}", answer, plan.rooms, put)


def check_doubled():
    """A drawing that holds its lines twice is the same plan."""
    plan, put = crossing(), Placing(31.7)
    drawing = draw_double(plan, "r2000", "mm", "mm", put)
    drawing.entities += drawing.entities
    answer = import_file("doubled.dxf", str(drawing))
    noted(answer, "lines of walls drawn more than once count once")
    check_rooms("a doubled drawing", answer, plan.rooms, put)
    check_doors("a doubled drawing", answer, door_lines(plan, put))


def check_slanted():
    """Walls that meet at other angles than right ones: a roof of 45 degrees over a square, and a slanted inner wall."""
    for where, put in PLACINGS.items():
        rooms = [[(0.3, 0.3), (5.7, 0.3), (5.7, 3), (3, 5.7), (0.3, 3)]]
        root = 0.3 * math.tan(math.pi / 8)
        outer = [(0, 0), (6, 0), (6, 3 + root), (3, 5.7 + 0.3 * math.sqrt(2)), (0, 3 + root)]
        drawing = Drawing("r2000", "mm", "mm", put)
        for outline in rooms + [outer]:
            drawing.polyline("WALLS", outline)
        answer = import_file("slanted.dxf", str(drawing))
        check_rooms(f"a slanted house, {where}", answer, rooms, put)


def check_gaps():
    """Walls without jambs: both lines stop at an opening, and nothing closes the ends."""
    plan = flat()
    for where, put in PLACINGS.items():
        drawing = Drawing("librecad", "mm", "mm", put)
        jambs = [{(x, y) for x in (o[0], o[2]) for y in (o[1], o[3])} for o in plan.openings()]
        for a, b in plan.faces():
            if not any(a in jamb and b in jamb for jamb in jambs):
                drawing.line("Walls", a, b)
        for x0, y0, x1, y1 in plan.windows:
            drawing.line("Windows", (x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2))
        answer = import_file("gaps.dxf", str(drawing))
        check_doors(f"gaps, {where}", answer, door_lines(plan, put), "opening")
        check_rooms(f"gaps, {where}", answer, plan.rooms, put)


def check_doors_of_two_leaves():
    plan, put = crossing(), Placing(31.7)
    drawing = draw_double(plan, "r2000", "mm", "mm", put, doors=False)
    for _, hinge, shut, opened in plan.doors:
        middle = tuple((p + q) / 2 for p, q in zip(hinge, shut))
        other = tuple(o - h + s for o, h, s in zip(opened, hinge, shut))
        half = lambda far, near: tuple((p + q) / 2 for p, q in zip(far, near))
        drawing.door("A-DOOR", hinge, middle, half(opened, hinge))
        drawing.door("A-DOOR", shut, middle, half(other, shut))
    answer = import_file("leaves.dxf", str(drawing))
    check_doors("two leaves", answer, door_lines(plan, put), "opening")
    check_rooms("two leaves", answer, plan.rooms, put)


def check_doors_in_corners():
    """A door between the end of a wall and the face of another."""
    for where, put in PLACINGS.items():
        for door in (((6.06, 3.2, 6.96, 3.3), (6.06, 3.3), (6.96, 3.3), (6.06, 4.2)), ((8.8, 3.2, 9.7, 3.3), (8.8, 3.2), (9.7, 3.2), (8.8, 2.3))):
            plan = flat()
            plan.doors[2] = door
            answer = import_file("corner.dxf", str(draw_double(plan, "r2000", "mm", "mm", put)))
            check_doors(f"a door in a corner, {where}", answer, door_lines(plan, put))
            check_rooms(f"a door in a corner, {where}", answer, plan.rooms, put)


def check_one_layer():
    """Everything on layer 0: walls, doors, and the glass of a window between its faces."""
    for where, put in PLACINGS.items():
        plan = flat()
        drawing = Drawing("librecad", "mm", None, put)
        for a, b in plan.faces():
            drawing.line("0", a, b)
        for _, hinge, shut, opened in plan.doors:
            drawing.door("0", hinge, shut, opened)
        for x0, y0, x1, y1 in plan.windows:
            for y in (y0, y0 + 0.1, y1 - 0.1, y1):
                drawing.line("0", (x0, y), (x1, y))
        answer = import_file("layer.dxf", str(drawing))
        noted(answer, "quarters of circles with a leaf, on layers of walls, became doors (3)")
        noted(answer, "the unit is mm, as the doors say")
        check_doors(f"one layer, {where}", answer, door_lines(plan, put))
        check_rooms(f"one layer, {where}", answer, plan.rooms, put)
        check(len(answer["house"]["walls"]) == 3, f"one layer, {where}: the glass is no wall of its own", answer["house"]["walls"])


def shell(width=10, depth=8, holes=(), windows=(), thickness=0.3):
    """A house of one room; `holes` (x0, y0, x1, y1) are cut out of its walls."""
    t = thickness
    walls = [(0, 0, width, t), (0, depth - t, width, depth), (0, 0, t, depth), (width - t, 0, width, depth)]
    return Flat(walls, [box(t, t, width - t, depth - t)], [(hole,) for hole in holes], list(windows))


def check_plan(what, drawing, rooms, put, doors=(), kind="hinged", notes=()):
    answer = import_file("plan.dxf", str(drawing))
    if not answer:
        return
    for note in notes:
        noted(answer, note)
    check_doors(what, answer, [tuple(map(put, ends)) for ends in doors], kind)
    check_rooms(what, answer, rooms, put)


def check_closed_walls():
    """Walls without a door: one face is interrupted, a niche, windows of several parts, with frames, and off the wall."""
    room = box(0.3, 0.3, 9.7, 7.7)
    for where, put in PLACINGS.items():
        drawing = Drawing("r2000", "mm", "mm", put)
        drawing.polyline("WALL", box(0, 0, 10, 8))
        drawing.polyline("WALL", [(5, 0.3), (9.7, 0.3), (9.7, 7.7), (0.3, 7.7), (0.3, 0.3), (3, 0.3)], closed=False)
        check_plan(f"one face is interrupted, {where}", drawing, [room], put)
        for width in (1.2, 2.9):
            niche = [(3, 0.3), (3, 0.15), (3 + width, 0.15), (3 + width, 0.3)]
            drawing = Drawing("r2000", "mm", "mm", put)
            drawing.polyline("WALL", box(0, 0, 10, 8))
            drawing.polyline("WALL", room[:1] + niche + room[1:])
            check_plan(f"a niche, {where}", drawing, [room[:1] + niche + room[1:]], put)
        casements = [[(3, 0.1), (4, 0.1), (4, 0.2), (3, 0.2)], [(4, 0.1), (5, 0.1), (5, 0.2), (4, 0.2)]]
        for name, width, outlines in (("two sashes", 2, casements), ("frames", 0.8, [box(3.05, 0.1, 3.75, 0.2)]),
                                      ("glass off the wall", 2, [[(3, 0.32), (5, 0.32)]]),
                                      ("two casements", 2, [[(3, 0.15), (4, 0.15)], [(4, 0.15), (5, 0.15)]])):
            drawing = draw_double(shell(holes=[(3, 0, 3 + width, 0.3)]), "qcad", "mm", "mm", put, doors=False)
            for outline in outlines:
                drawing.polyline("A-GLAZ", outline)
            check_plan(f"{name}, {where}", drawing, [room], put, notes=["windows became wall (1)"])
        drawing = draw_double(shell(holes=[(3, 0, 5, 0.3)]), "qcad", "mm", "mm", put, doors=False)
        check_plan(f"a gap, {where}", drawing, [room], put, [((3, 0.15), (5, 0.15))], "opening",
                   ["gaps in both lines of a wall became openings (1)"])


def check_corners_and_parts():
    """A door next to a corner leaves a nib; a face is drawn in parts; a shaft is as deep as the outer wall is thick."""
    room = box(0.3, 0.3, 9.7, 7.7)
    for where, put in PLACINGS.items():
        for nib in (0.05, 0.09):
            plan = shell(holes=[(0.3 + nib, 0, 1.25, 0.3)])
            ends = [((0.3 + nib, 0.15), (1.25, 0.15))]
            drawing = draw_double(plan, "r2000", "mm", "mm", put, doors=False)
            check_plan(f"a nib, {where}", drawing, [room], put, ends, "opening")
            drawing.door("A-DOOR", (0.3 + nib, 0.3), (1.25, 0.3), (0.3 + nib, 1.25 - nib))
            check_plan(f"a nib and a door, {where}", drawing, [room], put, ends)
        for off in (0, 0.03, 0.05, 0.1):
            drawing = Drawing("r2000", "mm", "mm", put)
            for corners, at in ((box(0, 0, 10, 8), 5), (room, 5 + off)):
                drawing.polyline("WALL", corners[1:] + corners[:1], closed=False)
                drawing.line("WALL", corners[0], (at, corners[0][1]))
                drawing.line("WALL", (at, corners[0][1]), corners[1])
            check_plan(f"faces in parts, {where}", drawing, [room], put)
        shaft = shell()
        shaft.walls += [(5, 0.3, 5.1, 7.7), (5.4, 0.3, 5.5, 7.7)]
        rooms = [box(0.3, 0.3, 5, 7.7), box(5.1, 0.3, 5.4, 7.7), box(5.5, 0.3, 9.7, 7.7)]
        check_plan(f"a shaft, {where}", draw_double(shaft, "r2000", "mm", "mm", put), rooms, put)


def check_layers_of_walls():
    """Cavity walls, insulated walls and walls with their centre lines: the layers are one wall."""
    for where, put in PLACINGS.items():
        for layers in ((0, 0.102, 0.177, 0.277), (0, 0.12, 0.3), (0, 0.1, 0.2, 0.3), (0, 0.09, 0.13, 0.22, 0.232)):
            drawing = Drawing("r2000", "mm", "mm", put)
            for at in layers:
                drawing.polyline("WALL", box(at, at, 10 - at, 8 - at))
            t = layers[-1]
            check_plan(f"layers {layers}, {where}", drawing, [box(t, t, 10 - t, 8 - t)], put)
        plan = shell()
        plan.walls.append((4.95, 0.3, 5.05, 7.7))
        drawing = draw_double(plan, "r2000", "mm", "mm", put)
        drawing.line("A-WALL", (5, 0.15), (5, 7.85))
        check_plan(f"a centre line, {where}", drawing, [box(0.3, 0.3, 4.95, 7.7), box(5.05, 0.3, 9.7, 7.7)], put)


def check_unusual_walls():
    """Two outlines farther apart than a wall is thick: the space between them is noted."""
    for thickness in (0.65, 1.1):
        answer = import_file("thick.dxf", str(draw_double(shell(thickness=thickness), "r2000", "mm", "mm", Placing())))
        noted(answer, f"most lines of walls run in pairs, up to {thickness:g} m apart")
    answer = import_file("plain.dxf", str(draw_double(shell(), "r2000", "mm", "mm", Placing())))
    check(not any("run in pairs" in note for note in answer["notes"]), "usual walls", answer["notes"])


def check_rectangles():
    """Walls as closed rectangles, with a pier between two gaps."""
    for where, put in PLACINGS.items():
        drawing = Drawing("r2000", "mm", "mm", put)
        for part in ((0, 0, 3, 0.3), (4, 0, 4.5, 0.3), (5.5, 0, 10, 0.3), (0, 7.7, 10, 8), (0, 0.3, 0.3, 7.7), (9.7, 0.3, 10, 7.7)):
            drawing.polyline("WALL", box(*part))
        check_plan(f"rectangles, {where}", drawing, [box(0.3, 0.3, 9.7, 7.7)], put, [((3, 0.15), (4, 0.15)), ((4.5, 0.15), (5.5, 0.15))],
                   "opening", ["gaps in both lines of a wall became openings (2)"])


def check_many_lines():
    """Dashes do not count among the lines that are compared; a drawing with too many lines is noted."""
    for length, says in ((0.005, False), (0.02, True)):
        drawing = draw_double(shell(), "qcad", "mm", "mm", Placing())
        for i in range(20001):
            at = (1 + 0.04 * (i % 190), 1 + 0.05 * (i // 190))
            drawing.line("A-WALL", at, (at[0] + length, at[1]))
        answer = import_file("many.dxf", str(drawing))
        check(says == any("were not looked for" in note for note in answer["notes"]), f"20001 lines of {length} m", answer["notes"])
        check(says != any("walls drawn as two lines became walls" in note for note in answer["notes"]), f"walls, {length} m", answer["notes"])


def check_partitions():
    """A partition drawn as one line between walls of two lines, closed, with a door, and a pilaster of three lines."""
    for where, put in PLACINGS.items():
        drawing = draw_double(shell(), "r2000", "mm", "mm", put)
        drawing.line("A-WALL", (5, 0.3), (5, 7.7))
        rooms = [box(0.3, 0.3, 5, 7.7), box(5, 0.3, 9.7, 7.7)]
        check_plan(f"a partition, {where}", drawing, rooms, put)
        drawing = draw_double(shell(), "r2000", "mm", "mm", put)
        drawing.line("A-WALL", (5, 0.3), (5, 4))
        drawing.line("A-WALL", (5, 5), (5, 7.7))
        drawing.door("A-DOOR", (5, 4), (5, 5), (6, 4))
        check_plan(f"a partition with a door, {where}", drawing, rooms, put, [((5, 4), (5, 5))])
        pilaster = [(4, 0.3), (4, 0.5), (4.4, 0.5), (4.4, 0.3)]
        drawing = draw_double(shell(), "r2000", "mm", "mm", put)
        drawing.polyline("A-WALL", pilaster, closed=False)
        check_plan(f"a pilaster, {where}", drawing, [box(0.3, 0.3, 9.7, 7.7)[:1] + pilaster + box(0.3, 0.3, 9.7, 7.7)[1:], pilaster], put)


# Other programs' files ----------------------------------------------------------------------------------------------


def check_homes():
    """Sweet Home 3D: walls that meet at their centre lines, or end at each other's faces; the rooms come along."""
    for name, plan in (("flat", flat()), ("crossing", crossing())):
        for where, put in PLACINGS.items():
            for joined in (True, False):
                what = f"a home, {name}, {where}, {'joined' if joined else 'to the faces'}"
                answer = import_file("home.sh3d", home(plan, put, joined, level=joined))
                if not answer:
                    continue
                check_doors(what, answer, door_lines(plan, put))
                check(len(answer["house"]["rooms"]) == len(plan.rooms), f"{what}: the rooms come along")
                for room, given in zip(plan.rooms, answer["house"]["rooms"]):
                    off = max(math.dist(put(corner), [p - m for p, m in zip(point, answer["moved"])])
                              for corner, point in zip(room, given["outline"]))
                    check(off < MILLIMETRE, f"{what}: a room is off by {off:.6f} m")
                check(not any("the rooms overlap" in note or "walls cover" in note for note in answer["notes"]), what, answer["notes"])
                check_rooms(what, answer, plan.rooms, put)


def free_area(what, answer, area, corners, put):
    """The exported area has this size, and a corner at each of these points."""
    house = folder / "free.json"
    house.write_text(json.dumps(answer["house"]))
    wkt = expect(0, "export", str(house)).stdout
    origin = answer["moved"][0] + put((0, 0))[0], answer["moved"][1] + put((0, 0))[1]
    rings = [[(x - origin[0], y - origin[1]) for x, y in ring] for ring in rings_of(wkt)]
    outer = max(map(area_of, rings))
    got = outer - (sum(map(area_of, rings)) - outer)
    check(abs(got - area) < MILLIMETRE * sum(map(length_of, rings)), f"{what}: the area is {got:.4f} m2, expected {area:.4f} m2", wkt)
    for corner in corners:
        at = tuple(p + m - o for p, m, o in zip(put(corner), answer["moved"], origin))
        off = min(math.dist(at, point) for ring in rings for point in ring)
        check(off < MILLIMETRE, f"{what}: the corner {corner} is off by {off:.6f} m", wkt)


def check_scenarios():
    """Vadere: the rooms of a flat whose outer wall is the frame; obstacles as rectangles, or turned as polygons."""
    plan = flat()
    inner = [part for part in plan.solids() if 0.3 <= part[0][0] and part[2][0] <= 9.7 and 0.3 <= part[0][1] and part[2][1] <= 6.7]
    area = sum(area_of(room) for room in plan.rooms) + 0.8 * 0.12 + 0.9 * 0.1
    corners = [corner for room in plan.rooms for corner in room] + [(x, y) for o, *_ in plan.doors[1:] for x in (o[0], o[2]) for y in (o[1], o[3])]
    for where, shift in (("plain", (0, 0)), ("shifted", (37.25, -12.5))):
        put = Placing(0, shift)
        content = scenario([list(map(put, part)) for part in inner], put((0, 0)) + put((10, 7)), frame=0.3, people=2)
        answer = import_file("flat.scenario", content)
        free_area(f"a scenario, {where}", answer, area, corners, put)
        check([person["at"] for person in answer["house"]["people"]] == [[shift[0] + 1 + i, shift[1] + 1] for i in range(2)], "people stand as given")
    for where, put in PLACINGS.items():
        if "far" in where:  # a scenario lies within 100 km of its origin
            put = Placing(math.degrees(put.angle), (41234.5, -9876.25), put.mirror)
        content = scenario([list(map(put, part)) for part in plan.solids() + [box(1.5, 6.7, 3, 7)]], (-50, -50, 50, 50), turned=True, frame=0)
        answer = import_file("turned.scenario", content)
        check(not answer["house"].get("doors"), "a scenario has no doors")
        closed = scenario([list(map(put, (box(*wall)))) for wall in plan.walls], (-50, -50, 50, 50), turned=True, frame=0)
        check_rooms(f"a scenario, {where}", import_file("closed.scenario", closed), plan.rooms, put)


def check_areas():
    """WKT: one area with a pillar, areas side by side (rooms and doors, as JuPedSim takes them), and a saved CRLF file."""
    plan = flat()
    rooms = sum(area_of(room) for room in plan.rooms)
    doors = [box(*opening) for opening, *_ in plan.doors[1:]]
    corners = [corner for room in plan.rooms + doors for corner in room]
    for where, put in PLACINGS.items():
        pillar = "POLYGON (" + area(box(0, 0, 8, 6), box(2, 2, 3, 2.5), put=put) + ")"
        answer = import_file("pillar.wkt", pillar)
        free_area(f"an area with a pillar, {where}", answer, 47.5, box(0, 0, 8, 6) + box(2, 2, 3, 2.5), put)
        joined = "GEOMETRYCOLLECTION (" + ", ".join("POLYGON (" + area(part, put=put) + ")" for part in plan.rooms + doors) + ")"
        answer = import_file("joined.wkt", joined)
        free_area(f"areas side by side, {where}", answer, rooms + 0.8 * 0.12 + 0.9 * 0.1, corners, put)
        apart = "\ufeffMULTIPOLYGON (" + ", ".join("(" + area(room, put=put) + ")" for room in plan.rooms) + ")\r\n"
        check_rooms(f"rooms of an area, {where}", import_file("apart.wkt", apart), plan.rooms, put)
    import_file("millimetres.wkt", "POLYGON ((0 0, 8000 0, 8000 6000, 0 6000, 0 0))", code=2, says="8 m by 6 m in mm")
    answer = import_file("millimetres.wkt", "POLYGON ((0 0, 8000 0, 8000 6000, 0 6000, 0 0))", "--unit", "mm")
    check_rooms("millimetres", answer, [box(0, 0, 8, 6)], Placing())
    import_file("degrees.wkt", "POLYGON ((13.37698 52.51628, 13.37712 52.51628, 13.37712 52.51635, 13.37698 52.51628))", code=2,
                says="look like degrees")


for part in (check_double_lines, check_outlines, check_single_lines, check_units, check_false_units, check_doubled, check_slanted, check_gaps,
             check_doors_of_two_leaves, check_doors_in_corners, check_one_layer, check_closed_walls,
             check_corners_and_parts, check_layers_of_walls, check_unusual_walls, check_rectangles, check_many_lines,
             check_partitions, check_homes, check_scenarios, check_areas):
    part()
place.cleanup()
end()
