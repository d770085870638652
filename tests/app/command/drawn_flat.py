"""A flat of known size, for the tests of importers: upright walls (rectangles) with openings (rectangles), in metres."""

import math


class Flat:
    """`walls` are (x0, y0, x1, y1); `doors` (opening, hinge, shut end, open end), the points on a face of their wall; `rooms`
    their corners; `windows` (x0, y0, x1, y1) are openings that a window fills; `axes` (from, to, thickness) are the walls'
    centre lines, which meet at corners and Ts."""

    def __init__(self, walls, rooms, doors=(), windows=(), axes=()):
        self.walls, self.rooms, self.doors, self.windows, self.axes = walls, rooms, doors, windows, axes

    def openings(self):
        return [opening for opening, *_ in self.doors] + list(self.windows)

    def faces(self):
        """The lines around what is wall: the faces, and the sides of the openings."""
        holes = self.openings()
        xs = sorted({x for r in self.walls + holes for x in (r[0], r[2])})
        ys = sorted({y for r in self.walls + holes for y in (r[1], r[3])})
        inside = lambda r, x, y: r[0] < x < r[2] and r[1] < y < r[3]

        def solid(i, j):
            if not (0 <= i < len(xs) - 1 and 0 <= j < len(ys) - 1):
                return False
            x, y = (xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2
            return any(inside(r, x, y) for r in self.walls) and not any(inside(r, x, y) for r in holes)

        lines = []
        for i in range(len(xs)):
            lines += [((xs[i], ys[a]), (xs[i], ys[b])) for a, b in runs([(solid(i - 1, j), solid(i, j)) for j in range(len(ys))])]
        for j in range(len(ys)):
            lines += [((xs[a], ys[j]), (xs[b], ys[j])) for a, b in runs([(solid(i, j - 1), solid(i, j)) for i in range(len(xs))])]
        return lines

    def solids(self):
        """The walls cut into rectangles between their openings."""
        parts = []
        for wall in self.walls:
            axis = 0 if wall[2] - wall[0] > wall[3] - wall[1] else 1
            cuts = sorted(o for o in self.openings() if all(wall[i] <= o[i] and o[i + 2] <= wall[i + 2] for i in range(2)))
            begin = wall[axis]
            for low, high in [(o[axis], o[axis + 2]) for o in cuts] + [(wall[axis + 2], None)]:
                if low > begin:
                    parts.append(box(begin, wall[1], low, wall[3]) if axis == 0 else box(wall[0], begin, wall[2], low))
                begin = high
        return parts

    def centre_lines(self):
        """The centre lines of the walls, each with its thickness."""
        lines = []
        for x0, y0, x1, y1 in self.walls:
            if x1 - x0 > y1 - y0:
                lines.append(((x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2), y1 - y0))
            else:
                lines.append((((x0 + x1) / 2, y0), ((x0 + x1) / 2, y1), x1 - x0))
        return lines


def runs(sides):
    """The longest runs in which one side is solid and the other is not, and which is which does not change."""
    found, begin = [], None
    for k, (one, two) in enumerate(sides + [(False, False)]):
        kind = (one, two) if one != two else None
        if begin is not None and kind != begin[1]:
            found.append((begin[0], k))
            begin = None
        if begin is None and kind:
            begin = (k, kind)
    return found


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def flat():
    """10 m by 7 m: outer walls of 0.3 m, inner walls of 0.12 m and 0.1 m that end in Ts, three doors, a window."""
    walls = [(0, 0, 10, 0.3), (0, 6.7, 10, 7), (0, 0, 0.3, 7), (9.7, 0, 10, 7), (5.94, 0.3, 6.06, 6.7), (6.06, 3.2, 9.7, 3.3)]
    doors = [((2, 0, 2.9, 0.3), (2, 0.3), (2.9, 0.3), (2, 1.2)),
             ((5.94, 1, 6.06, 1.8), (5.94, 1), (5.94, 1.8), (5.14, 1)),
             ((7, 3.2, 7.9, 3.3), (7.9, 3.3), (7, 3.3), (7.9, 4.2))]
    rooms = [box(0.3, 0.3, 5.94, 6.7), box(6.06, 0.3, 9.7, 3.2), box(6.06, 3.3, 9.7, 6.7)]
    axes = [((0.15, 0.15), (9.85, 0.15), 0.3), ((9.85, 0.15), (9.85, 6.85), 0.3), ((9.85, 6.85), (0.15, 6.85), 0.3),
            ((0.15, 6.85), (0.15, 0.15), 0.3), ((6, 0.15), (6, 6.85), 0.12), ((6, 3.25), (9.85, 3.25), 0.1)]
    return Flat(walls, rooms, doors, [(1.5, 6.7, 3, 7)], axes)


def crossing():
    """9 m by 8 m: inner walls of 0.15 m that cross, a wall with a free end, and a corner of 0.15 m and 0.1 m."""
    walls = [(0, 0, 9, 0.25), (0, 7.75, 9, 8), (0, 0, 0.25, 8), (8.75, 0, 9, 8), (4, 0.25, 4.15, 7.75), (0.25, 4, 8.75, 4.15),
             (6, 4.15, 6.1, 5.4), (6.1, 5.25, 8.75, 5.4)]
    doors = [((4, 1, 4.15, 1.9), (4.15, 1.9), (4.15, 1), (5.05, 1.9)), ((1, 4, 1.8, 4.15), (1, 4), (1.8, 4), (1, 3.2)),
             ((5, 0, 6, 0.25), (5, 0.25), (6, 0.25), (5, 1.25))]
    rooms = [box(0.25, 0.25, 4, 4), box(4.15, 0.25, 8.75, 4), box(0.25, 4.15, 4, 7.75), box(6.1, 4.15, 8.75, 5.25),
             [(4.15, 4.15), (6, 4.15), (6, 5.4), (8.75, 5.4), (8.75, 7.75), (4.15, 7.75)]]
    axes = [((0.125, 0.125), (8.875, 0.125), 0.25), ((8.875, 0.125), (8.875, 7.875), 0.25), ((8.875, 7.875), (0.125, 7.875), 0.25),
            ((0.125, 7.875), (0.125, 0.125), 0.25), ((4.075, 0.125), (4.075, 7.875), 0.15), ((0.125, 4.075), (8.875, 4.075), 0.15),
            ((6.05, 4.075), (6.05, 5.4), 0.1), ((6.05, 5.325), (8.875, 5.325), 0.15)]
    return Flat(walls, rooms, doors, axes=axes)


class Placing:
    """Turns (degree), mirrors and shifts (m) a point."""

    def __init__(self, angle=0, shift=(0, 0), mirror=False):
        self.angle, self.shift, self.mirror = math.radians(angle), shift, mirror

    def __call__(self, at):
        x, y = (-at[0] if self.mirror else at[0]), at[1]
        cosine, sine = math.cos(self.angle), math.sin(self.angle)
        return x * cosine - y * sine + self.shift[0], x * sine + y * cosine + self.shift[1]
