#!/usr/bin/env python3
"""Tests a crowd of 240 people in two rooms and a hall: the panel counts the people of the same moment as the picture, the
jams are named by their places and shown when they are worst, and the last person out is found."""

import json
import re

import stage
from stage import check

WALLS = [("outer", [[0, 0], [20, 0], [20, 14], [0, 14], [0, 0]]), ("middle", [[0, 6], [20, 6]]), ("between", [[10, 0], [10, 6]])]
house = {
    "format": "clearance-house", "version": 1, "name": "hall with two rooms", "note": "Assumed.",
    "walls": [{"id": name, "points": points, "thickness": 0.2} for name, points in WALLS],
    "doors": [{"id": "d1", "wall": "middle", "at": 5, "width": 1}, {"id": "d2", "wall": "middle", "at": 15, "width": 1},
              {"id": "d3", "wall": "outer", "segment": 3, "at": 4, "width": 1.6},
              {"id": "d4", "wall": "outer", "segment": 1, "at": 10, "width": 1.6}],
    "rooms": [{"id": "studio", "name": "studio", "outline": [[0, 0], [10, 0], [10, 6], [0, 6]]},
              {"id": "workshop", "name": "workshop", "outline": [[10, 0], [20, 0], [20, 6], [10, 6]]},
              {"id": "hall", "name": "hall", "outline": [[0, 6], [20, 6], [20, 14], [0, 14]]}],
    "exits": [{"id": "west", "from": [-0.1, 9.2], "to": [-0.1, 10.8]}, {"id": "east", "from": [20.1, 9.2], "to": [20.1, 10.8]}],
    "crowds": [{"id": "a", "profile": "adult", "count": 110, "area": [[1, 1], [9, 1], [9, 5], [1, 5]]},
               {"id": "b", "profile": "adult", "count": 110, "area": [[11, 1], [19, 1], [19, 5], [11, 5]]},
               {"id": "c", "profile": "elderly", "count": 20, "area": [[3, 8], [17, 8], [17, 12], [3, 12]]}],
    "run": {"sample": 0.2, "until": 300},
}
FILE = stage.folder / "hall.json"
FILE.write_text(json.dumps(house))
TIMES = (9.5, 9.9, 14, 14.3, 60)
PLACE, LAST = "1203 62", "1072 62"  # the buttons of the answer
seen = stage.act("crowd", "pause", "until complete", *[f"seek {t}\nwait 1\nstate STATE" for t in TIMES], "seek 14", "play",
                 *["wait 1\nstate STATE"] * 6, "pause", "wait 1", "state STATE", "picture FOLDER/picture.png",
                 f"click {PLACE}", "wait 2", "state STATE", f"click {LAST}", "wait 2", "state STATE",
                 'select "door d1"', "seek 40", "wait 2", "state STATE", 'select "exit west"', "wait 2",
                 "state STATE",
                 arguments=(FILE, "--size", "1280x720"))
seen, shown = seen[:-4], seen[-4:]


def signs(state):
    """Returns the names, counts and boxes of the exits' signs."""
    found = [(re.fullmatch(r"(?:EXIT )?(\w+):\s*(\d+)", t["string"]), t["box"]) for t in state["text_in_view"]]
    return {sign[1]: (int(sign[2]), box) for sign, box in found if sign}


def counts(state):
    """Returns the counts of the rows of the exits, and of all."""
    now = {row[0].removeprefix("exit "): int(row[1].split(" of ")[0]) for row in state["rows"] if " of " in row[1]}
    return now.pop("out"), now


wrong = [(s["time"], counts(s), signs(s)) for s in seen
         if counts(s)[1] != {name: count for name, (count, _) in signs(s).items()} or counts(s)[0] != sum(counts(s)[1].values())]
check(len(seen) == len(TIMES) + 7 and not wrong, "the panel counts the people of the picture's moment, also while it plays", wrong)
out = [counts(s)[0] for s in seen[:len(TIMES)]]
check(out == sorted(out) and out[0] < out[-1], "and they grow", out)
boxes = {name: {tuple(signs(s)[name][1]) for s in seen} for name in ("west", "east")}
check(all(len(box) == 1 for box in boxes.values()), "the signs of the exits stay where they are", boxes)

# jams are called by the doors they are at, and shown when they are worst
rows = [row[0] for row in seen[0]["rows"]]
jams = rows[rows.index("Jams: time lost by all") + 1:rows.index("People: out/all, last")]
check(jams == ["studio door", "workshop door"], "jams are named by their places", jams)
check("tight place 1" in (shown[0]["selected"] or "") and 5 < shown[0]["time"] < 60, "Show place goes to the worst time of the jam",
      (shown[0]["selected"], shown[0]["time"]))
title = float(re.search(r"out in ([\d.]+) s", shown[1]["answer"]["title"])[1])
check((shown[1]["selected"] or "").startswith("person") and abs(title - 2 - shown[1]["time"]) < 0.1 and shown[1]["zoom"] > 1,
      "Show last selects the last person out, 2 s before", (shown[1]["selected"], shown[1]["time"], shown[1]["zoom"]))

# how many people a second pass: a door, and the exit to which most of them go
flows = [float(dict((row[0], row[1]) for row in s["rows"])["through now"].removesuffix(" people/s")) for s in shown[2:]]
check(all(0.5 < flow < 3 for flow in flows) and abs(flows[0] - flows[1]) < 0.6, "a door and an exit tell their flow", flows)

# the curve after the time is pale
PALE, DARK = (0xA9, 0xC5, 0xD9), (0x00, 0x68, 0xA8)
plot = seen[-1]["frame"]["plots"]["out"]
found = {colour: count for count, colour in stage.colours(stage.folder / "crowd" / "picture.png", plot)}
check(found.get(PALE, 0) > found.get(DARK, 0) > 20, "people out: the rest of the curve is pale", (found.get(PALE), found.get(DARK)))

# of a crowd nobody who has left is picked: a click on the exit selects the exit
few = stage.folder / "few.json"
few.write_text(json.dumps({
    "format": "clearance-house", "version": 1, "name": "few",
    "walls": [{"id": "w1", "points": [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]}],
    "doors": [{"id": "d1", "wall": "w1", "segment": 1, "at": 2, "width": 1, "kind": "opening"}],
    "exits": [{"id": "e1", "from": [6.8, 1.5], "to": [6.8, 2.5]}],
    "people": [{"id": "first", "profile": "adult", "at": [5, 2]}] + [
        {"id": f"f{i}", "profile": "adult", "at": [0.6 + 0.6 * i, 1], "delay": 30} for i in range(6)]}))
found = stage.act("few", "until complete", "pause", "seek 2.2", "wait 2", "at 6.8 2", "press", "release", "wait 2", "state STATE",
                  arguments=[few])
check(found[0]["selected"] == "exit e1", "a click on the exit selects it, not who has left by it", found[0]["selected"])

stage.end()
