#!/usr/bin/env python3
"""Tests absurd houses: each must get an answer or a clear error, in bounded time and memory.

hostile.py CLEARANCE
"""

import json
import math
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import threading

source = pathlib.Path(os.environ.get("CLEARANCE_SOURCE", ".")).resolve()
program = pathlib.Path(sys.argv[1]).resolve()
failures = 0

MANY = 100_000
SECONDS = 60  # processor time; a house takes a second or two, more with sanitizers
MEGABYTES = 2000  # includes the overhead of the address sanitizer


def check(good, what, detail=""):
    global failures
    if not good:
        failures += 1
        print(f"FAIL {what} {detail}")


def house(**members):
    return json.dumps({"format": "clearance-house", "version": 1, "walls": [], **members})


def wall(name, *points, **members):
    return {"id": name, "points": points, **members}


def chair(name, x, y, **members):
    return {"id": name, "profile": "manual-chair", "at": [x, y], **members}


def limit_time():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))


def measure(*arguments):
    """Returns the exit code (or minus a signal's number), the output, and the peak memory in MB."""
    process = subprocess.Popen([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=limit_time)
    error = []
    reader = threading.Thread(target=lambda: error.append(process.stderr.read()))
    reader.start()
    out = process.stdout.read()
    reader.join()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, out.decode(), error[0].decode(), usage.ru_maxrss / 1024


def expect(name, text, code, *arguments, verb="check", says=""):
    """Runs the house; `says` is a part of the first error (code 2) or of the answer."""
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory, "house.json")
        path.write_text(text)
        got, out, error, megabytes = measure(verb, str(path), *arguments)
        check(got == code, f"{name}: exit code {got}, expected {code}", error[:300])
        check(megabytes < MEGABYTES, f"{name}: {megabytes:.0f} MB")
        faults = error.splitlines()
        for line in faults:
            place = re.match(re.escape(str(path)) + r":\d+:\d+: |--set |and \d+ more$", line)
            check(place and len(line) < 600, f"{name}: no place in", line[:300])
        check(len(faults) <= 51 and (code != 2 or faults), f"{name}: {len(faults)} faults")
        check(says in (faults[0] if code == 2 and faults else out), f"{name}: lacks {says!r}", (error + out)[:300])


def check_walls():
    grid = [wall(f"w{i}", [4 * (i % 40), 4 * (i // 40)], [4 * (i % 40) + (2 if i % 3 else 0), 4 * (i // 40) + 2])
            for i in range(1000)]
    expect("walls one by one", house(walls=grid), 0)
    expect("a wall of many points", house(walls=[wall("w1", *([i / 100, 0] for i in range(MANY)))]), 0)
    expect("a wall wound up",
           house(walls=[wall("w1", *([math.cos(i / 9) * (1 + i / 9999), math.sin(i / 9)] for i in range(MANY)))]), 2,
           says="meet in more than")
    for thickness in (0, 0.01):
        lines = [wall(f"{c}{i}", *([[0, i / 2], [1e3, i / 2]] if c == "h" else [[i / 2, 0], [i / 2, 1e3]]),
                      thickness=thickness) for c in "hv" for i in range(2000)]
        expect(f"crossing walls, {thickness} m", house(walls=lines), 2, says="meet in more than")
    star = [wall(f"w{i}", [9 * math.cos(i), 9 * math.sin(i)], [0, 0]) for i in range(MANY)]
    expect("walls that end in one point", house(walls=star), 2, says="meet in more than")
    expect("the same wall again", house(walls=[wall(f"w{i}", [0, 0], [4, 0]) for i in range(MANY)]), 2,
           says="meet in more than")
    expect("walls of no length", house(walls=[wall(f"w{i}", [i, 0], [i, 1e-7]) for i in range(MANY)]), 2,
           says="points 1 and 2 coincide")
    expect("bad walls", house(walls=[wall(f"w{i}", [i, "x"], [0]) for i in range(MANY)]), 2, says="must be a point")
    crossing = [wall(f"{c}{i}", *([[-1, i], [30, i]] if c == "h" else [[i, -1], [i, 30]])) for c in "hv" for i in range(30)]
    expect("some crossing walls", house(walls=crossing, people=[chair("p1", 0.5, 0.5)]), 1, says="no exit")


def check_doors():
    count = 2000
    zigzag = wall("w1", *([2 * i, i % 2] for i in range(count + 1)))
    expect("a door on every segment",
           house(walls=[zigzag], doors=[{"id": f"d{i}", "wall": "w1", "segment": i, "at": 1, "width": 0.9,
                                         "kind": "hinged", "state": ("open", "closed", "locked")[i % 3]}
                                        for i in range(count)]), 0)
    straight = wall("w1", [0, 0], [4, 0])
    expect("doors on each other",
           house(walls=[straight], doors=[{"id": f"d{i}", "wall": "w1", "at": 2, "width": 1} for i in range(MANY)]), 2,
           says="door d1 overlaps door d0")
    expect("doors in no wall",
           house(walls=[straight], doors=[{"id": f"d{i}", "wall": f"v{i}", "at": 2, "width": 1} for i in range(MANY)]), 2,
           says='there is no wall "v0"')


def check_numbers():
    for number, code in (("1e300", 2), ("-1e300", 2), ("1e400", 2), ("4.9e-324", 0), ("-0.0", 0), ("NaN", 2),
                         ("Infinity", 2), ("-Infinity", 2), ("1" + "0" * 400, 2), ("0." + "0" * 9999 + "1", 0)):
        text = house(walls=[wall("w1", [0, 0], ["here", 1])], people=[chair("p1", 0, 3, heading="here")] if code else [])
        expect(f"a coordinate {number[:20]}", text.replace('"here"', number), code)
    expect("a plan of 200 km", house(walls=[wall("w1", [-1e5, -1e5], [1e5, 1e5])], people=[chair("p1", 0, 9)]), 2,
           says="too large for the route search")
    expect("a plan of 200 km by 1 m", house(walls=[wall("w1", [-1e5, 0], [1e5, 0])]), 2, says="too large")
    room = {"walls": [wall("w1", [0, 0], [4, 0])], "people": [chair("p1", 2, 2)]}
    for setting, says in (("run.dt=0", "dt is 0"), ("run.dt=1e-300", "dt is 1e-300"), ("run.sample=1e-6", "step dt"),
                          ("run.sample=1e300", "sample is"), ("run.until=1e300", "until is"), ("run.cell=1e-9", "cell is"),
                          ("run.cell=1e9", "cell is"), ("run.reversals=1e18", "reversals is"), ("run.dt=NaN", "dt must"),
                          ("run.until=-1", "until is"), ("door..=1", "is not a parameter"), ("x" * 100_000 + "=1", "is not"),
                          ("run.dt=" + "[" * 100_000, "dt must")):
        expect(f"--set {setting[:30]}", house(**room), 2, "--set", setting, says=says)
    expect("the finest cell", house(**room), 1, "--set", "run.cell=0.01", says="no exit")


def check_people():
    expect("everybody at the same spot",
           house(walls=[wall("w1", [0, 0], [4, 0])], people=[chair(f"p{i}", 2, 2) for i in range(300)]), 2,
           says="person p1 stands inside person p0")
    crowd = {"profile": "manual-chair", "count": MANY, "area": [[0, 1], [20, 1], [20, 20], [0, 20]]}
    million = [{"id": f"c{i}", **crowd} for i in range(10)]
    expect("a million people", house(crowds=million), 2, says="1000000 people in all, must be at most 200000")
    expect("more people than there is room for", house(crowds=million[:1]), 2, says="there is room for")
    expect("people in walls", house(walls=[wall(f"w{i}", [2 * (i % 300), i // 300], [2 * (i % 300) + 1, i // 300])
                                           for i in range(20_000)],
                                    people=[chair(f"p{i}", 2 * (i % 300) + 0.5, i // 300) for i in range(20_000)],
                                    run={"sample": 9}), 2, says="person p0 stands inside wall w0")
    people = [chair(f"p{i}", 2 * (i % 300), 2 * (i // 300)) for i in range(MANY)]
    expect("nobody on many routes", house(routes=[{"id": f"r{i}", "people": [f"p{i}"]} for i in range(MANY)]), 2,
           says='there is no person or crowd "p0"')
    expect("each on two routes",
           house(people=people, routes=[{"id": f"r{i}", "people": [f"p{i // 2}"]} for i in range(MANY)]), 2,
           says="must take one only")
    expect("no profile", house(people=[chair(f"p{i}", 2 * i, 0) | {"profile": f"x{i}"} for i in range(20_000)],
                               run={"sample": 9}), 2, says='p0 has profile "x0"')


def check_lists():
    expect("rooms", house(rooms=[{"id": f"r{i}", "outline": [[0, 0], [1, 0], [1, 1]]} for i in range(MANY)]), 0)
    expect("exits", house(exits=[{"id": f"e{i}", "from": [i % 300, i // 300], "to": [i % 300, i // 300 + 0.9]}
                                 for i in range(MANY)]), 0)
    expect("one id for all", house(rooms=[{"id": "r", "outline": [[0, 0], [1, 0], [1, 1]]}] * MANY), 2, says="used twice")
    expect("overrides", house(overrides={f"profile.manual-chair.with{i}": i for i in range(MANY)},
                              people=[chair("p1", 0, 0)]), 2, says="profile has no parameter")
    expect("overrides of names", house(rooms=[{"id": f"r{i}", "outline": [[0, 0], [1, 0], [1, 1]]} for i in range(MANY)],
                                       overrides={f"room.r{i}.id": f"s{i}" for i in range(MANY)}), 0)
    expect("unknown keys", house(**{f"key{i}": i for i in range(MANY)}), 2, says='unknown key "key0"')


def check_text():
    expect("deep lists", "[" * 1_000_000, 2, says="nested too deeply")
    expect("deep objects", '{"a":' * 1_000_000, 2, says="nested too deeply")
    expect("deep lists that end", house(note="here").replace('"here"', "[" * 2000 + "]" * 2000), 2, says="must be a text")
    expect("long names", house(walls=[wall("w" * 10_000_000, [0, 0], [1, 0])] * 2), 2, says="used twice")
    expect("long words", house(walls=[wall("w\u00e9" * 1_000_000, [0, 0], [1, 0])]), 2, says="letters, digits")
    expect("too long", house(note="x" * 70_000_000), 2, says="File too large")
    json_text = json.loads(measure("check", str(source / "houses/closed-door.json"), "--json", "--set", "d\u00e9" * 99)[1])
    check(json_text["faults"] != [None], "a fault that is cut within a character is there in --json")


for part in (check_walls, check_doors, check_numbers, check_people, check_lists, check_text):
    part()
print(f"{failures} failures")
sys.exit(failures != 0)
