#!/usr/bin/env python3
"""Tests the texts in the view of every shipped house (check 3 of the calm window) with real keys: on both themes, at two
sizes, flat and raised, with the layers of the first start and with all of them, no text lies over another, none is cut, and
none leaves the view.

labels.py CLEARANCE [HOUSE ...] [hovered]"""

import itertools
import json
import os
import pathlib
import re
import shutil
import sys

import stage
from drawing import Plan
from stage import Screen, check

HOUSES = sorted(path.stem for path in (stage.source / "houses").glob("*.json"))
SIZES = ((1280, 720), (1920, 1080))


def overlap(a, b):
    return a[0] < b[2] - 0.5 and b[0] < a[2] - 0.5 and a[1] < b[3] - 0.5 and b[1] < a[3] - 0.5


def is_person(text):
    return len(text["string"]) == 1 and text["string"].isalpha()


def written(screen):
    """Returns the labels of the view, and the other texts that are written over it, with the view."""
    painted, state = screen.texts(), screen.state()
    view = state["frame"]["view"]
    above = [{**text, "kind": "above"} for text in painted if text["string"].strip() and overlap(text["box"], view)
             and text["clip"][2] <= view[2] + 1 and text["clip"][0] >= view[0] - 1 and text["clip"][1] >= view[1] - 1]
    return state["text_in_view"] + above, view, state


def signs_of(texts):
    """Returns the boxes of the exits' signs, by what stands on them before the number of people."""
    named = {text["string"].split(":")[0]: text["box"] for text in texts}
    return {name: box for name, box in named.items() if re.match(r"EXIT|e[0-9]+$", name)}


def look(screen, what):
    """Checks what is written at this moment, and returns the places of the exits' signs."""
    texts, view, state = written(screen)
    standing = [t for t in texts if not is_person(t)]  # letters of people move over what lies on the floor
    pairs = [(a["string"], b["string"]) for a, b in itertools.combinations(standing, 2) if overlap(a["box"], b["box"])]
    check(not pairs, f"3: {what}: no two texts overlap", pairs)
    out = [t["string"] for t in texts if t["box"][0] < view[0] - 0.5 or t["box"][1] < view[1] - 0.5
           or t["box"][2] > view[2] + 0.5 or t["box"][3] > view[3] + 0.5]
    check(not out, f"3: {what}: none leaves the view", out)
    names = [t for t in texts if t["kind"] == "name" and not t["string"].endswith(" m")]
    area = (view[2] - view[0]) * (view[3] - view[1]) / state["unit"] ** 2
    check(len(names) <= area / 30000, f"3: {what}: not too many names", len(names))
    out = [int(row[1].split("/")[0]) for row in state["rows"] if re.fullmatch(r"[0-9]+/[0-9]+", row[1])]
    said = [text["string"] for chart in state["charts"].values() for text in chart["texts"]]
    check(not (out and sum(out)) or "nobody is out" not in said, f"{what}: no plot says that nobody is out", (out, said))
    kept = os.environ.get("CLEARANCE_SCREENS")
    if kept:
        shutil.copy(screen.shot("now"), pathlib.Path(kept) / f"{what.replace(' ', '-').replace(',', '')}.png")
    return signs_of(texts)


chosen = [name for name in sys.argv[2:] if name in HOUSES] if sys.argv[2:] else HOUSES
for (width, height), name in itertools.product(SIZES, chosen):
    screen = Screen(f"{name}-{height}", stage.house(name), width=width, height=height, minutes=20, texts=True)
    screen.until(lambda s: not s["answer"]["stale"] and (s["complete"] or s["end"] > 5))  # 10,000 people take minutes
    if screen.state()["playing"]:
        screen.keys("space")
    screen.point_to(width - 1, height - 1)
    first, signs = screen.state()["layers"], {}
    for theme in ("paper", "board"):
        for part in (0, 1):
            for layers in ("first", "all"):
                if layers == "all":
                    screen.keys(*[str(i) for i in range(1, 10) if not screen.last["layers"] & 1 << i - 1])
                where = f"{name}, {height}, {theme}, {('begin', 'middle')[part]}, {layers} layers"
                now = look(screen, where)
                check(signs.setdefault(layers, now) == now, f"3: {where}: the exits' signs stay in place", (signs[layers], now))
                if theme == "paper":
                    screen.keys("v")
                    screen.until(lambda s: s["raised"])
                    now = look(screen, f"{where}, raised")
                    check(signs.setdefault(layers + "raised", now) == now,
                          f"3: {where}, raised: the exits' signs stay in place", (signs[layers + "raised"], now))
                    screen.keys("v")
            screen.keys(*[str(i) for i in range(1, 10) if (screen.last["layers"] ^ first) & 1 << i - 1])
            check(screen.last["layers"] == first, "the layers are as at first", (first, screen.last["layers"]))
            if part == 0:
                track = screen.last["frame"]["timeline"]
                screen.click((track[0] + track[2]) / 2, (track[1] + track[3]) / 2)
                screen.point_to(width - 1, height - 1)
            else:
                screen.keys("Home")
        screen.keys("ctrl+t")
    screen.end()

# what is below the pointer is named by words, at both sizes: no id of a wall, door or piece
plan = json.loads(open(stage.house("ube-techno-house")).read())
for width, height in SIZES if not sys.argv[2:] or "hovered" in sys.argv[2:] else ():
    screen = Plan(f"hovered-{height}", stage.house("ube-techno-house"), width=width, height=height, minutes=20)
    screen.until(lambda s: s["complete"] and not s["answer"]["stale"])
    screen.keys("space")
    told = {}
    for wall in plan["walls"]:
        for a, b in zip(wall["points"], wall["points"][1:]):
            for part in (0.2, 0.5, 0.8):
                screen.move(*[p + part * (q - p) for p, q in zip(a, b)])
                told[screen.state()["hovered"]] = wall["id"]
    ids = [name for name in told if re.search(r"\b[wdfe][0-9]+\b", name)]
    between = [name for name in told if name.startswith("wall between ")]
    beside = [name for name in told if re.match(r"(left|right|upper|lower) wall of ", name)]
    check(not ids and len(between) >= 3 and len(beside) >= 3, f"28: {width} x {height}: walls are named by their rooms", sorted(told))
    screen.end()
stage.end()
