#!/usr/bin/env python3
"""Tests the command line as scripts rely on it: exit codes, only JSON on standard output, files, messages.

command.py CLEARANCE
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile

from program import check, end, expect, house, program, run, source


def check_answers():
    answer = json.loads(expect(0, "run", house("straight-corridor"), "--json").stdout)
    for key in ("kind", "house", "seed", "dt", "steps", "completed", "time", "people", "hazards", "digest"):
        check(key in answer, f"run --json lacks {key}")
    for key in ("id", "profile", "route", "exit", "completed", "time", "path_length", "narrowest", "contacts", "peak_force",
                "ring_time", "lost_time"):
        check(key in answer["people"][0], f"a person of run --json lacks {key}")
    check(answer["people"][0]["path_length"] / 0.69 <= answer["time"], "nobody is faster than the free speed")
    answer = json.loads(expect(1, "run", house("flat-0.910-module"), "--json").stdout)
    person = answer["people"][0]
    check(person["reason"] == "cannot pass" and person["blocked_at"]["needs"] > person["blocked_at"]["has"], "blocked_at")
    answer = json.loads(expect(1, "check", house("corner-0.85-0.85"), "--json").stdout)
    check(answer["people"][0]["fits"] and not answer["people"][0]["drivable"], "0.85 m fits and is not drivable")
    answer = json.loads(expect(1, "compare", house("flat-0.910-module"), house("flat-0.910-widened"), "--json").stdout)
    check(answer["kind"] == "compare" and len(answer["differences"]) == 1, "compare --json")
    graded = json.loads(expect(0, "run", house("flat-0.910-widened"), "--json").stdout)["grades"]
    check(answer["b"]["grades"] == graded and "grades" not in answer["a"], "compare grades whoever is out, as run does")
    told = expect(1, "compare", house("flat-0.910-module"), house("flat-0.910-widened")).stdout
    check(f'; grade {graded[0]["said"]}, at' in told, "compare tells the grade in words", told)
    answer = json.loads(expect(0, "loci", house("corner-1.20-1.20"), "--json").stdout)
    check(answer["houses"][0]["locus_largest"] > 0, "loci --json")
    expect(2, "loci", house("corner-1.20-1.20"), "--driving", "miura", says="unknown option")
    answer = json.loads(expect(2, "check", str(source / "tests/data/bad/houses/many-faults.json"), "--json").stdout)
    check(len(answer["faults"]) > 1, "check --json lists several faults")
    sunk = (house("bedroom-after-earthquake"), "--set", "furniture.bed.centre=[1.0,0.57]")
    notes = json.loads(expect(0, "check", *sunk, "--json").stdout)["notes"]
    check(notes == ["bed stands 8 cm in wall w1"], f"check --json remarks {notes}")
    check(expect(0, "check", *sunk).stdout.endswith(f"\nnote: {notes[0]}\n"), "check remarks the same in words")
    check(json.loads(expect(0, "check", sunk[0], "--json").stdout)["notes"] == [], "check --json remarks nothing else")


def check_grade():
    """Nobody is said to get out without a grade, and it is that of check --grades."""
    for name, letter, words in (("corner-1.00-1.00", "C", "arms in"), ("corner-1.50-1.50", "A", "easy")):
        answer = json.loads(expect(0, "run", house(name), "--json").stdout)
        graded = json.loads(expect(0, "check", house(name), "--grades", "--json").stdout)["grades"]
        check([row["grade"] for row in answer["grades"]] == [row["grade"] for row in graded] == [letter],
              f"{name}: run tells the grade of check: {answer['grades']}, {graded}")
        said = expect(0, "run", house(name)).stdout.splitlines()[0]
        check(f"; grade {letter}, {words}" in said, f"{name}: run says {said}")
    stuck = expect(1, "run", house("flat-0.910-module"), "--json").stdout
    check("grades" not in json.loads(stuck), "who does not get out is told why instead")


def check_crowds():
    """40 people on foot and a wheelchair: totals in text, all people in JSON, no invented values for those on foot."""
    plan = {
        "format": "clearance-house", "version": 1, "name": "room",
        "walls": [{"id": "w", "points": [[0, 0], [8, 0], [8, 6], [0, 6], [0, 0]], "thickness": 0.1}],
        "doors": [{"id": "d1", "wall": "w", "segment": 1, "at": 3, "width": 1.4, "kind": "opening"}],
        "exits": [{"id": "e1", "from": [8.2, 2.2], "to": [8.2, 3.8]}],
        "people": [{"id": "p1", "profile": "manual-chair", "at": [2, 3]}],
        "crowds": [{"id": "adults", "profile": "adult", "count": 40, "area": [[3, 0.5], [7.5, 0.5], [7.5, 5.5], [3, 5.5]]}],
    }
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place, "room.json")
        file.write_text(json.dumps(plan))
        lines = expect(0, "run", str(file)).stdout.splitlines()
        check(lines[0].startswith("All 41 out in "), f"run of a crowd begins {lines[0]!r}")
        check(sum(line.startswith("adults") for line in lines) == 1, "run of a crowd has one row for it")
        answer = json.loads(expect(0, "run", str(file), "--json").stdout)
        check(len(answer["people"]) == 41, "run --json lists everybody")
        crowd = answer["crowds"][0]
        check((crowd["id"], crowd["people"], crowd["out"]) == ("adults", 40, 40), f"run --json sums crowds: {crowd}")
        late = expect(1, "run", str(file), "--until", "3").stdout
        check("are not out: " in late.splitlines()[0] and " time limit" in late, "run --until 3 of a crowd says who is not out")
        check(" more\n" in late, "run of a crowd lists some of those who are not out")
        check(late.split("not out\n", 1)[1].count(" time limit ") == 10, "run of a crowd lists ten of those who are not out")
        lines = expect(0, "check", str(file)).stdout.splitlines()
        check(lines[0] == "All 41 people can leave", f"check of a crowd begins {lines[0]!r}")
        cells = [line.split() for line in lines]
        check(["adults", "adult", "40", "40"] in cells, f"check has a line for a crowd: {lines}")
        check(cells[-1][:5] == ["p1", "manual-chair", "e1", "can", "leave"] and len(lines) == 7,
              f"check has a line for a person without a crowd: {lines}")
        people = json.loads(expect(0, "check", str(file), "--json").stdout)["people"]
        check(len(people) == 41, "check --json lists everybody")
        walker = next(person for person in people if person["id"] == "adults-1")
        check(walker["fits"] and walker["drivable"], "a person on foot can leave")
        check(walker["reversals"] is None and walker["path_length"] is None and "narrowest" not in walker,
              f"check invents nothing about somebody on foot: {walker}")


def check_beams():
    beam = str(source / "assets/beams/ibs.json")
    with tempfile.TemporaryDirectory() as out:
        answer = json.loads(expect(0, "run", beam, "--set", "beam.modes=1", "--json", "--out", out).stdout)
        plots = {f"plot-{plot}.{ending}" for plot in ("phase", "poincare", "force") for ending in ("png", "svg", "pdf", "csv")}
        check(set(os.listdir(out)) == {"summary.json", "trace.csv", "beam.png", "beam.svg", "beam.pdf"} | plots,
              f"--out of a beam holds {os.listdir(out)}")
        check(json.loads(pathlib.Path(out, "summary.json").read_text()) == answer, "summary.json of a beam is the answer")
        rows = pathlib.Path(out, "trace.csv").read_text().splitlines()
        check(rows[0] == "time [s],displacement [m],velocity [m/s],force [N]", f"trace.csv of a beam begins {rows[0]}")
    check_beam_interrupted(beam)
    expect(2, "run", beam, "--set", "drive.frequenzy=1", says="did you mean")
    expect(2, "run", beam, "--report", "--out", "out", says="--report is for houses")
    expect(2, "check", beam, says='must be "clearance-house"')
    expect(2, "run", str(source / "tests/data/bad/beams/no-mass.json"), says="beam.density is 0")


def check_beam_interrupted(beam):
    """A stiff contact switches hundreds of times per cycle, so its type takes long; Ctrl-C must end the search."""
    process = subprocess.Popen([program, "run", beam, "--set", "joint.stiffness=1e11", "--json"], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    try:
        process.wait(timeout=2)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
    output, error = process.communicate(timeout=20)
    types = json.loads(output)["types"]
    check(types["type"] == "interrupted" and types["stopped"], "run of a beam: interrupted", f"{types} {error}")


def check_options():
    one = json.loads(run("run", house("ube-techno-house"), "--json", "--jobs", "1").stdout)
    two = json.loads(run("run", house("ube-techno-house"), "--json", "--jobs=2").stdout)
    check(one == two, "--jobs changes nothing")
    route = json.loads(expect(0, "run", house("ube-techno-house"), "--json", "--route", "C").stdout)
    check([p["route"] for p in route["people"]] == ["C"], "--route C")
    miura = json.loads(expect(0, "run", house("straight-corridor"), "--json", "--driving", "miura").stdout)
    check(miura["people"][0]["driving"] == "miura", "--driving miura")
    late = json.loads(expect(1, "run", house("straight-corridor"), "--json", "--until", "2").stdout)
    check(late["people"][0]["reason"] == "time limit", "--until 2")
    wide = expect(1, "run", house("corner-1.20-1.20"), "--set", "profile.manual-chair.width=1.3")
    check("starts inside wall" in wide.stdout and "no room at start" in wide.stdout, "--set profile.manual-chair.width=1.3")


def check_rules():
    """The corridor of 0.78 m is legal and impassable; what was measured is in the files; unknown rules are refused."""
    with tempfile.TemporaryDirectory() as place:
        answer = json.loads(expect(0, "rules", house("corner-0.78-0.78"), "--rules", "jp-senior-housing-1414", "--json",
                                   "--out", place).stdout)
        check(answer["headline"].startswith("Legal and impassable: corridor c1"), answer["headline"])
        check(answer["legal_impassable"] and answer["pass"] == 1 and answer["unknown"] == 1, "counts of rules --json")
        names = sorted(path.name for path in pathlib.Path(place).iterdir())
        check(names == ["plan.pdf", "plan.png", "plan.svg", "rules.html", "rules.json", "rules.pdf"], f"rules writes {names}")
        check(json.loads(pathlib.Path(place, "rules.json").read_text()) == answer, "rules.json is the answer")
    expect(1, "rules", house("flat-0.910-module"), "--rules", "ada-2010")
    expect(2, "rules", house("straight-corridor"), "--rules", "ada", says='there are no rules "ada"')
    bad = str(source / "tests/data/bad/rules/what-unknown.json")
    expect(2, "rules", house("straight-corridor"), "--rules", bad, says="what-unknown.json:2:32: what is")


def check_fit():
    """Frequencies of a beam with another shaker give its mass; files are written; wrong use is refused."""
    beam = str(source / "assets/beams/ibs-r.json")
    with tempfile.TemporaryDirectory() as place:
        table = pathlib.Path(place, "frequencies.csv")
        table.write_text("frequency_1 [Hz],frequency_2 [Hz],frequency_3 [Hz]\n60,480,1500\n")
        answer = json.loads(expect(0, "fit", beam, "--measured", str(table), "--fit", "shaker.moving_mass", "--json",
                                   "--out", place + "/out").stdout)
        mass = answer["parameters"][0]
        check(mass["name"] == "shaker.moving_mass" and mass["low"] < mass["best"] < mass["high"], f"fit finds {mass}")
        check(answer["sum"] < answer["sum_before"] and len(answer["rows"]) == 3, "fit lowers the sum of squares")
        expect(2, "fit", beam, "--measured", str(table), "--fit", "shaker.mass", says='has no parameter "shaker.mass"')
        expect(2, "fit", beam, "--measured", str(table), "--fit", "shaker.damping", says="only what is more than 0")
        expect(2, "fit", beam, "--measured", str(table), "--fit", "beam.tip_mass", says="give --prior beam.tip_mass=VALUE:1")
        peaks = pathlib.Path(place, "peaks.csv")
        peaks.write_text("drive.frequency [Hz],peak_max [N]\n210,630\n230,690\n250,1420\n")
        short = ("--set", "beam.modes=4", "--set", "run.transient_cycles=40", "--set", "run.cycles=10")
        answer = json.loads(expect(0, "fit", beam, "--measured", str(peaks), "--fit", "beam.tip_mass", "--json", "--out",
                                   place + "/tip", "--prior", "beam.tip_mass=0.02:1", *short).stdout)
        mass = answer["parameters"][0]
        check(mass["low_95"] <= mass["low"] < mass["high"] <= mass["high_95"] and mass["told"], f"peaks tell {mass}")
        check(answer["effective_samples"] > 20, "the intervals rest on samples")
        fitted = json.loads(pathlib.Path(place, "tip/ibs-r-fitted.json").read_text())
        check(fitted["beam"]["tip_mass"]["value"] == mass["value"], "the fitted beam has the told mass")
        said = fitted["beam"]["tip_mass"]["provenance"]
        check(re.search(r"peaks\.csv \([0-9a-f]{16}\), 3 values", said), f"its source has a digest: {said}")
        expect(2, "fit", beam, "--measured", str(table), "--fit", "shaker.position", "--prior", "shaker.position=1",
               says="--prior takes NAME=VALUE:SPREAD")
        expect(2, "fit", house("ube-techno-house"), "--measured", str(table), says="--measured is for beams")
        times = pathlib.Path(place, "times.csv")
        times.write_text("route,time [s]\nZ,3\n")
        expect(2, "fit", house("ube-techno-house"), "--observed", str(times), says='times.csv:2:1: the house has no route "Z"')
        for text, says in (("route,time [s]\nA,12,99\n", "2:1: the row has 3 columns, must have 2, like the heading"),
                           ("time [s]\n12\n", "1:1: the first row must name route and time"),
                           ("a\0b", "1:1: the file contains a zero byte, must be text")):
            times.write_text(text)
            done = expect(2, "fit", house("ube-techno-house"), "--observed", str(times), says=f"times.csv:{says}")
            check(done.stderr.count("\n") == 1, "one line for one cause", done.stderr)
        times.write_text("x\n")
        done = expect(2, "run", house("ube-techno-house"), "--observed", str(times), "--report", "--out", place,
                      says='times.csv:1:1: the heading lacks the columns "time" and "y", the first row must name time, x and y')
        check(done.stderr.count("\n") == 1, "one line for one cause", done.stderr)
    expect(2, "fit", house("straight-corridor"), says="has observed times")


def check_wrong_use():
    expect(2, "rnu", says="did you mean run?")
    expect(2, "run", says="usage: clearance run")
    expect(2, "run", house("straight-corridor"), "--ruote", "A", says="did you mean --route?")
    expect(2, "run", house("straight-corridor"), "--jobs", "many", says="--jobs takes N")
    expect(2, "run", house("straight-corridor"), "--set", "door.d1.width=1", says='there is no door "d1"')
    expect(2, "run", house("straight-corridor"), "--set", "person.p1.heding=1", says="did you mean")
    expect(2, "run", house("ube-techno-house"), "--route", "E", says="its routes are A, B, C, D")
    expect(2, "run", "nowhere.json", says="nowhere.json:1:1: cannot be read")
    expect(2, "run", house("straight-corridor"), "--size", "1x1", says="--size takes WxH")
    expect(2, "run", house("straight-corridor"), "--out", "/proc/nowhere", says="cannot be written")
    with tempfile.TemporaryDirectory() as place:
        bad, out = pathlib.Path(place, "bad.json"), pathlib.Path(place, "new", "out")
        sheet = ("lesson", "sheet")
        for kind, verbs in (("house", ("run", "compare", "rules", "study", "fit", "ablate", "cases")),
                            ("beam", ("run", "study", "paper", "types", "follow")),
                            ("crank", ("run", "study", "paper")), ("lesson", (sheet,))):
            bad.write_text(json.dumps({"format": f"clearance-{kind}", "version": 1}))
            for verb in verbs:
                more = {"compare": [bad], "fit": ["--measured", bad, "--fit", "person.p1.at"],
                        "study": ["--vary", "run.dt=1:2:2"], "paper": ["--paper"], "types": ["--types", "drive.frequency"],
                        "follow": ["--follow", "drive.frequency=20:30"]}.get(verb, [])
                words = verb if verb == sheet else ("study",) if verb in ("paper", "types", "follow") else (verb,)
                expect(2, *words, str(bad), *map(str, more), "--out", str(out), says="bad.json")
                check(not out.parent.exists(), f"{verb} of a bad {kind} leaves {out.parent} behind")
        expect(2, "run", str(source / "assets/beams/ibs.json"), "--set", "beam.youngs_modulus=1e13", "--set",
               "beam.modes=42", "--set", "drive.frequency=1", "--out", str(out), says="as fast as the drive")
        check(not out.parent.exists(), f"a beam that cannot be built leaves {out.parent} behind")
        out.mkdir(parents=True)
        expect(2, "cases", str(bad), "--out", str(out), says="bad.json")
        check(out.exists(), "a folder that was there before a wrong input, perhaps another program's, stays")
    expect(2, "schema", "clutch", says='names FILE, not "clutch"')
    check(expect(0, "schema", "man").stdout.startswith(".TH CLEARANCE 1 "), "schema man")
    for shell in ("bash", "zsh", "fish"):
        check("print-shards" in expect(0, "schema", "completion", shell).stdout, f"completion for {shell}")
    names = expect(0, "schema", "names", house("flat-0.910-module")).stdout
    check("\ndoor.d3.width\t" in names and "\nprofile.manual-chair.body.width\t" in names, "names of a house", names)
    check("\ndrive.frequency\t" in expect(0, "schema", "names", str(source / "assets/beams/ibs.json")).stdout, "of a beam")
    expect(2, "schema", "completion", "tcsh", says="bash, zsh and fish")
    expect(2, "schema", "names", says="needs the FILE")
    expect(2, "schema", "house", "x", says="takes no other word")
    for arguments in (["--help"], ["--version"], ["run", "--help"], ["check", "--help"], ["schema", "house"]):
        check(run(*arguments).stdout, f"{arguments} says nothing")
        expect(0, *arguments)


def check_numbers():
    """A number out of its range is refused in one line that gives the range."""
    beam = str(source / "assets/beams/ibs.json")
    for option, taken, values in (
        ("--slow", "TIMES from 0.001 to 1000000000", ("1e10", "1e300", "nan", "inf", "-1", "0", "")),
        ("--jobs", "N from 1 to 1024", ("0", "-1", "1.5", "1e3", "nan", "9223372036854775808", "")),
        ("--seed", "N from 0 to 9223372036854775807", ("9223372036854775808", "-1", "1.5", "nan", "")),
        ("--from", "SECONDS from 0 to 1000000000", ("-1", "1e10", "nan", "")),
        ("--until", "SECONDS from 0 to 100000", ("-1", "1e6", "1e400", "nan", "inf", "")),
    ):
        for value in values:
            done = expect(2, "run", beam, f"{option}={value}", says=f'clearance: {option} takes {taken}, not "{value}": ')
            check(done.stderr.count("\n") == 1, f"{option}={value}: {done.stderr}")
    expect(2, "run", beam, "--until", "3", says="--until is for houses")
    expect(2, "study", beam, "--runs", "2", "--until", "3", says="--until is for houses")


def check_help():
    """Help fits into 100 columns, groups options by use, and has the topics that the README refers to."""
    for verb in ("open", "run", "check", "compare", "study", "loci", "fit", "rules", "cases", "import", "export", "schema", "help"):
        text = expect(0, verb, "--help").stdout
        check(text.startswith(f"Usage: clearance {verb} "), f"{verb} --help begins {text[:40]!r}")
        check(max(map(len, text.splitlines())) <= 100, f"a line of {verb} --help is too long")
        check(expect(0, "help", verb).stdout == text, f"help {verb} is {verb} --help")
    text = expect(0, "run", "--help").stdout
    check([line for line in text.splitlines() if line.endswith(":") and line[0] != " "] ==
          ["Examples:", "Input:", "Simulation:", "Output:", "Pictures:", "Films:", "Program:"], "groups of run --help")
    names = [line.split()[0] for line in expect(0, "help").stdout.splitlines() if line.startswith("  ")]
    for topic in ("house-file", "editing", "beams", "studies", "reports", "speed", "verification"):
        check(topic in names, f"help lacks the topic {topic}")
    for topic in names:
        text = expect(0, "help", topic).stdout
        check(len(text) > 500 and max(map(len, text.splitlines())) <= 100, f"help {topic}")
    check(run("help", "house", "file").stdout == run("help", "house-file").stdout, "help house file")
    expect(2, "help", "beam", says='there is no topic "beam", did you mean beams?')
    expect(2, "help", "house", says='there is no topic "house", did you mean house-file?')
    expect(2, "help", "huose", says='there is no topic "huose", did you mean house-file?')
    expect(2, "help", "FILE", says='there is no topic "FILE", did you mean house-file?')
    expect(2, "help", "stud", says='there is no topic "stud", did you mean one of studies, study?')
    expect(2, "help", "port", says='there is no topic "port", did you mean one of reports, import, export?')
    expect(2, "help", "weather", says='there is no topic "weather", `clearance help` lists the topics')
    expect(2, "help", "", says="there is no topic")
    expect(2, "help", "s", says='there is no topic "s", `clearance help` lists the topics')
    expect(2, "help", "../profiles/adult", says="there is no topic")
    text = expect(0, "compare", "--help").stdout
    for word in ("beam", "study", "--shake", "poincare"):
        check(word not in text, f"compare --help speaks of {word}")
    expect(2, "compare", house("corner-1.20-1.20"), house("corner-1.20-1.20"), "--plots", "poincare", says="--plots takes speed,")
    expect(2, "run", house("straight-corridor"), "--jobs", "1025", says="--jobs takes N from 1 to 1024, not")
    expect(2, "run", house("straight-corridor"), "--driving", "miur", says="did you mean miura?")
    expect(2, "run", house("straight-corridor"), "--json=yes", says="--json takes no value")


def check_open():
    """Without a display no window opens, and the message names the alternatives."""
    nothing = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "SDL_VIDEODRIVER": ""}
    for arguments in ([], ["open"], ["open", house("straight-corridor")], [house("straight-corridor")], ["nowhere.json"]):
        done = expect(2, *arguments, says="there is no display", **nothing)
        check(done.stderr.count("\n") == 1 and "clearance run" in done.stderr, f"{arguments}: {done.stderr}")
    expect(2, "open", "--text", "4", says="--text takes 1|2|3")
    expect(2, "open", "--benchmark-window", "0", says="--benchmark-window takes SECONDS")
    expect(2, "--theem", "board", says="did you mean --theme?")
    expect(2, "open", "a.json", "b.json", says="one argument too many")


def check_files():
    with tempfile.TemporaryDirectory(prefix="clearance out ä ") as out:
        expect(0, "run", house("two-chairs-corridor"), "--out", out, "--size", "800x450", "--theme", "board")
        names = {"summary.json", "trace.csv", "trajectory.sqlite", "plan.png", "plan.svg", "plan.pdf"}
        check(set(os.listdir(out)) == names, f"--out holds {os.listdir(out)}")
        summary = json.loads(pathlib.Path(out, "summary.json").read_text())
        answer = json.loads(run("run", house("two-chairs-corridor"), "--json").stdout)
        check(summary == answer, "summary.json is the answer")
        header = pathlib.Path(out, "trace.csv").read_text().splitlines()[0]
        check(header.startswith("time [s],person [1],x [m],y [m],heading [rad]"), f"trace.csv begins {header}")
        png = pathlib.Path(out, "plan.png").read_bytes()
        check(png[16:24] == (800).to_bytes(4, "big") + (450).to_bytes(4, "big"), "plan.png is 800x450")


def check_cases():
    """One test passes, one fails, one does not apply; the tables; an interrupted run."""
    corridor = house("straight-corridor")
    with tempfile.TemporaryDirectory() as folder:
        def case(name, **members):
            path = os.path.join(folder, f"{name}.json")
            head = {"format": "clearance-case", "version": 1, "id": name, "suite": f"S {name}", "title": "a | b <c>"}
            pathlib.Path(path).write_text(json.dumps({**head, **members}))
            return path
        slow = {"id": "slow", "house": corridor, "set": "exit.e1.opens=90000 run.until=90000"}
        good = case("good", house=corridor, checks=[{"measure": "out", "low": 1, "unit": "1"}])
        bad = case("bad", house=corridor, checks=[{"measure": "time", "high": 1, "unit": "s", "why": "it is <far>"}])
        case("none", applies=False, reason="there are no stairs")
        check(" yes" in expect(0, "cases", good).stdout, "cases: a test passes")
        check("it is <far>" in expect(1, "cases", bad).stdout, "cases: says why not")
        out = os.path.join(folder, "out")
        answer = json.loads(expect(1, "cases", folder, "--json", "--out", out).stdout)
        check([c["passed"] for c in answer["cases"]] == ["no", "yes", "does not apply"], "cases --json of a directory")
        check(json.loads(pathlib.Path(out, "cases.json").read_text()) == answer, "cases.json is the answer")
        page, table = (pathlib.Path(out, f"cases.{end}").read_text() for end in ("html", "md"))
        check("it is &lt;far&gt;" in page and "<far>" not in page, "cases.html is escaped")
        check("a \\| b <c>" in table and "there are no stairs" in table, "cases.md is a table")
        check(json.loads(expect(1, "cases", folder, "--json", "--jobs", "2").stdout) == answer, "--jobs changes nothing")
        expect(2, "cases", good, good, says="ids must be unique")
        expect(2, "cases", os.path.join(source, "assets"), says="holds no .json files")
        check_cases_interrupted(case("slow", house=corridor, variants=[slow],
                                     checks=[{"measure": "time", "variant": "slow", "high": 1, "unit": "s"}]))


def check_cases_interrupted(path):
    process = subprocess.Popen([program, "cases", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        process.wait(timeout=1)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
    output, error = process.communicate(timeout=60)
    check(process.returncode == 1 and "interrupted" in error and "not run" in output, "cases: interrupted", output + error)


def check_interrupt():
    """Two people who block each other are simulated for an hour; Ctrl-C ends the run, and its record is written."""
    with tempfile.TemporaryDirectory() as out:
        process = subprocess.Popen(
            [program, "run", house("straight-corridor"), "--set", "exit.e1.opens=90000", "--until", "90000", "--out", out],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            process.wait(timeout=1.5)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
        _, error = process.communicate(timeout=60)
        check(process.returncode == 1, f"interrupted: exit code {process.returncode}")
        check("interrupted" in error, "interrupted: says so", error)
        check(os.path.exists(os.path.join(out, "summary.json")), "interrupted: what there is is kept")


for part in (check_answers, check_grade, check_crowds, check_beams, check_options, check_rules, check_fit, check_wrong_use, check_numbers, check_help,
             check_open, check_files, check_cases, check_interrupt):
    part()
end()
