#!/usr/bin/env python3
"""Tests `check` against `run` over random plans: a path that `check` finds leads out in `run`, or the run says in
words that `check` finds a path; and a person without a path does not leave. A door as wide as a chair needs lets it out.

plans.py CLEARANCE [PLANS [FIRST]]
"""

import json
import math
import pathlib
import random
import sys
import tempfile

from program import check, end, run

PLANS = int(sys.argv[2]) if len(sys.argv) > 2 else 60
FIRST = int(sys.argv[3]) if len(sys.argv) > 3 else 0
WIDTHS = {"adult": 0.38, "elderly": 0.38, "child": 0.3, "crutches": 0.68, "rollator": 0.62, "manual-chair": 0.63,
          "electric-chair": 0.65, "assisted-chair": 0.63, "miura-chair": 0.63}
DRIVEN = ("manual-chair", "electric-chair", "assisted-chair")
PLANNED = "check finds a path from the start, but the simulated motion does not reach the exit"


def document(seed, profile, walls, **members):
    members["people"][0]["profile"] = profile
    return {"format": "clearance-house", "version": 1, "name": f"random plan {seed}", "walls": walls, **members}


def flat(seed):
    """Three rooms with sliding doors, and furniture anywhere."""
    draw = random.Random(seed)
    width, depth = draw.uniform(5, 9), draw.uniform(4, 7)
    x, y = draw.uniform(0.35, 0.65) * width, draw.uniform(0.4, 0.6) * depth
    walls = [{"id": "w0", "points": [[0, 0], [width, 0], [width, depth], [0, depth], [0, 0]], "thickness": 0.12},
             {"id": "w1", "points": [[x, 0], [x, depth]], "thickness": 0.12},
             {"id": "w2", "points": [[x, y], [width, y]], "thickness": 0.12}]
    way_out = draw.uniform(0.6, depth - 0.6)
    doors = [{"id": "d0", "wall": "w0", "segment": 1, "at": way_out, "width": draw.uniform(0.75, 1), "kind": "sliding"},
             {"id": "d1", "wall": "w1", "at": draw.uniform(0.8, depth - 0.8), "width": draw.uniform(0.55, 0.95), "kind": "sliding"},
             {"id": "d2", "wall": "w2", "at": draw.uniform(0.6, width - x - 0.6), "width": draw.uniform(0.6, 0.95), "kind": "sliding"}]
    furniture = [{"id": f"f{i}", "name": "piece", "centre": [draw.uniform(0.4, width - 0.4), draw.uniform(0.4, depth - 0.4)],
                  "size": [draw.uniform(0.3, 1.2), draw.uniform(0.3, 0.9)], "angle": draw.choice([0, 90, draw.uniform(0, 180)])}
                 for i in range(draw.randint(3, 10))]
    profile = draw.choice(sorted(WIDTHS))
    return document(seed, profile, walls, doors=doors, furniture=furniture,
                    exits=[{"id": "e", "from": [width + 0.3, way_out - 0.5], "to": [width + 0.3, way_out + 0.5]}],
                    people=[{"id": "p", "at": [draw.uniform(0.6, x - 0.6), draw.uniform(0.6, depth - 0.6)],
                             "heading": draw.uniform(0, 360)}])


def alley(seed):
    """A passage, turned by any angle, past pairs of pieces that leave gaps about as wide as the person."""
    draw = random.Random(seed)
    profile = draw.choice(sorted(WIDTHS))
    length, breadth = draw.uniform(5, 8), draw.uniform(1.6, 3)
    turn = draw.choice([0, 0, draw.uniform(0, 90)])
    cosine, sine = math.cos(math.radians(turn)), math.sin(math.radians(turn))

    def at(x, y):
        return [x * cosine - y * sine, x * sine + y * cosine]

    furniture, x = [], 1.8
    while x < length - 0.8:
        gap = WIDTHS[profile] + draw.choice([draw.uniform(-0.02, 0.02), draw.uniform(0, 0.1), draw.uniform(0.05, 0.3)])
        low, deep = draw.uniform(0.1, breadth - 0.1 - gap), draw.uniform(0.05, 0.6)
        for begin, finish in ((0.05, low), (low + gap, breadth - 0.05)):
            if finish - begin > 0.06:
                furniture.append({"id": f"f{len(furniture)}", "name": "piece",
                                  "centre": at(x + draw.uniform(-0.1, 0.1), (begin + finish) / 2),
                                  "size": [deep, finish - begin], "angle": turn + draw.choice([0, 0, draw.uniform(-15, 15)])})
        x += draw.uniform(0.9, 2.5)
    return document(seed, profile,
                    [{"id": "w", "points": [at(length, 0), at(0, 0), at(0, breadth), at(length, breadth)], "thickness": 0.1}],
                    furniture=furniture, exits=[{"id": "e", "from": at(length - 0.1, 0.05), "to": at(length - 0.1, breadth - 0.05)}],
                    people=[{"id": "p", "at": at(0.9, breadth / 2), "heading": turn}])


def doorway(seed):
    """A corridor off which a narrow door leads into a room, with the way out there; turned by any angle."""
    draw = random.Random(seed)
    turn = math.radians(draw.choice([0, draw.uniform(0, 90)]))
    breadth, length, depth = draw.uniform(1.05, 1.5), draw.uniform(4, 6), draw.uniform(2.5, 3.5)

    def at(x, y):
        return [x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)]

    walls = [{"id": "w0", "points": [at(0, 0), at(length, 0), at(length, breadth), at(0, breadth), at(0, 0)], "thickness": 0.12},
             {"id": "w1", "points": [at(0, breadth), at(0, breadth + depth)], "thickness": 0.12},
             {"id": "w2", "points": [at(length, breadth), at(length, breadth + depth)], "thickness": 0.12}]
    door = {"id": "d0", "wall": "w0", "segment": 2, "at": length / 2, "width": draw.uniform(0.55, 0.8), "kind": "sliding"}
    return document(seed, draw.choice(DRIVEN), walls, doors=[door],
                    exits=[{"id": "e", "from": at(0.1, breadth + depth), "to": at(length - 0.1, breadth + depth)}],
                    people=[{"id": "p", "at": at(1, breadth / 2), "heading": math.degrees(turn)}])


def answer(verb, path):
    done = run(verb, path, "--json", "--jobs", "1")
    return done.returncode, json.loads(done.stdout) if done.stdout else {}


def compare(name, plan, directory):
    """Returns "out", "no", "differ", or None for a plan with errors, such as a person inside a piece."""
    path = pathlib.Path(directory, f"{name}.json".replace(" ", "-"))
    path.write_text(json.dumps(plan))
    found, planned = answer("check", str(path))
    if found == 2:
        return None
    done, moved = answer("run", str(path))
    check({found, done} <= {0, 1}, f"{name}: check ends with {found}, run with {done}")
    way, person = planned["people"][0], moved["people"][0]
    place = way.get("blocked_at", {})
    if "needs" in place:
        check(place["needs"] >= WIDTHS[way["profile"].replace(" ", "-")] - 1e-9, f"{name}: needs less than its own width", place)
        check(place["has"] < place["needs"], f"{name}: has what it needs", place)
    if way["profile"] in DRIVEN and place.get("has", 0) > 0 and not place["estimated"]:
        door = place["what"].split()[-1]
        wider = run("check", str(path), "--set", f"door.{door}.width={place['needs']}", "--jobs", "1")
        check(wider.returncode == 0, f"{name}: the door does not need what it is said to need", wider.stdout)
        outcomes.append("widened")
    if (found == 0) == person["completed"]:
        return "no" if found else "out"
    words = run("run", str(path), "--jobs", "1").stdout
    check(found == 0, f"{name}: leaves without a path", words)
    check(PLANNED in words.splitlines()[0], f"{name}: does not say that check finds a path", words.splitlines()[0])
    return "differ"


with tempfile.TemporaryDirectory() as folder:
    outcomes = []
    for number in range(FIRST, FIRST + PLANS):
        outcomes.append(compare(f"flat {number}", flat(number), folder))
        outcomes.append(compare(f"alley {number}", alley(number), folder))
        if number % 4 == 0:
            outcomes.append(compare(f"doorway {number}", doorway(number), folder))
for kind in ("out", "no", "differ", "widened", None):
    print(f"{outcomes.count(kind)} plans: {kind or 'not a plan'}")
check(outcomes.count("out") > PLANS / 4 and outcomes.count("no") > PLANS / 4, "too few plans of one kind")
check(outcomes.count("widened") > PLANS / 20, "too few doors are told by trying how wide they have to be")
end()
