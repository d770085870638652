#!/usr/bin/env python3
"""Tests by a real pointer that the lengths beside what is dragged leave the signs of the picture readable."""

import itertools

import stage
from drawing import Plan
from stage import check


def overlap(a, b):
    return a[0] < b[2] - 0.5 and b[0] < a[2] - 0.5 and a[1] < b[3] - 0.5 and b[1] < a[3] - 0.5


screen = Plan("dragged", stage.house("bedroom-after-earthquake"), minutes=5, texts=True)
screen.until(lambda s: s["complete"] and not s["answer"]["stale"])
screen.drag(1.42, 3.43, 1.52, 3.33, release=False)
held, told = 0, 0
for step in range(12):
    screen.move(1.52 + 0.03 * step, 3.33 - 0.03 * step)
    state = screen.until(lambda s: not s["answer"]["stale"])
    signs = [t for t in state["text_in_view"] if t["kind"] != "name"]
    lengths = [t for t in screen.texts() if t["string"].endswith(" m") and t["string"][0].isdigit()
               and overlap(t["box"], state["frame"]["view"])]
    hidden = [(a["string"], b["string"]) for a, b in itertools.product(signs + lengths, lengths)
              if a != b and overlap(a["box"], b["box"])]
    check(not hidden, f"step {step}: no length lies over a sign or another length", hidden)
    held += "cannot pass" in state["answer"]["title"]
    told += len(lengths)
check(held >= 6 and told >= 36, "the chair is held, and lengths are told", (held, told))
screen.release()
screen.end()
stage.end()
