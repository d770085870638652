#!/usr/bin/env python3
"""Tests the export sheet (check 24 of the window's conventions) with real keys: twice the same bytes, headers with units,
paths that are said, and films whose pictures lie exactly one interval apart."""

import csv
import fractions
import json
import math
import pathlib
import re
import subprocess

import stage
from stage import Screen, check

ROWS = {"Data": 2, "Plots": 3, "Report": 4, "Frames": 5, "Film": 7}  # Tabs to each row of the sheet
RATE = 30  # pictures per second of a run


def export(screen, row):
    """Lets the sheet write something; returns its file or folder."""
    count = screen.state()["messages"]
    screen.keys("ctrl+e")
    screen.until(lambda s: s["sheet"] == "export")
    screen.keys(*["Tab"] * ROWS[row], "Return")
    begun = screen.until(lambda s: s["messages"] > count)["message"]  # what is soon done is known as written only
    done = screen.until(lambda s: not s["export"])["message"]
    place = pathlib.Path(re.sub(r"^(Writing |Written: )| \(\d+ files?\)$", "", begun))
    check(done.startswith("Written") and str(place) in done, f"24: {row}: its path is shown", done)
    return place


def files(place):
    """Returns the contents of a file, or of all files of a folder; of reports, which hold the folder's name, the words."""
    if place.is_file():
        return {place.suffix: place.read_bytes()}
    made = {str(path.relative_to(place)): path.read_bytes() for path in sorted(place.rglob("*")) if path.is_file()}
    if "report.pdf" in made:
        words = subprocess.run(["pdftotext", place / "report.pdf", "-"], capture_output=True, timeout=600).stdout
        words = re.sub(rb"[\s-]+", b"", words)  # the folder's name moves the ends of lines, and they lose their hyphens
        made["report.pdf"] = words.replace(place.name.replace("-", "").encode(), b"")
    return {name: re.sub(place.name.encode() + rb"\b(-2)?", b"", content) if name.startswith("report") else content
            for name, content in made.items()}


for name, path in (("house", stage.house("straight-corridor")), ("beam", stage.beam("ibs"))):
    screen = Screen(name, path, minutes=20)
    screen.until(lambda s: s["answer"]["title"] and not s["answer"]["stale"] and (name == "beam" or s["complete"]))
    if screen.state()["playing"]:
        screen.keys("space")
    end = screen.state()["end"]
    for row in ROWS if name == "house" else ("Data", "Plots"):
        places = [export(screen, row) for _ in range(1 if row == "Frames" else 2)]
        made = [files(place) for place in places]
        check(made[0] and places[0] != places[-1] or row == "Frames", f"24: {name}, {row}: nothing is overwritten", places)
        other = [file for file in made[0] if made[0][file] != made[-1].get(file)]
        check(not other and made[0].keys() == made[-1].keys(), f"24: {name}, {row}: twice the same bytes", other)
        for file, content in made[0].items():
            if file.endswith(".csv"):
                header = next(csv.reader(content.decode().splitlines()))
                check(all(re.search(r"\[[^]]+\]", cell) for cell in header), f"24: {name}, {row}, {file}: its header has units", header)
        if row == "Film":
            film = places[0]
        if row == "Frames":
            frames = places[0]
    if name == "house":
        told = subprocess.run(["ffprobe", "-v", "error", "-select_streams", "v", "-show_entries",
                               "stream=time_base:frame=pts", "-of", "json", str(film)], capture_output=True, text=True, timeout=600)
        probe = json.loads(told.stdout)
        base = fractions.Fraction(probe["streams"][0]["time_base"])
        times = [base * int(frame["pts"]) for frame in probe["frames"]]
        apart = {b - a for a, b in zip(times, times[1:])}
        check(apart == {fractions.Fraction(1, RATE)}, "24: the pictures of a film lie exactly 1/30 s apart", sorted(apart)[:5])
        check(len(times) == len(list((frames / "frames").iterdir())) == math.ceil(end * RATE) + 1,
              "24: and there is one for each of a run's frames", (len(times), end))
    screen.end()

# the frames of a house whose edits no setting can say tell of them by the name of the house that is written beside them
stage.act("edited", "until answered", "pause", "select bed", "key Delete", "wait 10", "key Shift+F9", "wait 10",
          arguments=[stage.house("flat-0.910-module")])
named = [json.loads(p.read_text())["name"] for p in (stage.folder / "edited" / "home" / "clearance").glob("*.house.json")]
check(named == ["flat on the 0.910 m module (edited)"], "the frames of an edited house are of a house called edited", named)
stage.end()
