"""Writes drawings as DXF, in the shapes that AutoCAD (R12, R2000), LibreCAD and QCAD give them."""

import math

UNITS = {"inch": 1, "ft": 2, "mm": 4, "cm": 5, "m": 6}
METRES = {"mm": 0.001, "cm": 0.01, "m": 1, "inch": 0.0254, "ft": 0.3048}


class Drawing:
    """`style` is r12, r2000, librecad or qcad; points are in metres and written in `unit`; `says` is the header's unit."""

    def __init__(self, style="r2000", unit="mm", says=None, place=lambda at: at):
        self.style, self.metres, self.says, self.place = style, METRES[unit], says, place
        self.blocks, self.entities, self.handle = [], [], 0x100

    def groups(self, *pairs):
        padded = self.style in ("r12", "r2000")
        return "".join(f"{code:>3}\n{value}\n" if padded else f"{code}\n{value}\n" for code, value in pairs)

    def number(self, metres):
        return f"{metres / self.metres:.12g}" if self.style != "r12" else f"{metres / self.metres:.9f}"

    def at(self, code, point, placed=True):
        x, y = self.place(point) if placed else point
        third = [(code + 20, "0.0")]
        return [(code, self.number(x)), (code + 10, self.number(y))] + third

    def entity(self, kind, layer, subclass, *pairs, into=None):
        self.handle += 1
        old = self.style == "r12"
        head = [(0, kind)] + ([] if old else [(5, f"{self.handle:X}"), (100, "AcDbEntity")]) + [(8, layer)]
        marks = [] if old or not subclass else [(100, subclass)]
        (self.entities if into is None else into).append(self.groups(*head, *marks, *pairs))

    def line(self, layer, a, b, into=None, placed=True):
        self.entity("LINE", layer, "AcDbLine", *self.at(10, a, placed), *self.at(11, b, placed), into=into)

    def polyline(self, layer, points, closed=True):
        if self.style == "r12":
            self.entity("POLYLINE", layer, "", (66, 1), (70, int(closed)), (10, "0.0"), (20, "0.0"), (30, "0.0"))
            for point in points:
                self.entities.append(self.groups((0, "VERTEX"), (8, layer), *self.at(10, point)))
            self.entities.append(self.groups((0, "SEQEND"), (8, layer)))
            return
        pairs = [pair for point in points for pair in self.at(10, point)[:2]]
        self.entity("LWPOLYLINE", layer, "AcDbPolyline", (90, len(points)), (70, int(closed)), (43, "0.0"), *pairs)

    def arc(self, layer, centre, one, two, into=None, placed=True):
        """An arc from one point to another, which is drawn counter-clockwise as the format has it."""
        put = self.place if placed else lambda at: at
        c, p, q = put(centre), put(one), put(two)
        start, end = (math.degrees(math.atan2(r[1] - c[1], r[0] - c[0])) % 360 for r in (p, q))
        if (end - start) % 360 > 180:
            start, end = end, start
        self.entity("ARC", layer, "AcDbCircle", *self.at(10, centre, placed), (40, self.number(math.dist(c, p))),
                    *([] if self.style == "r12" else [(100, "AcDbArc")]), (50, f"{start:.9f}"), (51, f"{end:.9f}"), into=into)

    def door(self, layer, hinge, shut, opened, as_block=False):
        if not as_block:
            self.line(layer, hinge, opened)
            self.arc(layer, hinge, shut, opened)
            return
        # A block of a unit leaf, hinged at its base point, that the INSERT scales, mirrors and turns.
        h, s, o = (self.place(point) for point in (hinge, shut, opened))
        width = math.dist(h, s)
        left = (s[0] - h[0]) * (o[1] - h[1]) - (s[1] - h[1]) * (o[0] - h[0]) > 0
        if not self.blocks:
            unit = self.metres  # one unit of the drawing
            inside = []
            self.line("0", (0, 0), (0, unit), inside, False)
            self.arc("0", (0, 0), (unit, 0), (0, unit), inside, False)
            self.block("DOOR-LEAF", inside)
        turn = math.degrees(math.atan2(s[1] - h[1], s[0] - h[0]))
        self.entity("INSERT", layer, "AcDbBlockReference", (2, "DOOR-LEAF"), *self.at(10, hinge), (41, self.number(width)),
                    (42, ("" if left else "-") + self.number(width)), (43, "1.0"), (50, f"{turn:.9f}"))

    def block(self, name, inside):
        old = self.style == "r12"
        self.blocks.append(self.groups((0, "BLOCK"), *([] if old else [(100, "AcDbEntity")]), (8, "0"),
                                       *([] if old else [(100, "AcDbBlockBegin")]), (2, name), (70, 0), (10, "0.0"),
                                       (20, "0.0"), (30, "0.0"), (3, name)) + "".join(inside)
                           + self.groups((0, "ENDBLK"), *([] if old else [(100, "AcDbEntity")]), (8, "0")))

    def dimension(self, a, b, text, in_block=False, layer="DIMS"):
        """An aligned dimension; its text overrides the measured length, or lies in its block as AutoCAD draws it."""
        middle = tuple((p + q) / 2 for p, q in zip(a, b))
        measured = math.dist(self.place(a), self.place(b))
        name = f"*D{len(self.blocks) + 1}"
        if in_block:
            inside = []
            self.entity("MTEXT", layer, "AcDbMText", *self.at(10, middle), (40, self.number(0.2)), (1, f"\\A1;{text}"), into=inside)
            self.block(name, inside)
        self.entity("DIMENSION", layer, "AcDbDimension", (2, name), *self.at(10, b), *self.at(11, middle), (70, 33),
                    *([] if in_block else [(1, text)]), *([] if self.style == "r12" else [(42, self.number(measured))]),
                    *([] if self.style == "r12" else [(100, "AcDbAlignedDimension")]), *self.at(13, a), *self.at(14, b))

    def text(self, layer, at, height, text, turned=0):
        self.entity("TEXT", layer, "AcDbText", *self.at(10, at), (40, self.number(height)), (1, text), (50, turned))

    def __str__(self):
        version = {"r12": "AC1009", "r2000": "AC1015", "librecad": "AC1021", "qcad": "AC1015"}[self.style]
        comment = {"librecad": self.groups((999, "dxfrw 0.6.3")), "qcad": self.groups((999, "QCAD"))}.get(self.style, "")
        header = self.groups((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, version))
        if self.says is not None:
            header += self.groups((9, "$INSUNITS"), (70, UNITS[self.says]))
        if self.style == "r2000":
            header += self.groups((9, "$HANDSEED"), (5, f"{self.handle + 1:X}"), (9, "$MEASUREMENT"), (70, 1))
        sections = [header + self.groups((0, "ENDSEC"))]
        for name, content in (("BLOCKS", self.blocks), ("ENTITIES", self.entities)):
            sections.append(self.groups((0, "SECTION"), (2, name)) + "".join(content) + self.groups((0, "ENDSEC")))
        return comment + "".join(sections) + self.groups((0, "EOF"))
