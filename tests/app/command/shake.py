#!/usr/bin/env python3
"""Tests earthquakes (`study --shake`) and smallest changes (`check --suggest`): answers, files, wrong use."""

import copy
import json
import os
import pathlib
import tempfile

from program import beam, check, end, expect, house

# A corridor, 1.2 m clear; one shelf at its wall blocks it when it falls, another one cannot.
CORRIDOR = {
    "format": "clearance-house", "version": 1, "name": "corridor",
    "walls": [{"id": "south", "points": [[0, -0.05], [6, -0.05]], "thickness": 0.1},
              {"id": "north", "points": [[0, 1.25], [6, 1.25]], "thickness": 0.1},
              {"id": "west", "points": [[-0.05, -0.05], [-0.05, 1.25]], "thickness": 0.1},
              {"id": "middle", "points": [[4, 0], [4, 1.2]], "thickness": 0.1}],
    "doors": [{"id": "d1", "wall": "middle", "at": 0.6, "width": 0.9}],
    "furniture": [{"id": "shelf", "name": "shelf", "centre": [3, 0.15], "size": [0.5, 0.3], "height": 0.9,
                   "topples": "back", "probability": 0.4},
                  {"id": "box", "centre": [0.2, 1.1], "size": [0.2, 0.2]}],
    "exits": [{"id": "e1", "from": [5, 0], "to": [5, 1.2]}],
    "people": [{"id": "p1", "profile": "manual-chair", "at": [1, 0.6]}],
}


SHAKES = 10


def draft(folder, **settings):
    """Writes the corridor with settings like shelf__probability=1 or d1__width=0.6."""
    plan = copy.deepcopy(CORRIDOR)
    for path, value in settings.items():
        thing, key = path.split("__")
        for kind in ("doors", "furniture", "people"):
            for element in plan[kind]:
                if element["id"] == thing:
                    element[key] = value
    path = os.path.join(folder, "corridor.json")
    pathlib.Path(path).write_text(json.dumps(plan))
    return path


def shakes(code, path, *options):
    return json.loads(expect(code, "study", path, "--shake", str(SHAKES), "--json", *options).stdout)


def check_shares(folder):
    never = shakes(0, draft(folder, shelf__probability=0))
    check(never["kind"] == "shake" and never["everybody_out"]["shakes"] == never["done"] == SHAKES, "nothing falls", never)
    check(never["time"]["least"] == never["time"]["greatest"] == never["without_shake"]["time"], "all alike")
    always = shakes(1, draft(folder, shelf__probability=1))
    check(always["everybody_out"]["share"] == 0 and always["time"]["q50"] is None, "it always falls", always)
    check(always["furniture"][0]["blocks"]["shakes"] == SHAKES and always["furniture"][0]["id"] == "shelf", "it blocks")
    path = draft(folder)
    some = shakes(1, path, "--jobs", "1")
    share, piece = some["everybody_out"], some["furniture"][0]
    check(0 < share["share"] < 1 and share["q025"] < share["share"] < share["q975"], "sometimes", share)
    check(piece["toppled"] == piece["blocks"]["shakes"] == SHAKES - share["shakes"] == piece["toppled_and_not_all_out"],
          "what falls is what blocks", piece)
    check(some["people"][0]["out"] == share and some["people"][0]["id"] == "p1", "each person", some["people"])
    check(shakes(1, path, "--jobs", "3") == some, "--jobs changes nothing")
    check(shakes(1, path, "--seed", "7")["digest"] != some["digest"], "--seed changes it")
    worst = some["worst"]
    check(worst["settings"] == "--set furniture.shelf.toppled=true", "the worst shake is named", worst)
    expect(1, "run", path, *worst["settings"].split())
    caught = shakes(1, draft(folder, shelf__probability=1, p1__at=[3, 0.6]))
    check(caught["caught"]["shakes"] == SHAKES and caught["furniture"][0]["blocks"]["shakes"] == SHAKES, "caught", caught)


def check_words(folder):
    words = expect(1, "study", draft(folder), "--shake", str(SHAKES)).stdout
    check(" is out in " in words and "95 % confidence" in words, "answer in words", words)
    check("shelf" in words and "stops people in" in words and "without a shake" in words, "tables in words", words)
    words = expect(0, "study", house("bedroom-after-earthquake"), "--shake", "2").stdout
    check("Nothing in this house can fall" in words, "what lies cannot fall", words)


def check_files(folder):
    out, path = os.path.join(folder, "out"), draft(folder)
    first = expect(1, "study", path, "--shake", str(SHAKES), "--report", "--out", out)
    names = {"plan.png", "plan.svg", "plan.pdf", "plot-times.png", "plot-times.csv", "report.html", "report.pdf",
             "summary.json", "study.csv", "study.sqlite"}
    check(names <= set(os.listdir(out)), "files", sorted(os.listdir(out)))
    page = pathlib.Path(out, "report.html").read_text()
    check("Earthquake report: corridor" in page and "What stops people" in page and "0.4" in page, "report")
    again = expect(1, "study", path, "--shake", str(SHAKES), "--out", out)
    check(f"all {SHAKES} runs are read back" in again.stderr, "goes on", again.stderr)
    check(first.stdout == again.stdout, "the same answer from the file")


def check_wrong_use(folder):
    path = draft(folder)
    expect(2, "study", path, "--shake", "0", says="--shake takes N")
    expect(2, "study", path, "--shake", "3", "--runs", "3", says="--runs has no effect with --shake")
    expect(2, "study", path, "--shake", "3", "--types", "door.d1.width", says="--shake has no effect with --types")
    expect(2, "study", path, "--shake", "3", "--measured", path, says="--measured has no effect with --shake")
    expect(2, "study", path, "--runs", "3", "--report", says="--report needs --out DIR")
    expect(2, "study", path, "--shake", "3", "--report", says="--report needs --out DIR")
    expect(2, "study", beam("ibs"), "--shake", "3", says="--shake is for houses")


def suggestions(code, path, *options):
    return json.loads(expect(code, "check", path, "--suggest", "--json", *options).stdout)


def check_suggestions(folder):
    path = draft(folder, d1__width=0.6)
    answer = suggestions(1, path)
    found = answer["suggestions"]
    check(len(found) == 1 and len(found[0]["settings"]) == 1, "one change", found)
    name, width = found[0]["settings"][0].split("=")
    check(name == "door.d1.width" and 0.63 < float(width) < 0.68, "a door is widened", found)
    check(found[0]["words"] == f"Widen door d1 from 0.60 m to {width} m", "words", found)
    check(abs(found[0]["size"] - (float(width) - 0.6)) < 1e-9, "size", found)
    expect(1, "check", path, "--set", f"{name}={float(width) - 0.01:.2f}")
    again = json.loads(expect(0, "run", path, "--set", found[0]["settings"][0], "--json").stdout)
    check(again["time"] == found[0]["time"], "its time is that of a run", found)
    expect(0, "check", path, "--set", found[0]["settings"][0])
    words = expect(1, "check", path, "--suggest").stdout
    paid = suggestions(1, path, "--rules", "jp-care-insurance")["suggestions"][0]["paid"]["jp-care-insurance"]
    check("(read second-hand)" in paid, "who pays", paid)
    check(paid in expect(1, "check", path, "--suggest", "--rules", "jp-care-insurance").stdout, "who pays, in words")
    expect(2, "check", path, "--rules", "jp-care-insurance", says="--suggest, which must be given")
    expect(2, "check", path, "--suggest", "--rules", "ada-2010", says="ada-2010 does not say what is paid for")
    check("\nSmallest changes that let all people out\n" in words and "\n1     Widen door d1 " in words, "words of a suggestion", words)


def check_none_needed(folder):
    path = draft(folder)
    check(suggestions(0, path)["suggestions"] == [], "nothing is needed")
    check("nothing needs to be changed" in expect(0, "check", path, "--suggest").stdout, "nothing is needed, in words")
    check("suggestions" not in json.loads(expect(0, "check", path, "--json").stdout), "only when asked")
    path = house("corner-0.78-0.78")
    answer = suggestions(1, path)
    check(answer["suggestions"] == [] and "Walls are not moved" in answer["suggestion_notes"][0], "walls stay", answer)
    check("No change was found" in expect(1, "check", path, "--suggest").stdout, "none found, in words")


def check_all_are_enough(folder):
    """A shelf blocks the path and a door is too narrow: both must be changed."""
    path = draft(folder, d1__width=0.6, shelf__toppled=True)
    found = suggestions(1, path)["suggestions"]
    check(found and all(len(s["settings"]) == 2 for s in found), "two together", found)
    for suggestion in found:
        changed = [word for setting in suggestion["settings"] for word in ("--set", setting)]
        expect(0, "check", path, *changed)
        expect(0, "run", path, *changed)


with tempfile.TemporaryDirectory() as folder:
    check_shares(folder)
    check_words(folder)
    check_files(folder)
    check_wrong_use(folder)
    check_suggestions(folder)
    check_none_needed(folder)
    check_all_are_enough(folder)
end()
