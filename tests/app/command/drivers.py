#!/usr/bin/env python3
"""Tests drivers that a house asks for, single measured runs, rules with drivers, and fits to measured loci."""

import csv
import json
import math
import pathlib
import tempfile

from program import check, end, expect, house

CORRIDOR = json.loads(pathlib.Path(house("straight-corridor")).read_text())
PERSON = CORRIDOR["people"][0]["id"]
TIMES = {"times": [14.1, 15.2, 14.6], "drivers": ["a", "b", "a"], "touches": 1}


def write(place, name, **more):
    path = pathlib.Path(place, name)
    plan = {**CORRIDOR, **more}
    if "routes" not in plan:
        plan["routes"] = [{"id": "A", "people": [PERSON], "observed": TIMES}]
    path.write_text(json.dumps(plan, indent=2))
    return str(path)


def ask(*arguments, code=0):
    return json.loads(expect(code, *arguments, "--json").stdout)


def check_asked(place):
    asking = write(place, "asking.json", drivers={"count": 4})
    drivers = ask("run", asking)["drivers"]
    check(drivers["count"] == 4 and drivers["population"] == "manual-jp", "a house asks for its drivers", drivers)
    check(drivers == ask("run", write(place, "plain.json"), "--drivers", "4")["drivers"], "they are those of --drivers")
    other = ask("run", asking, "--drivers", "2", "--population", "whm")["drivers"]
    check(other["count"] == 2 and other["population"] == "whm", "the command line overrides the house", other)
    check("drivers" not in ask("run", asking, "--set", "drivers.count=0"), "a house can be run without its drivers")
    pair = ask("compare", write(place, "plain.json"), asking, "--report", "--out", place)
    check("The same drivers in both" in pathlib.Path(place, "report.html").read_text(), "and its report tells them")
    check(pair["drivers"]["people"][0]["drivers"] == 4, "compare takes them through both houses", pair["drivers"])
    study = ask("study", asking, "--vary", "profile.manual-chair.width=0.60:0.63:2")
    check(study == {**ask("study", asking, "--vary", "profile.manual-chair.width=0.60:0.63:2", "--drivers", "4")},
          "a study drives each point with them")
    own = pathlib.Path(place, "own.json")
    own.write_text((pathlib.Path(house("x")).parent.parent / "assets/populations/whm.json").read_text())
    near = ask("run", write(place, "near.json", drivers={"count": 1, "population": "own.json"}))["drivers"]
    check(near["population"] == "whm", "a population lies beside its house", near)
    bad = write(place, "bad.json", drivers={"count": 1, "population": "wmh"})
    expect(2, "run", bad, says='unknown population "wmh"; known are manual-jp, whm')
    expect(2, "run", bad, says="bad.json:")
    expect(2, "run", asking, "--population", "wmh", says='clearance: unknown population "wmh"')


def check_measured(place):
    answer = ask("run", write(place, "measured.json"), "--drivers", "20")
    route, single = answer["drivers"]["routes"][0], answer["drivers"]["measured"][0]
    check(abs(route["mean"] - 14.6333) < 1e-3 and abs(route["deviation"] - 0.5508) < 1e-3 and route["runs"] == 3,
          "mean and deviation follow from the times", route)
    check(single["people"] == 2 and single["touches"] == 1 and 0 <= single["inside"] <= 3, "single runs are told", single)
    check(abs(single["within"] - 0.3536) < 1e-3, "one person's scatter is told apart", single)
    alone = write(place, "one.json", routes=[{"id": "A", "people": [PERSON], "observed": {"times": [30]}}])
    rank = ask("run", alone, "--drivers", "5")["drivers"]["measured"][0]["rank"]
    check(rank.startswith("quicker than ") and rank.endswith(" of 5"), "a single run has a rank", rank)
    text = expect(0, "run", alone, "--drivers", "5").stdout
    check("single measured runs" in text and rank in text, "the rank is printed", text)


def check_rules(place):
    answer = ask("rules", house("corner-0.90-0.90"), "--rules", "jp-senior-housing-1414", "--drivers", "6", "--population",
                 "whm", "--out", place, code=0)
    corridors = [finding for finding in answer["findings"] if finding["rule"] == "corridor"]
    check(all(finding["drivers"]["count"] == 6 for finding in corridors), "drivers come through each corridor", corridors)
    check(any("grade" in finding for finding in corridors), "a place has its grade", corridors)
    check("drivers" not in ask("rules", house("corner-0.90-0.90"), "--rules", "jp-senior-housing-1414")["findings"][0],
          "without --drivers nothing is said of them")
    page = pathlib.Path(place, "rules.html").read_text()
    check("of the population whm" in page and "Drivers through" in page, "the report tells the drivers")


def check_rest(place):
    """What stays of an open sliding leaf narrows the opening, for the rules and for the chair."""
    plan = {"format": "clearance-house", "version": 1,
            "walls": [{"id": "w1", "points": [[0, 0], [6, 0], [6, 3], [0, 3], [0, 0]]}, {"id": "w2", "points": [[3, 0], [3, 3]]}],
            "doors": [{"id": "d1", "wall": "w2", "at": 1.5, "width": 0.8, "kind": "sliding"},
                      {"id": "d2", "wall": "w1", "segment": 1, "at": 1.5, "width": 1}],
            "exits": [{"id": "e1", "from": [7, 0.8], "to": [7, 2.2]}],
            "people": [{"id": "p1", "profile": "manual-chair", "at": [1, 1.5]}]}
    path = pathlib.Path(place, "rest.json")
    for state in ("open", "closed"):
        for rest, code in ((0, 0), (0.06, 1)):
            plan["doors"][0].update(state=state, rest=rest)
            path.write_text(json.dumps(plan))
            findings = ask("rules", str(path), "--rules", "jp-senior-housing-1414", code=code)["findings"]
            has = [found["has"] for found in findings if found["place"] == "door d1" and found["rule"] == "door"]
            check(len(has) == 1 and abs(has[0] - (0.8 - rest)) < 1e-6, f"a rest of {rest} m narrows a door that is {state}", has)
            nearest = ask("run", str(path))["people"][0]["narrowest"]["clearance"]
            check(nearest <= (0.8 - rest - 0.63) / 2 + 1e-6, "the chair sees the rest", nearest)


def turned(plan, angle):
    """Returns a house turned about the origin by an angle in degrees."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))

    def at(point):
        return [cosine * point[0] - sine * point[1], sine * point[0] + cosine * point[1]]

    for wall in plan["walls"]:
        wall["points"] = [at(point) for point in wall["points"]]
    for room in plan["rooms"]:
        room["outline"] = [at(point) for point in room["outline"]]
    for piece in plan["furniture"]:
        piece.update(centre=at(piece["centre"]), angle=piece.get("angle", 0) + angle)
    for person in plan["people"]:
        person.update(at=at(person["at"]), heading=person.get("heading", 0) + angle)
    for way_out in plan["exits"]:
        way_out.update({"from": at(way_out["from"]), "to": at(way_out["to"])})
    return plan


def check_turned_rules(place):
    """The verdicts of houses with spaces beside hinges, and with rays that end at joints of walls, do not turn with them."""
    for name, angle, code in (("flat-0.910-module", 30, 1), ("flat-0.910-module", 210, 1), ("ube-techno-house", 30, 1)):
        path = pathlib.Path(place, "turned.json")
        path.write_text(json.dumps(turned(json.loads(pathlib.Path(house(name)).read_text()), angle)))

        def findings(file):
            return [((found["place"], found["rule"], found["verdict"]), found.get("has") or 0)
                    for found in ask("rules", file, code=code)["findings"]]

        straight, askew = findings(house(name)), findings(str(path))
        same = [one[0] == other[0] and abs(one[1] - other[1]) < 0.002 for one, other in zip(straight, askew)]
        check(len(straight) == len(askew) and all(same), f"{name} turned by {angle} degrees has the same findings")


def check_populations(place):
    """A population that fits nobody in the house is refused; a driver's draws do not depend on the order of the rows."""
    population = json.loads((pathlib.Path(house("x")).parent.parent / "assets/populations/manual-jp.json").read_text())
    electric, reverse = pathlib.Path(place, "electric.json"), pathlib.Path(place, "reverse.json")
    electric.write_text(json.dumps({**population, "profile": "electric-chair"}))
    expect(2, "run", house("straight-corridor"), "--drivers", "2", "--population", str(electric),
           says='varies the profile "electric-chair", which nobody in this house has')
    reverse.write_text(json.dumps({**population, "rows": population["rows"][::-1]}))
    first, second = (ask("run", house("straight-corridor"), "--drivers", "3", *more)["drivers"]["people"]
                     for more in ((), ("--population", str(reverse))))
    check(first == second, "the order of the rows changes no driver")


def check_loci(place):
    """The locus of a chair with other numbers tells them: speeds along the way tell the acceleration, too.

    In wider corners the way changes more with the numbers, and the acceleration is found 17 to 20 % too large."""
    truth = {"free_speed": 0.8, "acceleration": 0.3}
    settings = [word for name, value in truth.items() for word in ("--set", f"profile.manual-chair.{name}={value}")]
    corner = house("corner-1.00-1.00")
    expect(0, "run", corner, *settings, "--out", str(pathlib.Path(place, "truth")))
    ahead = 1.1 / 2 - 0.28  # m, of the body's middle from the axle
    table = pathlib.Path(place, "loci.csv")
    with pathlib.Path(place, "truth/trace.csv").open() as file, table.open("w", newline="") as loci:
        out = csv.writer(loci)
        out.writerow(["time [s]", "x [m]", "y [m]", "person"])
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            x, y, heading = (float(row[name]) for name in ("x [m]", "y [m]", "heading [rad]"))
            out.writerow([row["time [s]"], f"{x + ahead * math.cos(heading):.4f}", f"{y + ahead * math.sin(heading):.4f}", "p1"])
    names = ",".join(f"profile.manual-chair.{name}" for name in truth)
    answer = ask("fit", corner, "--observed", str(table), "--fit", names, "--out", place)
    for found in answer["parameters"]:
        true = truth[found["name"].rsplit(".", 1)[1]]
        print(f"{found['name']}: true {true}, best {found['best']:.4f}, 90 % {found['low']:.4f} to {found['high']:.4f}")
        check(found["told"] and found["low"] < true < found["high"], f"{found['name']} is told", found)
        check(abs(found["best"] / true - 1) < (0.06 if "speed" in found["name"] else 0.15), f"{found['name']} is found again", found)
    check(answer["sum"] < 0.1 * answer["sum_before"], "the fitted chair drives along the measured locus", answer["sum"])
    check({row["observable"].split("_")[0] for row in answer["rows"]} == {"offset", "speed"}, "offsets and speeds count")
    page = pathlib.Path(place, "fit.html").read_text()
    check("Residuals" in page and "What the data tell" in page, "the page of the fit is written")
    short = pathlib.Path(place, "short.csv")
    short.write_text("time,x,y,person\n0,1,1,p1\n1,1.2,1,p1\n")
    expect(2, "fit", corner, "--observed", str(short), says="short.csv:2:1: the locus of p1 is too short")
    nobody = pathlib.Path(place, "nobody.csv")
    nobody.write_text("time,x,y,person\n0,1,1,p9\n1,3,1,p9\n")
    expect(2, "fit", corner, "--observed", str(nobody), says='there is no person or route "p9"')


with tempfile.TemporaryDirectory() as folder:
    for test in (check_asked, check_measured, check_rules, check_rest, check_turned_rules, check_populations, check_loci):
        where = pathlib.Path(folder, test.__name__)
        where.mkdir()
        test(str(where))
end()
