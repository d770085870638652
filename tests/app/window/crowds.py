#!/usr/bin/env python3
"""Tests the shopping centre at 45 s (check 27): how many are out is the same in the panel, at the exits in the picture, in
the curve that `clearance run` writes and in its answer; the key of the colours has five numbers; chairs lie on top."""

import csv
import json
import subprocess

import stage
from stage import check

CENTRE, AT = stage.house("shopping-centre"), 45.0
out = stage.folder / "out"
done = subprocess.run([stage.program, "run", CENTRE, "--plots", "out,flow", "--json", "--out", out], capture_output=True,
                      text=True, timeout=10 * stage.PATIENCE, env=stage.environment(stage.folder / "home"))
run = json.loads(done.stdout)
with open(out / "plot-out.csv", newline="") as file:
    rows = [row for row in csv.reader(file)][1:]
curve = [(float(row[0]), float(row[1])) for row in rows if row[0] and row[1]]
by_curve = max(count for time, count in curve if time <= AT + 1e-9)

state = stage.act("centre", "until answered", "pause", f"seek {AT}", "wait 10", "state STATE", "picture FOLDER/shot.png",
                  arguments=[CENTRE, "--size", "1280x720"])[0]
now = {row[0]: [int(word) for word in row[1].split(" of ")] for row in state["rows"] if " of " in row[1]}
everybody = now.pop("out")
check(abs(state["time"] - AT) < 0.05 and everybody[0] == by_curve > 0, "27: panel and curve have the same number out",
      (state["time"], everybody, by_curve))
check(sum(n for n, _ in now.values()) == everybody[0] and sum(n for _, n in now.values()) == everybody[1],
      "27: the exits' numbers add up", (now, everybody))
drawn = {t["string"].split(":")[0]: int(t["string"].split(": ")[1]) for t in state["text_in_view"]
         if t["string"].startswith("EXIT") and ":" in t["string"]}
check(drawn and all(now[name.replace("EXIT", "exit")][0] == count for name, count in drawn.items()),
      "27: and are those of the picture", (drawn, now))
times = sorted(person["time"] for person in run["people"] if person.get("completed", True) and person.get("time"))
if len(times) == everybody[1]:
    most = times[int(-(-0.95 * len(times) // 1)) - 1]
    check(len(state["ticks"]) == 3 and abs(state["ticks"][1] - most) < 0.06, "27: 95 % is marked where the run says",
          (state["ticks"], most))
key = [t for t in state["text_in_view"] if t["string"] in ("0.5", "1", "1.5", "2", "3+") and t["kind"] != "disc"]
check({t["string"] for t in key} >= {"0.5", "1", "1.5", "2", "3+"}, "27: the key has five numbers",
      [t["string"] for t in state["text_in_view"]])
check(state["frame"]["plots"].keys() == {"out", "flow"}, "27: both curves are open", state["frame"]["plots"])

# chairs lie on top: their blue is there in full, over colours and dots
view = state["frame"]["view"]
blue = sum(count for count, colour in stage.colours(stage.folder / "centre" / "shot.png", view) if colour == (0x00, 0x68, 0xA8))
check(blue > 200, "27: chairs lie on top of the crowd, in their full colour", blue)
stage.end()
