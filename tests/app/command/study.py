#!/usr/bin/env python3
"""Tests the command study: answers, files, resuming after Ctrl-C, wrong use."""

import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time

from program import check, end, expect, house, program, run, source

FLAT = {
    "format": "clearance-house", "version": 1, "name": "flat",
    "walls": [{"id": "south", "points": [[0, -0.05], [6, -0.05]], "thickness": 0.1},
              {"id": "north", "points": [[0, 1.25], [6, 1.25]], "thickness": 0.1},
              {"id": "west", "points": [[-0.05, -0.05], [-0.05, 1.25]], "thickness": 0.1},
              {"id": "middle", "points": [[3, 0], [3, 1.2]], "thickness": 0.1}],
    "doors": [{"id": "d1", "wall": "middle", "at": 0.6, "width": 1}],
    "exits": [{"id": "e1", "from": [5, 0], "to": [5, 1.2]}],
    "people": [{"id": "p1", "profile": "manual-chair", "at": [1, 0.6]}],
}
DOOR = ("--vary", "door.d1.width=0.6:1.1:11")


def draft(folder, name="flat", **members):
    path = os.path.join(folder, f"{name}.json")
    pathlib.Path(path).write_text(json.dumps({**FLAT, **members}))
    return path


def summary(folder):
    return json.loads(pathlib.Path(folder, "summary.json").read_text())


def check_answers(folder):
    flat = draft(folder)
    done = expect(0, "study", flat, *DOOR)
    words = done.stdout.splitlines()
    check(words[0] == f"{flat}: door.d1.width from 0.60 to 1.10 m in 11 steps", f"title {words[0]!r}")
    check(words[1].startswith("not out at 0.60 m, out from 0.65 m on; the time until all people are out falls from"),
          f"answer {words[1]!r}")
    check(words[4].split()[:4] == ["door.d1.width", "m", "answer", "grade"], f"table {words[4]!r}")
    check(len(words) == 5 + 11, f"a row a value: {len(words)}")
    answer = json.loads(expect(0, "study", flat, *DOOR, "--json", "--jobs", "1").stdout)
    check((answer["kind"], answer["experiment"], answer["runs"]) == ("study", "house", 1), f"--json {answer}")
    check(answer["trials"] == answer["done"] == 11 and answer["faults"] == 0, "--json counts")
    check([r["answer"] for r in answer["ranges"]] == ["not regular", "regular"], f"ranges {answer['ranges']}")
    check(answer["ranges"][1]["to"] == 1.1 and answer["best"]["value"] <= answer["worst"]["value"], "best and worst")
    two = json.loads(expect(0, "study", flat, *DOOR, "--json", "--jobs", "4").stdout)
    check(two == answer, "--jobs changes nothing")
    alone = json.loads(run("run", flat, "--set", "door.d1.width=0.65", "--json").stdout)
    check(answer["worst"]["at"]["door.d1.width"] == 0.65 and answer["worst"]["value"] == alone["time"], "study is run")
    expect(1, "study", flat, "--vary", "door.d1.width=0.3:0.5:3")
    late = expect(1, "study", flat, *DOOR, "--until", "1")
    check("not out throughout" in late.stdout, "--until of a study", late.stdout)
    many = expect(1, "study", flat, "--vary", "door.d1.width=0.6:1.1:26", "--until", "1").stdout
    check(many.endswith("\n12 of 26 steps are shown; --out writes the table of all\n"), "a table says how much it shows", many)


def check_grades(folder):
    """Each row has the grade of run on the same house, for any number of threads, read back or run at once."""
    flat, out = draft(folder), os.path.join(folder, "grades")
    done = expect(0, "study", flat, *DOOR, "--out", out, "--jobs", "2")
    words = done.stdout.splitlines()
    check(words[2] == "grade D, at door d1, at 0.65 m; grade C, at door d1, at 0.70 m; grade B, at door d1, from 0.75 to 0.90 m; "
          "grade A from 0.95 m on",
          f"ranges of grades {words[2]!r}")
    with open(os.path.join(out, "study.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    listed = {round(row["at"]["door.d1.width"], 6): row for row in summary(out)["grades"]}
    check(len(rows) == 11 and len(listed) == 10, "who is not out has no grade")
    table = [line.split() for line in words[5:16]]
    for row, shown in zip(rows, table):
        width = round(float(row["door.d1.width [m]"]), 6)
        alone = json.loads(run("run", flat, "--set", f"door.d1.width={width}", "--json").stdout).get("grades", [])
        letters = [row["grade [1]"], listed[width]["grade"], shown[2]] if alone else [row["grade [1]"]]
        check(set(letters) == {alone[0]["grade"] if alone else ""}, f"{width}: {letters} are not those of run: {alone}")
        check(row["grade_place [1]"] == (alone[0].get("what", "") if alone else ""),
              f"{width}: the place {row['grade_place [1]']} is not that of run: {alone}")
    files = {name: pathlib.Path(out, name).read_bytes() for name in ("study.csv", "summary.json")}
    again = expect(0, "study", flat, *DOOR, "--out", out, says="all 11 runs are read back")
    check(again.stdout == done.stdout, "grades are read back", again.stdout)
    expect(0, "study", flat, *DOOR, "--out", os.path.join(folder, "one"), "--jobs", "1")
    for name, content in files.items():
        check(content == pathlib.Path(out, name).read_bytes() == pathlib.Path(folder, "one", name).read_bytes(), f"bytes of {name}")
    closing = draft(folder, "closing", exits=FLAT["exits"] + [{"id": "near", "from": [0.4, 0], "to": [0.4, 1.2], "closes": 15}],
                    doors=[{**FLAT["doors"][0], "width": 0.7}])
    late = json.loads(expect(0, "study", closing, "--vary", "person.p1.delay=0:30:4", "--json").stdout)["grades"]
    alone = [json.loads(run("run", closing, "--set", f"person.p1.delay={delay}", "--json").stdout)["grades"][0]["grade"]
             for delay in (0, 10, 20, 30)]
    check([row["grade"] for row in late] == alone and len(set(alone)) == 2,
          f"whoever starts once the near exit is closed has another grade: {late}, alone {alone}")
    several = expect(0, "study", flat, "--runs", "3").stdout
    check("\ngrade A, easy\n" in several, "runs of one house have one grade", several)
    drivers = json.loads(expect(0, "study", flat, "--vary", "door.d1.width=0.7:0.8:2", "--drivers", "3", "--json").stdout)
    check([row["grade"] for row in drivers["grades"]] == ["C", "B"], f"grades beside drivers {drivers['grades']}")
    spread = expect(0, "study", flat, "--runs", "3", "--spread", "profile.manual-chair.free_speed=0.1", "--json").stdout
    check("grades" not in json.loads(spread), "a tolerance makes each run another house: no grades")
    crowd = draft(folder, "crowd", people=FLAT["people"] + [
        {"id": f"a{n}", "profile": "adult", "at": [3.4 + 0.5 * (n // 2), 0.3 + 0.6 * (n % 2)]} for n in range(6)])
    check(json.loads(expect(0, "study", crowd, "--vary", "door.d1.width=1:1.1:2", "--json").stdout)["grades"] == [],
          "a crowd has no grades")


def check_maps_and_runs(folder):
    flat = draft(folder)
    words = expect(0, "study", flat, "--vary", "door.d1.width=0.6:1.1:3", "--vary",
                   "profile.manual-chair.width=0.5:0.7:3").stdout
    check("out in 7 of 9 runs" in words, "a map counts", words)
    check("A to F out with that grade, . not out\nto the right door.d1.width, upwards " in words and "0.7 .BA" in words,
          "a map in letters", words)
    spread = ("--runs", "12", "--spread", "profile.manual-chair.free_speed=0.1")
    words = expect(0, "study", flat, *spread).stdout
    check("12 runs, seeds 1 to 12\nprofile.manual-chair.free_speed with a standard deviation of 10 %\n" in words, words)
    check("out in 12 of 12 runs: 100.0 %, with 95 % confidence from 75.8 to 100.0 %" in words, "confidence", words)
    words = expect(0, "study", flat, "--drivers", "2").stdout
    check(": 2 drivers\n2 of 2 drivers out: 100.0 %" in words and "seeds" not in words, "drivers of a study", words)
    missing = expect(2, "run", flat, "--drivers", "2", "--population", "nobody").stderr
    check('unknown population "nobody"; known are manual-jp, whm, or' in missing, "known populations", missing)
    answer = json.loads(expect(0, "study", flat, *spread, "--json").stdout)
    time_of = answer["distribution"]["observables"]["time"]
    check(time_of["count"] == 12 and time_of["q05"] < time_of["q50"] < time_of["q95"], f"distribution {time_of}")
    check(abs(time_of["standard_error"] * 12 ** 0.5 / time_of["deviation"] - 1) < 1e-9, "standard error")
    other = json.loads(expect(0, "study", flat, *spread, "--json", "--seed", "13").stdout)
    check(other["seed"] == 13 and other["digest"] != answer["digest"], "--seed of a study")
    check("all runs are alike" in expect(0, "study", flat, "--runs", "2").stdout, "nothing left to chance")


def check_files(folder):
    flat, out = draft(folder), os.path.join(folder, "files")
    expect(0, "study", flat, *DOOR, "--runs", "2", "--spread", "profile.manual-chair.free_speed=0.05", "--out", out)
    names = {"summary.json", "study.csv", "study-points.csv", "study.sqlite"}
    kept = set(os.listdir(out))
    check({name for name in kept if not name.startswith("plot-")} == names, f"--out of a study holds {kept}")
    check({f"plot-time.{kind}" for kind in ("png", "svg", "pdf", "csv")} <= kept, f"--out of a study plots {kept}")
    with open(os.path.join(out, "study.csv"), newline="") as file:
        rows = list(csv.reader(file))
    check(rows[0][:6] == ["door.d1.width [m]", "profile.manual-chair.free_speed [m/s]", "pass [1]", "seed [1]",
                          "completed [1]", "time [s]"], f"study.csv begins {rows[0]}")
    check(len(rows) == 1 + 22 and all(len(row) == len(rows[0]) for row in rows), "study.csv has a row a run")
    with open(os.path.join(out, "study-points.csv"), newline="") as file:
        rows = list(csv.reader(file))
    check(len(rows) == 1 + 11 and all(len(row) == len(rows[0]) for row in rows), "study-points.csv has a row a point")
    wide = expect(0, "study", flat, "--vary", "door.d1.width=1:2:3", "--out", os.path.join(folder, "wide")).stdout
    check("runs could not be made; the first: " in wide and "door d1" in wide, "runs with faults", wide)


def interrupt(arguments, seconds):
    process = subprocess.Popen([program, "study", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        process.wait(timeout=seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
    output, error = process.communicate(timeout=60)
    return process.returncode, output, error


def check_going_on(folder):
    flat, whole, parts = draft(folder), os.path.join(folder, "whole"), os.path.join(folder, "parts")
    arguments = [flat, "--vary", "door.d1.width=0.85:1.1:61", "--runs", "3", "--spread",
                 "profile.manual-chair.free_speed=0.05"]
    expect(0, "study", *arguments, "--out", whole)
    for seconds in (0.7, 2, 5, 10):  # a busy machine needs longer to complete the first run
        code, words, error = interrupt([*arguments, "--out", parts, "--jobs", "1"], seconds)
        before = summary(parts)
        if before["done"]:
            break
    check(code == 1 and "interrupted after" in error and "the same command continues" in error, "interrupted", error)
    check("only these are told" in words, "the words say so", words)
    check(0 < before["done"] < 183, f"what is complete is kept: {before['done']} of 183")
    with open(os.path.join(parts, "study.csv")) as file:
        check(len(file.readlines()) == 1 + before["done"], "study.csv of an interrupted study")
    done = expect(0, "study", *arguments, "--out", parts, says=f"where {before['done']} of 183 runs are done")
    for name in ("summary.json", "study.csv", "study-points.csv"):
        check(pathlib.Path(parts, name).read_bytes() == pathlib.Path(whole, name).read_bytes(), f"{name} of two goes")
    begin = time.monotonic()
    again = expect(0, "study", *arguments, "--out", parts, says="all 183 runs are read back")
    check(again.stdout == done.stdout and time.monotonic() - begin < 5, "a finished study is read back")
    changed = draft(folder, people=[{"id": "p1", "profile": "manual-chair", "at": [1.2, 0.6]}])
    short = [changed, "--vary", "door.d1.width=0.9:1:2", "--out", parts]
    expect(0, "study", *short, says="this one starts from the beginning")
    expect(0, "study", *short, says="all 2 runs are read back")
    expect(0, "study", *short, "--set", "person.p1.delay=1", says="this one starts from the beginning")
    draft(folder)
    expect(0, "study", *arguments, "--out", parts, says="all 183 runs are read back")


def check_killed(folder):
    """After a power failure only the runs since the last commit are repeated."""
    flat, out = draft(folder), os.path.join(folder, "killed")
    arguments = [flat, "--vary", "door.d1.width=0.85:1.1:121", "--runs", "2", "--jobs", "1"]
    process = subprocess.Popen([program, "study", *arguments, "--out", out], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    store = pathlib.Path(out, "study.sqlite")
    while process.poll() is None and not (store.exists() and store.stat().st_size):
        time.sleep(0.01)
    time.sleep(0.5) # the first commit must be complete
    process.kill()
    process.wait()
    check(process.returncode == -signal.SIGKILL, "killed while it ran")
    expect(0, "study", *arguments, "--out", out, says="continues in")
    plain = json.loads(expect(0, "study", *arguments, "--json").stdout)
    check(summary(out) == plain, "a study that was killed ends as one of one go")


def check_changed_while_running(folder):
    flat, out = draft(folder, "changing"), os.path.join(folder, "changing")
    process = subprocess.Popen([program, "study", flat, "--vary", "door.d1.width=0.85:1.1:61", "--runs", "2", "--jobs",
                                "1", "--out", out], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while process.poll() is None and not os.path.exists(os.path.join(out, "study.sqlite")):
        time.sleep(0.01)
    draft(folder, "changing", note="another")
    _, error = process.communicate(timeout=120)
    check(process.returncode == 2 and "changed during the study" in error, "a file that changes", error)
    draft(folder, "changing")
    done = expect(0, "study", flat, "--vary", "door.d1.width=0.85:1.1:61", "--runs", "2", "--out", out)
    check("continues" not in done.stderr and "read back" not in done.stderr, "nothing of both is kept", done.stderr)


def check_beams(folder):
    beam, whole, parts = str(source / "assets/beams/ibs.json"), os.path.join(folder, "b1"), os.path.join(folder, "b2")
    sweep = [beam, "--vary", "drive.frequency=285:305:21", "--sweep", "reset,up,down"]
    lines = expect(0, "study", *sweep, "--jobs", "1", "--out", whole).stdout.splitlines()
    check(lines[0] == f"{beam}: drive.frequency from 285 to 305 Hz in 21 steps", f"title of a beam {lines[0]!r}")
    check(lines[1].startswith("reset: periodic up to 297 Hz, not periodic from 298") and lines[2].startswith("up: ") and
          "the largest peak force" in lines[1], f"answer of a beam {lines[1:4]}")
    check({"study.csv", "study-series.csv", "study.sqlite", "summary.json"} <= set(os.listdir(whole)), "files of a beam")
    header = pathlib.Path(whole, "study-series.csv").read_text().splitlines()[0]
    check(header == "drive.frequency [Hz],pass [1],seed [1],place [1],peak [N]", f"study-series.csv begins {header}")
    interrupt([*sweep, "--jobs", "2", "--out", parts], 0.4)
    expect(0, "study", *sweep, "--jobs", "2", "--out", parts)
    for name in ("summary.json", "study.csv", "study-series.csv"):
        check(pathlib.Path(parts, name).read_bytes() == pathlib.Path(whole, name).read_bytes(), f"{name} of a beam")
    basins = json.loads(expect(0, "study", beam, "--set", "drive.frequency=290", "--runs", "8", "--json").stdout)
    check(basins["regular"] == 8 and basins["distribution"]["observables"]["peak_max"]["count"] == 8, f"starts {basins}")
    few = ["--set", "beam.modes=8", "--json"]
    typed = json.loads(expect(0, "study", beam, *few, "--vary", "drive.frequency=250:300:2", "--types",
                              "drive.frequency,joint.clearance", "--out", parts).stdout)
    rows = [row.split(",") for row in pathlib.Path(parts, "study.csv").read_text().splitlines()]
    check("type [1]" in rows[0] and typed["done"] == 2, f"types over a range {rows[0]}")
    check([row[rows[0].index("type [1]")] for row in rows[1:]] == ["2", "3"], f"types over a range {rows}")
    expect(0, "study", beam, *few, "--vary", "drive.frequency=250:290:2", "--thorough", "--out", parts)
    rows = [row.split(",") for row in pathlib.Path(parts, "study.csv").read_text().splitlines()]
    check(all(float(row[rows[0].index("lyapunov [1]")]) < 0 for row in rows[1:]), f"exponents over a range {rows}")
    expect(2, "study", house("straight-corridor"), "--runs", "2", "--thorough", says="--thorough is for beams")
    expect(2, "study", beam, "--vary", "drive.frequenzy=1:2:3", says='did you mean "drive.frequency"?')
    expect(2, "study", beam, "--vary", "joint.release=1:2:3", says="joint.release is not a number")
    expect(2, "study", beam, "--vary", "drive.frequency=0:20:3", says="0 is out of range, must be from 1 to 100000 Hz")
    expect(2, "study", beam, "--runs", "2", "--route", "A", says="--route is for houses")
    expect(2, "study", beam, "--types", "beam.modes", says="beam.modes is an integer")


def check_paper(folder):
    beam, out = str(source / "assets/beams/ibs.json"), pathlib.Path(folder, "paper")
    short = ["--set", "beam.modes=2", "--set", "run.transient_cycles=20", "--set", "run.cycles=20"]
    answer = json.loads(expect(0, "study", beam, "--paper", *short, "--json", "--quiet", "--out", str(out)).stdout)
    check(len(answer["claims"]) == 13 and len(answer["types"]) == 15, f"claims {answer}")
    check({claim["met"] for claim in answer["claims"]} <= {"met", "not met", "not told"}, f"claims {answer['claims']}")
    check(answer == json.loads((out / "summary.json").read_text()), "the paper's summary.json")
    page = (out / "paper.html").read_text()
    met = sum(claim["met"] == "met" for claim in answer["claims"])
    check(f"{met} of 13 claims of the paper are met" in page and page.count("<svg") + page.count("<img") == 10, "page")
    check([(round(r["frequency"]), round(1000 * r["length"], 1)) for r in answer["runs"]] ==
          [(190, 281.2), (300, 281.2), (290, 281.2), (290, 284.0)], f"the single runs {answer['runs']}")
    for run in answer["runs"]:
        check(run["verdict"] == "periodic" or run["survival"]["lanes"] == 64, f"a run that is not periodic is watched {run}")
    check("How many cycles" in page, "the page says how long motions last")
    for claim in answer["claims"]:
        check(claim["id"] and claim["ours"] and claim["rule"], f"a claim says all {claim}")
    check("identified" in page and "beam.modes" in page, "the page says what was changed and where numbers come from")
    check((out / "paper.pdf").read_bytes().startswith(b"%PDF"), "paper.pdf")
    check(len(list(out.glob("plot-figure-*.png"))) == 10, "a picture of each figure")
    expect(2, "study", house("straight-corridor"), "--paper", says="is not one")
    expect(2, "study", beam, "--paper", "--lanes", "0", says="--lanes has no effect with --paper")


def check_wrong_stores(folder):
    flat, out = draft(folder), os.path.join(folder, "stores")
    os.makedirs(out)
    store = pathlib.Path(out, "study.sqlite")
    store.write_text("a letter to keep " * 100)
    expect(2, "study", flat, *DOOR, "--out", out, says="is not a study database; move it or choose another --out")
    check(store.read_text() == "a letter to keep " * 100, "a foreign file stays as it was")
    other = os.path.join(folder, "run")
    expect(0, "run", house("straight-corridor"), "--out", other)
    shutil.copy(os.path.join(other, "trajectory.sqlite"), store)
    expect(2, "study", flat, *DOOR, "--out", out, says="is another program's database")
    check(store.read_bytes() == pathlib.Path(other, "trajectory.sqlite").read_bytes(), "a foreign database stays")
    store.unlink()
    expect(0, "study", flat, *DOOR, "--out", out)
    half = store.read_bytes()
    store.write_bytes(half[:5000])
    expect(2, "study", flat, *DOOR, "--out", out, says="is damaged")
    full = run("study", flat, *DOOR, "--out", os.path.join(folder, "full"), limit=3000)
    check(full.returncode == 2 and "cannot be written" in full.stderr, "a full disk", full.stderr)
    late = run("study", flat, "--vary", "person.p1.delay=0:4:800", "--until", "0.01", "--out",
               os.path.join(folder, "late"), limit=40000)
    check(late.returncode == 2 and "earlier results are kept" in late.stderr and "not out throughout" in
          late.stdout, "a disk that fills up leaves the answer", late.stderr)
    expect(2, "study", flat, *DOOR, "--out", "/proc/nowhere", says="cannot be written")


def check_wrong_use(folder):
    flat = draft(folder)
    delay = "person.p1.delay"
    wrong = {
        (): "there is nothing to study; use --vary NAME=FROM:TO:STEPS, --runs N, --shake N or --drivers N",
        ("--vary", "door.d2.width=1:2:3"): '--vary door.d2.width: there is no door "d2"',
        ("--vary", "door.d1.widht=1:2:3"): 'did you mean "width"?',
        ("--vary", "person.p1.at=1:2:3"): "at is a point, must be at.x or at.y",
        ("--vary", "door.d1.state=1:2:3"): "state is not a number",
        ("--vary", f"{delay}=1:2"): "--vary takes NAME=FROM:TO:STEPS",
        ("--vary", f"{delay}=1:2:3:4"): "--vary takes NAME=FROM:TO:STEPS",
        ("--vary", f"{delay}=a:2:3"): "--vary takes NAME=FROM:TO:STEPS",
        ("--vary", f"{delay}=1:2:-3"): "--vary takes NAME=FROM:TO:STEPS",
        ("--vary", "=1:2:3"): "--vary takes NAME=FROM:TO:STEPS",
        ("--vary", f"{delay}=1:2:0"): "0 steps, must be from 1 to 100000",
        ("--vary", "run.dt=1:2:0"): "0 steps, must be from 1 to 100000",
        ("--vary", f"{delay}=1:2:100001"): "100001 steps, must be from 1 to 100000",
        ("--vary", f"{delay}=1:1:2"): "FROM and TO must differ",
        ("--vary", f"{delay}=1:2:1"): "one step cannot be at 1 and at 2",
        ("--vary", f"{delay}=-1:2:3"): "-1 is out of range, must be from 0 to 1e+06 s",
        ("--vary", f"{delay}=nan:2:3"): "nan is out of range",
        ("--vary", f"{delay}=1:inf:3"): "inf is out of range",
        ("--vary", "run.reversals=0:5:3"): "is 2.5, must be an integer; use 6 steps",
        ("--vary", f"{delay}=1:2:3", "--vary", f"{delay}=1:2:4"): "is given twice",
        ("--vary", f"{delay}=1:2:3", "--vary", "run.dt=1:2:3", "--vary", "run.cell=1:2:3"): "(at most twice)",
        ("--vary", f"{delay}=1:2:100000", "--runs", "100000"): "the study has 10000000000 runs",
        ("--paper", "--vary", f"{delay}=1:2:3"): "--vary has no effect with --paper; leave it out",
        ("--paper", "--types", delay): "--types has no effect with --paper",
        ("--paper", "--route", "A"): "--route has no effect with --paper",
        ("--paper", "--seed", "3"): "--seed has no effect with --paper",
        ("--types", delay, "--spread", f"{delay}=0.1"): "--spread has no effect with --types without --vary",
        ("--types", delay, "--measured", "x.csv"): "--measured has no effect with --types without --vary",
        ("--types", f"{delay},{delay}"): f"types: {delay} is named twice",
        ("--runs", "0"): "--runs takes N",
        ("--runs", "many"): "--runs takes N",
        ("--runs", "3", "--spread", f"{delay}=0.1"): "the value is 0",
        ("--runs", "3", "--spread", "run.until=nan"): "must be greater than 0 and at most 1",
        ("--runs", "3", "--spread", "run.until"): "--spread takes NAME=SHARE",
        ("--vary", f"{delay}=1:2:3", "--spread", "run.until=0.1"): "--runs must be at least 2",
        ("--vary", f"{delay}=1:2:3", "--sweep", "up"): "runs of a house always restart, must be reset",
        ("--vary", f"{delay}=1:2:3", "--sweep", "sideways"): "--sweep takes reset,up,down",
        ("--vary", f"{delay}=1:2:3", "--route", "A"): 'has no route "A"',
        ("--vary", f"{delay}=1:2:3", "--movie", "x.mp4"): "unknown option",
    }
    for arguments, says in wrong.items():
        done = expect(2, "study", flat, *arguments, says=says)
        check(done.stderr.count("\n") == 1 and not done.stdout, f"{arguments}: one line", done.stderr)
    expect(2, "study", "nowhere.json", "--runs", "2", says="nowhere.json:1:1: cannot be read")
    expect(2, "study", says="usage: clearance study")


with tempfile.TemporaryDirectory(prefix="clearance study ä ") as directory:
    for number, part in enumerate((check_answers, check_grades, check_maps_and_runs, check_files, check_going_on, check_killed,
                                   check_changed_while_running, check_beams, check_paper, check_wrong_stores,
                                   check_wrong_use)):
        own = os.path.join(directory, str(number))
        os.makedirs(own)
        part(own)
end()
