#!/usr/bin/env python3
"""Tests the shopping centre near 45 s (check 27) with a real mouse and real keys, at two sizes: how many are out is the
same in the panel, at the exits in the picture, in the curve that `clearance run` writes and in its answer; the key of the
colours has five numbers; chairs lie on top."""

import csv
import json
import re
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
times = sorted(person["time"] for person in run["people"] if person.get("completed", True) and person.get("time"))

screen = stage.Screen("centre", CENTRE, width=1920, height=1080, minutes=30)
screen.until(lambda s: s["answer"]["title"] == "On the way", patience=4 * stage.PATIENCE)
screen.keys("bracketright")  # a busy machine's pictures come late, and its clock is behind
state = screen.until(lambda s: s["complete"] and not s["answer"]["stale"], patience=4 * stage.PATIENCE)


# while it is computed and played, the counts of panel and picture are those of the clock, not of all that is computed
def counts(state):
    """Returns how many are out by the row, by the exits' rows, by the kinds of people, and by the exits' signs."""
    out = {row[0]: int(row[1].split(" ")[0]) for row in state["rows"] if row[0] == "out" or row[0].startswith("exit ")}
    kinds = [row[1] for row in state["rows"] if re.fullmatch(r"\d+/\d+", row[1])]
    signs = [re.fullmatch(r"(?:EXIT )?(\w+):\s*(\d+)", t["string"]) for t in state["text_in_view"]]
    return (out.pop("out", 0), sum(out.values()), sum(int(kind.split("/")[0]) for kind in kinds),
            sum(int(sign[2]) for sign in signs if sign))


growing = [s for s in stage.states(screen.log) if s["time"] > 2 and not s["complete"] and s["answer"]["title"] == "On the way"]
wrong = [(s["time"], counts(s)) for s in growing if max(counts(s)) > min(counts(s))]
check(growing and not wrong, "while it is computed, the counts are those of the clock", (len(growing), wrong[:3]))
if state["playing"]:
    screen.keys("space")
for width, height in ((1920, 1080), (1280, 720)):
    size = f"{width} x {height}"
    screen.tool("windowsize", screen.window, width, height)
    screen.until(lambda s: (s["width"], s["height"]) == (width, height))
    x, y, right, foot = screen.state()["frame"]["timeline"]
    places, times_there = [x + part * (right - x) for part in (0.6, 0.7)], []
    for place in places:  # the line of time goes by even steps: two clicks on it tell where a third one must be
        screen.click(place, (y + foot) / 2)
        times_there.append(screen.state()["time"])
    pace = (times_there[1] - times_there[0]) / (places[1] - places[0])
    screen.click(places[0] + (AT - times_there[0]) / pace, (y + foot) / 2)
    screen.point_to(width - 2, height - 2)
    state, shot = screen.state(), screen.shot(f"shot-{height}")
    by_curve = max(count for time, count in curve if time <= state["time"] + 1e-9)
    now = {row[0]: [int(word) for word in row[1].split(" of ")] for row in state["rows"] if " of " in row[1]}
    everybody = now.pop("out")
    check(abs(state["time"] - AT) < 0.01 * run["time"] and everybody[0] == by_curve > 0,
          f"27: {size}: panel and curve have the same number out", (state["time"], everybody, by_curve))
    check(sum(n for n, _ in now.values()) == everybody[0] and sum(n for _, n in now.values()) == everybody[1],
          f"27: {size}: the exits' numbers add up", (now, everybody))
    signs = [re.fullmatch(r"(?:EXIT )?(\w+):\s*(\d+)", t["string"]) for t in state["text_in_view"]]
    drawn = {f"exit {sign[1]}": int(sign[2]) for sign in signs if sign}
    check(drawn == {name: count for name, (count, _) in now.items()}, f"27: {size}: and are those of the picture, all of them",
          (drawn, now))
    most = times[int(-(-0.95 * len(times) // 1)) - 1]
    check(len(times) == everybody[1] and len(state["ticks"]) == 3 and abs(state["ticks"][1] - most) < 0.06,
          f"27: {size}: 95 % is marked where the run says", (state["ticks"], most))
    key = {t["string"] for t in state["text_in_view"] if t["kind"] != "disc"}
    check(key >= {"0.5", "1", "1.5", "2", "3+"}, f"27: {size}: the key has five numbers", key)
    check({"out", "flow"} <= state["frame"]["plots"].keys(), f"27: {size}: both curves are open", state["frame"]["plots"])

    # chairs lie on top: their blue is there in full, over colours and dots
    view = state["frame"]["view"]
    blue = sum(count for count, colour in stage.colours(shot, view) if colour == (0x00, 0x68, 0xA8))
    check(blue > 200, f"27: {size}: chairs lie on top of the crowd, in their full colour", blue)

# a jam has one number, in its row and beside its details, and is shown with what is around it
def amount(duration):
    minutes, _, seconds = duration.removesuffix(" s").rpartition(":")
    return 60 * float(minutes or 0) + float(seconds)


row_at = {row[0]: row[1] for row in state["rows"]}
names = [row[0] for row in state["rows"]]
jams = names[names.index("Jams: time lost by all") + 1:names.index("more jams")]
check(len(jams) == 3 and [amount(row_at[jam]) for jam in jams] == sorted((amount(row_at[jam]) for jam in jams), reverse=True),
      "jams are ranked by the number that is shown", [(jam, row_at[jam]) for jam in jams])
x, y, right, foot = state["frame"]["answer"]
screen.click(right - 80, (y + foot) / 2)
state, shown = screen.state(), {}
for row in state["rows"][1:]:
    if not row[1]:
        break
    shown[row[0]] = row[1]
check(state["rows"][0][0] == f"Jam 1: {jams[0]}" and shown.get("time lost by all") == row_at[jams[0]] and "score" not in shown,
      "the details of a jam have the number of its row", (state["rows"][0], shown, row_at[jams[0]]))
check(4 < state["zoom"] < 16, "a jam is shown nearer, with some metres around it", state["zoom"])
screen.end()
stage.end()
