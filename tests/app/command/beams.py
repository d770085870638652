#!/usr/bin/env python3
"""Tests what the command line says about beams whose answers take some seconds: verdict, type and window.

beams.py CLEARANCE
"""

import json

from program import check, end, expect, source


def check_beams():
    beam = str(source / "assets/beams/ibs.json")
    answer = json.loads(expect(0, "run", beam, "--set", "drive.frequency=290", "--json").stdout)
    check((answer["kind"], answer["verdict"], answer["period"]) == ("beam", "periodic", 1), f"run of a beam: {answer}")
    check(abs(answer["peaks"]["max"] - 1032) < 2 and answer["peaks"]["count"] == 200, f"peaks of a beam: {answer['peaks']}")
    for key in ("frequency", "clearance", "lyapunov", "zero_one", "cycles", "natural_frequencies", "digest"):
        check(key in answer, f"run --json of a beam lacks {key}")
    types = answer["types"]
    check((answer["type"], types["type"], types["reason"]) == ("II", "II", "steep"), f"type of a beam: {types}")
    check((types["runs"], types["starts"], len(types["points"])) == (144, 16, 9), f"window of a type: {types}")
    length = next(p for p in types["parameters"] if p["name"] == "beam.length")
    check(abs(length["above"]["away"] - 0.02) < 1e-9 and length["sensitivity"] < -5, f"nearest trouble of a beam: {length}")
    check("The nearest trouble is at length 286.8 mm (2 % above)" in types["advice"], f"advice: {types['advice']}")
    chaotic = expect(0, "run", beam, "--lanes", "0").stdout
    check(chaotic.startswith("Chaotic (quick verdict): at 300 Hz the tip hits the joint with "), "run of a chaotic beam")
    check("\nType III: do not run it here. It is not periodic right here, from any of 16 starts. "
          "The motion that was analysed fully there is chaotic.\n" in chaotic,
          f"type of a chaotic beam: {chaotic}")
    check("This rests on 144 runs of 400 cycles from 16 starts" in chaotic, f"what a type rests on: {chaotic}")
    lasting = json.loads(expect(0, "run", beam, "--lanes", "2", "--json").stdout)
    check(lasting["verdict"] == "chaotic" and not lasting["quick"], f"confirmed chaos: {lasting['verdict']}")
    survival = lasting["survival"]
    check((survival["lanes"], survival["cycles"], survival["settled"]) == (2, 20000, 0), f"survival: {survival}")
    both = json.loads(expect(0, "run", beam, "--set", "drive.frequency=250", "--set", "drive.force=60", "--json").stdout)
    answers = [(a["starts"], round(a["peak_max"])) for a in both["types"]["points"][0]["answers"]]
    check(answers == [(15, 744), (1, 0)] or answers == [(1, 0), (15, 744)], f"a motion without contact beside one: {answers}")
    check(abs(both["unseen_below"] - 0.1707) < 1e-3, f"basins that none of 16 starts has reached: {both['unseen_below']}")
    expect(2, "run", beam, "--lanes", "-1", says="--lanes takes N from 0 to 1024")
    quiet = json.loads(expect(0, "run", beam, "--set", "joint.clearance=0.001", "--jobs", "1", "--json").stdout)
    check((quiet["type"], quiet["types"]["reason"]) == ("I", "one answer"), f"type of a beam that does not touch: {quiet}")
    torus = expect(0, "run", beam, "--set", "beam.modes=4", "--lanes", "0").stdout
    check(torus.startswith("Quasi-periodic") and "use more beam.modes" in torus, f"run of four modes: {torus}")


def check_follow():
    """The branch of period 1 of set B: it is stable from a torus at 181 Hz on; at the first fold the sweep up jumps."""
    beam = str(source / "assets/beams/ibs.json")
    branch = json.loads(expect(0, "study", beam, "--set", "drive.frequency=190", "--follow", "drive.frequency=180:290",
                               "--json").stdout)
    located = [p for p in branch["points"] if p["point"] not in ("start", "end")]
    all_of = located + [p for b in branch["begun"] for p in b["points"] if p["point"] not in ("start", "end")]
    for point in (p for p in all_of if p["point"] != "touching"):
        size = (point["multiplier_re"] ** 2 + point["multiplier_im"] ** 2) ** 0.5
        check(abs(size - 1) < 1e-6, f"a located multiplier off the circle: {point}")
    tori = [p["value"] for p in located if p["point"] == "Neimark-Sacker"]
    folds = [p["value"] for p in located if p["point"] == "fold"]
    check(abs(tori[0] - 181.011) < 0.01 and abs(max(folds) - 276.658) < 0.01, f"tori {tori}, folds {folds}")
    forks = [p["value"] for p in located if p["point"] == "pitchfork"]
    check(abs(forks[0] - 190.7329) < 0.01 and abs(forks[1] - 211.1358) < 0.01, f"the orbit loses its symmetry at {forks}")
    flips = [p["value"] for b in branch["begun"] for p in b["points"] if p["point"] == "flip"]
    check(any(abs(f - 204.1968) < 0.01 for f in flips) and any(b["period"] == 2 for b in branch["begun"]), f"flips {flips}")
    free = json.loads(expect(0, "study", beam, "--set", "drive.frequency=250", "--set", "drive.force=30", "--follow",
                             "drive.force=20:80", "--json").stdout)
    touch = [p["value"] for p in free["points"] if p["point"] == "touching"]
    check(len(touch) == 1 and abs(touch[0] - 63.0773) < 1e-3, f"end of the branch without contact: {touch}")
    plane = ("study", beam, "--set", "drive.frequency=230", "--follow", "drive.frequency=200:300", "--vary",
             "joint.clearance=0.00011:0.00014:3")
    answer = expect(0, *plane, "--json", "--jobs", "4").stdout
    curves = json.loads(answer)
    check(curves["over"] == "joint.clearance" and len(curves["curves"]) > 1, f"curves over two numbers: {curves['curves']}")
    near = [p for c in curves["curves"] if c["point"] == "fold" for p in c["points"] if p[1] == 0.000127]
    check(any(abs(p[0] - 276.658) < 0.01 for p in near), f"the curve of a fold goes through it: {near}")
    forks = [p for c in curves["curves"] if c["point"] == "pitchfork" for p in c["points"] if p[1] == 0.000127]
    check(any(abs(p[0] - 211.1358) < 0.01 for p in forks), f"the curve of a pitchfork goes through it: {forks}")
    for curve in curves["curves"]:
        seconds = [p[1] for p in curve["points"]]
        check(seconds == sorted(seconds) and seconds[-1] <= 0.00014, f"a curve by rising second number: {seconds}")
    check(expect(0, *plane, "--json", "--jobs", "1").stdout == answer, "curves do not depend on the number of jobs")
    expect(2, *plane[:-1], "joint.clearance=1:2:3", says="outside the range 1 to 2")
    expect(2, *plane[:-1], "drive.frequency=100:200:3", says="is not another number")
    starts = expect(0, "study", beam, "--set", "beam.modes=2", "--vary", "drive.frequency=200:220:2", "--runs", "3").stdout
    check("\n3 random starts at each value, seeds 1 to 3\n" in starts, f"the runs of a beam are starts: {starts}")
    expect(1, "study", beam, "--follow", "drive.frequency=180:320", says="the motion is chaotic")
    expect(2, "study", beam, "--follow", "beam.modes=1:2", says="beam.modes is not a number that changes")
    for steps in 1, 10001:
        expect(2, "study", beam, "--set", "drive.frequency=230", "--follow", "drive.frequency=200:300", "--vary",
               f"joint.clearance=0.0001:0.0002:{steps}", says="need a range and 2 to 10000 steps")
    expect(2, "study", beam, "--follow", "beam.length=2:1", says="--follow takes NAME=FROM:TO")
    expect(2, "study", beam, "--follow", "drive.frequency=100:200", says="outside the range of --follow")
    expect(2, "study", str(source / "houses/corner-1.20-1.20.json"), "--follow", "drive.frequency=100:200",
           says="--follow is for beams")


check_beams()
check_follow()
end()
