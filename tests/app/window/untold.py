#!/usr/bin/env python3
"""Tests that no lesson tells its result before the guess (check 24 of the calm window), with real keys, at two sizes, with
and without presentation mode: neither texts nor labels, title, tool tips nor what Tab selects have what the answer says
afterwards."""

import re

import stage
from classroom import lesson, step, wait
from stage import Screen, check

LESSONS = ("legal-no-way", "shortest-not-fastest", "smallest-corner", "two-doors-locked", "which-wardrobe")


def seen(screen):
    """Returns all that can be read or heard at this moment."""
    texts, state = screen.texts(), screen.state()
    told = [t["string"] for t in texts] + [t["string"] for t in state["text_in_view"]]
    told += [state["shown_title"], state["hovered"], state["focus_help"], state["selected"]]
    return {text for text in told if text}


for name in LESSONS:
    for width, height, presents in ((1280, 720, False), (1920, 1080, True)):
        what = f"24: {name}, {width} x {height}{', presented' if presents else ''}"
        screen = Screen(f"{name}-{height}", lesson(name), width=width, height=height, minutes=20, texts=True)
        if presents:
            screen.keys("F5")
        wait(screen, lambda s: s["lesson"] and not s["lesson"]["working"] and (s["present"] or not presents))
        screen.keys("Next")
        step(screen, 2)
        told = seen(screen) | {screen.tool("getwindowname", screen.window).stdout}
        check(screen.state()["lesson"]["hides"] and not screen.state()["playing"], f"{what}: the class guesses first")
        for key in ["Tab"] * 8 + ["F6"] * 5:
            screen.keys(key)
            told |= seen(screen)
        screen.keys("ctrl+e")
        told |= seen(screen)
        rows = {text.split(":")[0] for text in seen(screen)}
        check(screen.state()["sheet"] == "export" and not rows & {"Data", "Plots", "Report", "Film"},
              f"{what}: nor can it be written to a file", rows)
        screen.keys("Escape")
        while screen.state()["focus"] != "view":
            screen.keys("F6")
        screen.keys(*(("0", "period", "9", "Return") if name == "smallest-corner" else ("1", "1", "2")))
        screen.keys("Next")
        now = wait(screen, lambda s: s["lesson"]["step"] == 3 and not s["answer"]["stale"])
        screen.keys("1")
        now = wait(screen, lambda s: s["lesson"]["chosen"] and s["answer"]["title"] and not s["answer"]["stale"])
        details = re.split(r" *[;\u00b7,] *", now["answer"]["detail"] or "")
        result = [now["answer"]["title"], *(part for part in details if len(part) > 4)]
        leaked = [(part, text) for part in result for text in told if part in text]
        check(len(result[0]) > 4 and not leaked, f"{what}: nothing tells the result", (leaked, result))
        screen.end()
stage.end()
