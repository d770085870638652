#!/usr/bin/env python3
"""Tests a message of each kind (check 16 of the calm window) with a real mouse and real keys, at two sizes: a hint, an edit
that is done, faults and work stand in the strip, whole, while everything above it is the same to the pixel."""

import json

import stage
from stage import Screen, check, differing


def inside(box, other):
    return other[0] - 1 <= box[0] and other[1] - 1 <= box[1] and box[2] <= other[2] + 1 and box[3] <= other[3] + 1


def above(state):
    """Returns all that lies above the strip: menu, answer, view with its scale bar, plots, panel and timeline."""
    return [0, 0, state["width"], state["frame"]["strip"][1]]


def stands(screen, kind, words, quiet, also=()):
    """Checks that a message stands whole in the strip and changes nothing above it."""
    shot = screen.shot(kind)
    texts, state = screen.texts(), screen.state()
    strip = state["frame"]["strip"]
    found = [t for t in texts if words in t["string"] and inside(t["box"], strip)]
    check(found and all(inside(t["box"], t["clip"]) for t in found), f"16: {kind}: it stands in the strip, whole",
          [t["string"] for t in texts if t["box"][1] > strip[1] - 60])
    for word in also:
        check(any(word == t["string"] and inside(t["box"], strip) for t in texts), f"16: {kind}: with {word}",
              [t["string"] for t in texts if inside(t["box"], strip)])
    check(differing(quiet, shot, above(state), "0%") == 0, f"16: {kind}: nothing above it is touched",
          differing(quiet, shot, above(state), "0%"))
    check(differing(quiet, shot, strip) > 50, f"16: {kind}: it is seen")
    return next((t["box"] for t in texts if t["string"] == "\\u00d7" and inside(t["box"], strip)), None)


def settle(screen):
    return screen.until(stage.is_settled)


for width, height in ((1280, 720), (1920, 1080)):
    size = f"{width} x {height}"
    house = stage.folder / f"mine-{height}.json"
    house.write_text(open(stage.house("ube-techno-house")).read())
    screen = Screen(f"messages-{height}", house, width=width, height=height, minutes=20, texts=True)
    screen.until(lambda s: s["complete"] and s["time"] > 1)
    screen.keys("space", "ctrl+j")
    settle(screen)
    screen.point_to(width - 2, height - 2)
    screen.until(lambda s: not s["said"])
    quiet = screen.shot("quiet")

    # a hint stays until the next key
    screen.keys("n")
    screen.until(lambda s: s["said"] and "napping" in s["said"])
    stands(screen, f"{size}, hint", "napping", quiet)
    screen.keys("n")

    # what is done, with a button that undoes it: the picture with the message is the one after it has gone
    screen.keys("Tab")
    for _ in range(20):  # the message stays for some seconds, which a busy machine may need for a picture
        screen.keys("Right")
        settle(screen)
        said = screen.until(lambda s: s["said"] and s["undo_name"])["said"]
        done = screen.shot("done")
        state = screen.state()
        if state["said"] == said:
            break
    strip = state["frame"]["strip"]
    shown = [t["string"] for t in screen.texts() if inside(t["box"], strip)]
    check(said in shown and "Undo" in shown, f"16: {size}, done: it stands in the strip, with Undo", shown)
    screen.until(lambda s: not s["said"])
    gone = screen.shot("gone")
    check(differing(done, gone, above(state), "0%") == 0, f"16: {size}, done: nothing above it is touched")
    check(differing(done, gone, strip) > 50, f"16: {size}, done: it is seen for some seconds")
    edits = screen.state()["edits"]
    for _ in range(20):
        screen.keys("Right")
        screen.until(lambda s: s["said"])
        undo = [t for t in screen.texts() if t["string"] == "Undo" and inside(t["box"], strip)]
        if undo and screen.state()["said"]:
            break
    made = screen.state()["edits"]
    screen.click(*[sum(undo[0]["box"][i::2]) / 2 for i in (0, 1)])
    check(edits < made and screen.until(lambda s: s["edits"] == made - 1)["edits"] == made - 1, f"16: {size}, done: a click on Undo takes it back")
    while screen.state()["undo_name"]:
        screen.keys("ctrl+z")
    screen.keys("Escape", "Escape")
    screen.point_to(width - 2, height - 2)
    settle(screen)
    screen.until(lambda s: not s["said"])
    quiet = screen.shot("quiet")

    # faults stay, one after another; several of a file are listed first
    broken = stage.folder / "broken.json"
    broken.write_text(json.dumps({**json.loads(house.read_text()), "wals": [], "dors": []}))
    screen.keys("ctrl+o")
    screen.until(lambda s: s["sheet"] == "open")
    screen.keys("ctrl+a")
    screen.type(str(broken))
    screen.keys("Return")
    screen.until(lambda s: s["sheet"] == "messages" and s["faults"] == 2)
    screen.keys("Escape")
    screen.until(lambda s: s["sheet"] == "none")
    screen.point_to(width - 2, height - 2)
    state = settle(screen)
    faults = state["faults"]
    stands(screen, f"{size}, fault", "broken.json:1:", quiet)
    told = [t["string"] for t in screen.texts() if inside(t["box"], strip)]
    check(any(f"1 of {faults}" in text for text in told), f"16: {size}, fault: the next ones wait", (faults, told))

    # dismissed one after another
    for left in range(faults - 1, -1, -1):
        screen.keys("Escape")
        check(screen.state()["faults"] == left, f"16: {size}, fault: Escape dismisses one", (left, screen.state()["faults"]))

    # work is counted, with Cancel, from its beginning on
    screen.keys("ctrl+e")
    screen.until(lambda s: s["sheet"] == "export")
    screen.keys(*["Tab"] * 7, "Return")
    screen.until(lambda s: s["sheet"] == "none" and s["export"] and "picture" in s["export"]["doing"])
    screen.point_to(width - 2, height - 2)
    stands(screen, f"{size}, work", "picture ", quiet, ("Cancel",))
    cancel = [t["box"] for t in screen.texts() if t["string"] == "Cancel"][0]
    screen.click((cancel[0] + cancel[2]) / 2, (cancel[1] + cancel[3]) / 2)
    check(not screen.until(lambda s: not s["export"])["export"], f"16: {size}, work: a click on Cancel ends it")
    screen.end()
stage.end()
