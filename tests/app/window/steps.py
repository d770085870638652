#!/usr/bin/env python3
"""Tests the undo history (check 15) and the beam's diagram by keys (check 25), by real keys."""

import json
import re

import stage
from drawing import Plan
from stage import check

# 15: five edits; the third row of the history is the plan after three undos, and redo brings all back
plan = Plan("history", stage.house("closed-door"))
plan.until(lambda s: s.get("complete") and s["floor"])


def saved(name):
    path = plan.place / f"{name}.json"
    plan.save_as(path)
    return json.loads(path.read_text())


plan.keys("Tab")
while not (plan.state()["selected"] or "").startswith("person"):
    plan.keys("Tab")
for _ in range(5):
    plan.keys("shift+Left")
    plan.keys("shift+Up")
    plan.keys("e")
    if plan.state()["edits"] >= 5:
        break
edits = plan.state()["edits"]
check(edits >= 5, "15: there are five edits", edits)
while plan.state()["edits"] > 5:
    plan.keys("ctrl+z")
whole = saved("whole")
plan.keys("ctrl+z", "ctrl+z", "ctrl+z")
undone = saved("undone")
plan.keys("ctrl+y", "ctrl+y", "ctrl+y")
check(saved("redone") == whole != undone, "15: three redos bring all back")
plan.keys("ctrl+shift+h")
plan.until(lambda s: s["sheet"] == "history")
plan.keys("Home", "Down", "Down", "Return")
plan.until(lambda s: s["sheet"] == "none")
check(saved("row") == undone, "15: the third row of the history is the plan after three undos")
plan.keys("ctrl+y", "ctrl+y", "ctrl+y")
check(saved("again") == whole, "15: and redo brings all back")
plan.end()

# 25: the beam at 720 lines has four sliders and two plots; Left moves line, slider and headline together
beam = stage.Screen("beam", stage.beam("ibs"))
state = beam.until(lambda s: s.get("laboratory") == "beam" and not s["answer"]["stale"] and "orbit" in s["charts"])
check(state["frame"]["plots"].keys() == {"phase", "orbit"}, "25: two plots are open", state["frame"]["plots"])
box = state["frame"]["plots"]["orbit"]
while beam.state()["focus"] != "plot:orbit":
    beam.keys("F6")
before = beam.state()
beam.keys("shift+Left")
after = beam.until(lambda s: s["parameters"]["drive.frequency"] < before["parameters"]["drive.frequency"]
                   and not s["answer"]["stale"])
now = after["parameters"]["drive.frequency"]
told = re.search(r"([0-9.]+) Hz", after["answer"]["detail"] or "")
check(now < before["parameters"]["drive.frequency"] and abs(after["charts"]["orbit"]["cursor"] - now) < 1e-6,
      "25: Left moves the line and the number", (now, after["charts"]["orbit"]["cursor"]))
check(told and abs(float(told.group(1)) - now) < 0.06, "25: and the headline", (now, after["answer"]))
sliders = set()
for _ in range(40):
    beam.keys("Tab" if beam.state()["focus"] == "panel" else "F6")
    found = re.search(r"--set ([a-z_.]+)=", beam.state()["focus_help"] or "")
    if found:
        sliders.add(found.group(1))
    if len(sliders) > 4:
        break
check(len(sliders) == 4, "25: four sliders are open", sliders)
beam.end()
stage.end()
