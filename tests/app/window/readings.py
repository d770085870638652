#!/usr/bin/env python3
"""Tests what is read from the plots (checks 23 and 24 of the window's conventions) with a real mouse and real keys, at two
sizes: the read-out at the pointer is a row of the plot's table, a click on the orbit diagram sets the value below the
pointer, and axes are zoomed by keys."""

import csv
import re

import stage
from stage import Screen, check, differing


def number(text):
    return float(text.replace("\u2212", "-"))


def value_at(chart, x):
    """Returns the value of the x axis at a pixel, and that of a pixel's width, by the first and the last labelled tick."""
    ticks = [t for t in chart["texts"] if t["string"] in chart["x_ticks"]]
    foot = max(t["box"][1] for t in ticks)  # those of the y axis that have the same words stand higher
    places = sorted(((t["box"][0] + t["box"][2]) / 2, number(t["string"])) for t in ticks if t["box"][1] > foot - 2)
    (p, a), (q, b) = places[0], places[-1]
    return a + (x - p) * (b - a) / (q - p), (b - a) / (q - p)


def table(screen):
    """Lets F9 write the table of the plot that has the focus; returns its pairs of numbers."""
    folder = screen.place / "home" / "clearance"
    before = set(folder.glob("*.csv"))
    count = screen.state()["messages"]
    screen.keys("F9")
    screen.until(lambda s: s["messages"] > count and (s["message"] or "").startswith("Written"))
    new = sorted(set(folder.glob("*.csv")) - before)
    check(len(new) == 1, "F9 writes the table of the plot with the focus", new)
    with open(new[0], newline="") as file:
        rows = list(csv.reader(file))
    check(all("[" in name for name in rows[0]), "24: its header has the units", rows[0])
    axis = [title for title in ("time [s]", "displacement [mm]", "shaker (excitation frequency) [Hz]") if title in rows[0][-2]][0]
    columns = [i for i, title in enumerate(rows[0][:-1]) if title.endswith(axis)]  # a band has two columns beside its x
    return [(row[i], row[i + 1]) for row in rows[1:] for i in columns if row[i] and row[i + 1]]


def is_row(told, pairs):
    """True if both numbers that are told are those of a row, rounded to the digits that are told."""
    digits = [len(text.partition(".")[2]) for text in told]
    return any(all(abs(float(v) - number(t)) <= 0.5000001 * 10 ** -d for v, t, d in zip(pair, told, digits)) for pair in pairs)


def read(screen, plot, parts):
    """Points at places of a plot; returns the numbers of the read-outs and their texts."""
    found = []
    pane = screen.state()["frame"]["plots"][plot]
    for across, up in parts:
        screen.point_to(pane[0] + across * (pane[2] - pane[0]), pane[1] + up * (pane[3] - pane[1]))
        for text in screen.texts():
            told = READ_OUT.fullmatch(text["string"])
            box = text["box"]  # the clock of a machine below the plot reads alike
            if told and pane[0] <= box[0] and box[2] <= pane[2] + 1 and pane[1] <= box[1] and box[3] <= pane[3] + 1:
                found.append((told.groups(), text["string"]))
    return found


READ_OUT = re.compile(r"(?:\D*? )?(\u2212?[0-9.]+)(?: \S+)?, (?:\D*? )?(\u2212?[0-9.]+)(?: \S+)?")
PLACES = [(a / 12, b / 12) for a in range(2, 12) for b in range(2, 10)]
for (width, height), (name, path, plots) in [(size, kind) for size in ((1280, 720), (1920, 1080)) for kind in (
        ("house", stage.house("flat-0.910-widened"), ("speed",)), ("beam", stage.beam("ibs"), ("phase", "orbit")))]:
    what = f"{name}, {width} x {height}"
    screen = Screen(f"{name}-{height}", path, width=width, height=height, minutes=20, texts=True)
    state = screen.until(lambda s: s["answer"]["title"] and not s["answer"]["stale"] and (name == "beam" or s["complete"]))
    if name == "beam":
        screen.until(lambda s: s["end"] > 0.1)  # the phase plane has some thirty cycles
    if state["playing"]:
        screen.keys("space")
    screen.until(lambda s: not s["answer"]["doing"], patience=4 * stage.PATIENCE)  # the diagram has all its values
    if name == "house":
        screen.keys("End")
        if not screen.state()["frame"]["plots"]:
            screen.keys("shift+p")
    for plot in plots:
        state = screen.until(lambda s: plot in s["frame"]["plots"])
        pane = state["frame"]["plots"][plot]
        for _ in range(12):
            if screen.state()["focus"] == f"plot:{plot}":
                break
            screen.keys("F6")
        told = read(screen, plot, PLACES)
        pairs = table(screen)
        wrong = [text for numbers, text in told if not is_row(numbers, pairs)]
        check(len(told) >= 5 and not wrong, f"23: {what}, {plot}: what is read at the pointer is a row of the table",
              (len(told), wrong, pairs[:2]))
    if name == "beam":
        state = screen.state()
        pane, chart = state["frame"]["plots"]["orbit"], state["charts"]["orbit"]
        for part in (0.4, 0.7):
            x = round(pane[0] + part * (pane[2] - pane[0]))
            screen.click(x, (pane[1] + pane[3]) / 2)
            meant, pixel = value_at(chart, x)
            now = screen.until(lambda s: s["charts"]["orbit"]["cursor"] == s["parameters"]["drive.frequency"])
            check(abs(now["parameters"]["drive.frequency"] - meant) <= 1.01 * abs(pixel),
                  f"23: {what}: a click sets the value below the pointer", (now["parameters"]["drive.frequency"], meant, pixel))
        screen.point_to(width - 2, height - 2)
        first = screen.state()["charts"]["orbit"]["x"]
        screen.keys("z", *["Right"] * 6, "Return", *["Right"] * 6, *["Up"] * 6, "Return")
        zoomed = screen.state()["charts"]["orbit"]
        check(zoomed["views"] == 1 and first[0] <= zoomed["x"][0] < zoomed["x"][1] < first[1], f"23: {what}: Z zooms by keys", zoomed["x"])
        begun = screen.state()["end"]
        screen.keys("alt+k")
        screen.until(lambda s: s["playing"])
        screen.until(lambda s: s["end"] > begun + 0.05)
        check(screen.state()["charts"]["orbit"]["x"] == zoomed["x"], f"23: {what}: chosen axes stay while it runs")
        screen.keys("BackSpace")
        check(screen.state()["charts"]["orbit"]["x"] == first, f"23: {what}: Backspace goes back", screen.state()["charts"]["orbit"]["x"])
        screen.keys("z", *["Right"] * 6, "Return", *["Right"] * 6, *["Up"] * 6, "Return", "z", *["Right"] * 3, "Return",
                    *["Right"] * 3, *["Up"] * 3, "Return")
        check(screen.state()["charts"]["orbit"]["views"] == 2, f"23: {what}: twice")
        screen.keys("Home")
        check(screen.state()["charts"]["orbit"]["x"] == first, f"23: {what}: Home fits", screen.state()["charts"]["orbit"]["x"])
        screen.keys("alt+k")
        screen.until(lambda s: not s["playing"])
        phase = screen.state()["frame"]["plots"]["phase"]
        shots = [screen.shot("run")]
        for key in ("k", "x"):
            screen.keys(key)
            screen.point_to(width - 2, height - 2)
            shots.append(screen.shot(key))
            check(differing(*shots[-2:], phase) > 50, f"23: {what}: {key.upper()} changes the phase plane")
    screen.end()
stage.end()
