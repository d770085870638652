#!/usr/bin/env python3
"""Tests the window with large text and in a small window (check 22, and 16 of the calm window), with real keys and
mouse: the panel is opened and closed by its handle, the tools by a button, the next thing to try is offered, and no hint
or message lies over the answer, the menu or the plan."""

import itertools

import stage
from stage import check

FINE = 1.5  # pixels
HANDLE = 14  # design points
WALL = (7.0, 3.92)  # m, a place on a wall


def inside(box, outer):
    return outer[0] - FINE <= box[0] and box[2] <= outer[2] + FINE and outer[1] - FINE <= box[1] and box[3] <= outer[3] + FINE


def overlap(a, b):
    low = 0.2 * (a[3] - a[1])  # boxes are as high as lines, with empty edges
    return a[0] < b[2] - 1 and b[0] < a[2] - 1 and a[1] < b[3] - low and b[1] < a[3] - low


def middle(box):
    return (box[0] + box[2]) / 2, (box[1] + box[3]) / 2


def box_of(texts, words, within):
    """Returns the box of a text that stands in a part of the window; None: there is none."""
    return next((t["box"] for t in texts if words in t["string"] and inside(t["box"], within)), None)


def seen(text):
    """Returns the part of a text's box that is not clipped."""
    box, clip = text["box"], text["clip"]
    return [max(box[0], clip[0]), max(box[1], clip[1]), min(box[2], clip[2]), min(box[3], clip[3])]


def look(screen, what):
    """Checks that the texts beside the view lie apart, are whole, and that the answer is there; returns the texts and
    the state."""
    texts, state = [{**t, "box": seen(t), "whole": t["box"][2] - t["box"][0]} for t in screen.texts() if t["string"].strip()], screen.state()
    texts = [t for t in texts if t["box"][0] < t["box"][2] and t["box"][1] < t["box"][3]]
    frame = state["frame"]
    beside = [t for t in texts if not overlap(t["box"], frame["view"]) and not overlap(t["box"], frame["panel"])]
    pairs = [(a["string"], b["string"]) for a, b in itertools.combinations(beside, 2) if overlap(a["box"], b["box"])]
    check(not pairs, f"{what}: none of the texts lies over another", pairs)
    cut = [t["string"] for t in texts if t["string"] == "\u2026" or t["whole"] > t["box"][2] - t["box"][0] + FINE]
    check(not cut, f"{what}: none is cut", cut)
    check(box_of(texts, state["answer"]["title"], frame["answer"]), f"{what}: the answer is there", frame["answer"])
    return texts, state


for width, height, text in ((1280, 720, 1.5), (1280, 720, 2), (1024, 600, 1)):
    name = f"{width} x {height}, {text:.0%}"
    screen = stage.Screen(f"{width}-{text}", stage.house("ube-techno-house"), width=width, height=height, texts=True)
    screen.until(lambda s: s["complete"] and not s["answer"]["stale"])
    screen.keys(*["ctrl+equal"] * round(4 * (text - 1)), "space", "Escape")
    check(screen.state()["text"] == text and not screen.last["playing"], f"{name}: the text has its size", screen.last["text"])
    texts, state = look(screen, f"{name}, at rest")
    frame = state["frame"]

    # what is tried next is offered, above the strip of keys or in it
    check(box_of(texts, "Try this", frame["tries"]), f"{name}: the next thing to try is offered", frame["tries"])
    if frame["tries"][3] > frame["timeline"][3]:
        check(inside(frame["tries"], frame["strip"]), f"{name}: in the strip", frame)

    # the handle opens the panel and closes it
    handle = frame["handle"]
    check(abs(handle[2] - handle[0] - HANDLE * state["unit"]) < 1 and handle[2] == width and handle[3] - handle[1] > 200,
          f"{name}: a closed panel has a handle", handle)
    screen.click(*middle(handle))
    _, state = look(screen, f"{name}, panel open")
    panel, handle = state["frame"]["panel"], state["frame"]["handle"]
    check(panel[2] - panel[0] > 300 and abs(handle[2] - panel[0]) < 1, f"{name}: the handle opens the panel", (panel, handle))
    tries = state["frame"]["tries"]
    check(panel[3] <= tries[1] + 1 or not overlap(panel, tries), f"{name}: the panel hides none of the things to try", (panel, tries))
    screen.click(*middle(handle))
    check(screen.state()["frame"]["panel"][0] >= width - 1, f"{name}: and closes it", screen.last["frame"])

    # a button opens the tools; what a tool does is said below the answer
    button = box_of(texts, "Edit", frame["timeline"]) or box_of(texts, "\u270e", frame["timeline"]) or box_of(texts, "Edit plan", frame["view"])
    check(button, f"{name}: there is a button for editing", [t["string"] for t in texts])
    if button:
        screen.click(*middle(button))
        check(screen.state()["editing"], f"{name}: the button opens the tools")
        screen.point_to(width - 1, height / 2)
        screen.keys("d")
        texts, state = look(screen, f"{name}, door tool")
        check(box_of(texts, "Click a wall", state["frame"]["strip"]), f"{name}: the strip says what the tool does", state["frame"])
        track = state["frame"]["timeline"]
        check(box_of(texts, "Play", track) and state["frame"]["rail"][2] > 0, f"{name}: tools and timeline are there", track)
        origin, right, up = state["floor"]
        screen.point_to(*[origin[i] + WALL[0] * (right[i] - origin[i]) + WALL[1] * (up[i] - origin[i]) for i in (0, 1)])
        tags = [t for t in screen.texts() if t["string"].endswith(" m") and inside(t["box"], state["frame"]["view"])]
        doors = [t["string"] for t in tags if "0.80 m" in t["string"]]
        check(doors == ["door 0.80 m"], f"{name}: the width of a door to be made is written once", [t["string"] for t in tags])
        screen.keys("Escape", "ctrl+j")

    # a message, even a long one, is below the view
    screen.keys("shift+t")
    screen.until(lambda s: "Shake 1" in (s["message"] or ""))
    texts, frame = screen.texts(), screen.last["frame"]
    check("\u2026" not in [t["string"] for t in texts], f"{name}: what is worked out is said in whole words", [t["string"] for t in texts])
    lower = [0, frame["timeline"][1], width, height]
    check(box_of(texts, "Shake 1", lower), f"{name}: a message is below the view", [t["string"] for t in texts])
    screen.end()

# an answer that has no room beside its title is whole below it
texts, state = stage.act("blocked", "until answered", "until complete", "until idle", "wait 5", "texts STATE", "state STATE",
                         arguments=[stage.house("flat-0.910-module"), "--size", "1280x720", "--text", "2"])
words = " ".join(t["string"] for t in texts if inside(seen(t), state["frame"]["answer"]))
check("needs at least" in words and "has 0.75 m" in words, "the whole answer is there", words)

# what is selected next is described from the panel's top
texts, state = stage.act("top", "until answered", "pause", "key Tab", "wait 3", "mouse 1100 400", "wheel -60", "wait 5", "key Tab",
                         "wait 5", "texts STATE", "state STATE", arguments=[stage.house("ube-techno-house"), "--size", "1280x720"])
panel = state["frame"]["panel"]
check(box_of(texts, "wheelchair", [*panel[:3], panel[1] + 50]), "the panel begins at its top when another thing is selected",
      [t["string"] for t in texts if inside(seen(t), panel)])
stage.end()
