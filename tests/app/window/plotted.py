#!/usr/bin/env python3
"""Tests the words of the plots in the window (check 8): at three sizes no text of any plot overlaps another or leaves its
pane, and each tick has its number."""

import collections
import itertools
import json
import subprocess

import stage
from stage import check

# a hall with more than 30 people is a crowd, which has plots of its own
HALL = stage.folder / "hall.json"
HALL.write_text(json.dumps({
    "format": "clearance-house", "version": 1, "name": "hall",
    "walls": [{"id": "w1", "points": [[8, 2], [8, 0], [0, 0], [0, 8], [8, 8], [8, 4]], "thickness": 0.12}],
    "exits": [{"id": "e1", "from": [8, 2], "to": [8, 4]}],
    "people": [{"id": f"n{i}", "profile": "adult", "at": [2 + i % 8 * 0.7, 1.5 + i // 8 * 0.9], "heading": 0}
               for i in range(40)]}))
SIZES = ("1024x600", "1024x768", "1280x720", "1920x1080")
FILES = {"house": (stage.house("flat-0.910-widened"), ("speed", "clearance", "force", "pressed", "phase")),
         "crowd": (str(HALL), ("out", "flow")),
         "beam": (stage.beam("ibs"), ()),
         "crank": (stage.CRANK, ())}


EMPTY = 0.17  # of a line: a tenth of the letter size at the edge of either box


def overlap(a, b):
    """Texts keep apart by their glyphs, as in tests of the layout: boxes are as high as lines, with empty edges."""
    empty = EMPTY * (a[3] - a[1])
    return a[0] < b[2] - 0.5 and b[0] < a[2] - 0.5 and a[1] < b[3] - empty and b[1] < a[3] - empty


seen = collections.Counter()
def is_unit(chart, text):
    """True if a text is the unit of the x axis, where the title has no room: "over mm", or between the last labels."""
    return text in (chart["x_unit"], f'over {chart["x_unit"]}')


for name, (path, expected) in FILES.items():
    for size in SIZES:
        brief = stage.PERIODIC if name == "crank" and size != SIZES[0] else ()
        state = stage.act(f"{name}-{size}", "until answered", "key Shift+P", "wait 3", "state STATE", "key Shift+P",
                          "wait 8", "state STATE", arguments=[path, *brief, "--size", size])
        state = max(state, key=lambda s: len(s["frame"]["plots"]))
        shown = set(state["frame"]["plots"])
        check(not expected or shown & set(expected), f"8: {name}, {size}: its own plots are shown", shown)
        check(state["charts"] and state["frame"]["plots"], f"8: {name}, {size}: there are plots", state["frame"])
        for plot, chart in state["charts"].items():
            texts, pane = chart["texts"], state["frame"]["plots"].get(plot)
            if not pane:
                continue
            seen[plot] += 1
            pairs = [(a["string"], b["string"]) for a, b in itertools.combinations(texts, 2) if overlap(a["box"], b["box"])]
            check(not pairs, f"8: {name}, {size}, {plot}: no two texts overlap", pairs)
            out = [t["string"] for t in texts if t["box"][0] < pane[0] - 1 or t["box"][2] > pane[2] + 1
                   or t["box"][1] < pane[1] - 1 or t["box"][3] > pane[3] + 1]
            check(not out, f"8: {name}, {size}, {plot}: none leaves the plot", out)
            wanted = collections.Counter(chart["x_ticks"] + chart["y_ticks"])
            written = [t["string"] for t in texts]
            units = [text for text in written if is_unit(chart, text)]
            missing = wanted - collections.Counter(written)
            across = [text for text in written if chart["x_title"] and chart["x_title"] in text]
            check(units or across or chart["x_unit"] in (None, "", "1"),
                  f"8: {name}, {size}, {plot}: the x axis has its unit", written)
            check(wanted and not missing, f"8: {name}, {size}, {plot}: each tick has its number", (missing, wanted))
            check(len(chart["x_ticks"]) > 1 < len(chart["y_ticks"]), f"8: {name}, {size}, {plot}: two numbers at each axis",
                  (chart["x_ticks"], chart["y_ticks"]))
            words = [text for text in written if text not in wanted and text not in units]
            check(words, f"8: {name}, {size}, {plot}: there is a title", texts)
            check(all(t["size"] >= 15.9 for t in texts), f"8: {name}, {size}, {plot}: letters can be read",
                  [(t["string"], t["size"]) for t in texts])
# where plots have no room, Shift+P says so; where they have, it says nothing
for size, text, roomy in (("1024x600", "2", False), ("1280x720", "1", True)):
    for name in ("house", "beam"):
        before, after = stage.act(f"room-{name}-{size}", "until answered", "pause", "wait 3", "state STATE", "key Shift+P", "wait 8",
                                  "state STATE", arguments=[FILES[name][0], "--size", size, "--text", text])
        told = (after["said"] or "").startswith("No room for plots")
        check(told == (not roomy) and bool(before["frame"]["plots"] or after["frame"]["plots"]) == roomy,
              f"Shift+P, {name}, {size}, text {text}: plots, or why there are none", (after["said"], after["frame"]["plots"]))

# the numbers around the polar diagram of a crank lie outside its ring
state = stage.act("polar", "until answered", "pause", "wait 5", "state STATE", "picture FOLDER/shot.png",
                  arguments=[stage.CRANK, *stage.PERIODIC, "--size", "1280x720"])[0]
boxes = {t["string"]: t["box"] for t in state["text_in_view"]}
around = [boxes.get(name) for name in ("0\u00b0", "90\u00b0", "180\u00b0", "270\u00b0")]
check(all(around), "the angles around the ring are named", sorted(boxes))
if all(around):
    x = (around[0][0] + around[0][2]) / 2
    y = (around[1][1] + around[1][3]) / 2
    reach = around[2][1] - y
    line = [round(x), round(y + reach / 6), round(x + 2 * reach), round(y + reach / 6) + 1]  # below the 270 degrees
    done = subprocess.run(["convert", str(stage.folder / "polar" / "shot.png"), "-crop", stage.crop(line), "+repage",
                           "-colorspace", "gray", "-depth", "8", "gray:-"], capture_output=True, timeout=600).stdout
    ring = max(i for i in range(round(1.6 * reach)) if done[i] < 160)
    near = {name: max(boxes[name][0] - x, x - boxes[name][2], boxes[name][1] - y, y - boxes[name][3]) for name in boxes
            if name.endswith("\u00b0")}
    check(all(far > ring for far in near.values()), "none of them lies on it", (ring, near))
check(sum(seen.values()) >= 32, "8: two plots a size in each of four files", seen)
stage.end()
