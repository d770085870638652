#!/usr/bin/env python3
"""Tests that texts fit (check 22, and 28 of the calm window): at two small sizes, with large letters in the smaller
one, in each laboratory and on the sheets, no text is cut, none ends in an ellipsis, and none of a pane lies over
another. Also what moves: the plan stands still while the tools open, and folds are remembered by task."""

import itertools
import re

import stage
from stage import check

FILES = {"house": stage.house("ube-techno-house"), "blocked": stage.house("flat-0.910-module"),
         "beam": stage.beam("ibs"), "crank": stage.CRANK}
FINE = 1.5  # pixels
PAD = 5  # pixels beside the words of a tag
EMPTY = 0.2  # of a line: boxes are as high as lines, with empty edges


def cut(texts):
    """Returns the texts that are cut at a side, or shortened by an ellipsis. A pane that scrolls cuts at its foot."""
    found = []
    for i, text in enumerate(texts):
        box, clip = text["box"], text["clip"]
        seen = box[2] > clip[0] and box[0] < clip[2] and box[3] > clip[1] and box[1] < clip[3]
        if seen and text["string"] == "\u2026":
            found.append(texts[i - 1]["string"] + "\u2026")
        elif seen and text["string"].strip() and (box[0] < clip[0] - FINE or box[2] > clip[2] + FINE):
            found.append(text["string"])
    return found


def overlapping(texts):
    """Returns pairs of texts of one pane, that is of one clip, that lie over one another."""
    found = []
    for a, b in itertools.combinations([t for t in texts if t["string"].strip()], 2):
        low = EMPTY * (a["box"][3] - a["box"][1])
        if a["clip"] == b["clip"] and a["string"] != b["string"] and a["box"][0] < b["box"][2] - 1 and \
                b["box"][0] < a["box"][2] - 1 and a["box"][1] < b["box"][3] - low and b["box"][1] < a["box"][3] - low:
            found.append((a["string"], b["string"]))
    return found


for name, path in FILES.items():
    for size, text in (("1024x600", "2"), ("1280x720", "1")):
        steps = {"at rest": [], "selected": ["key Tab", "key Return"], "gallery": ["key Escape", "key Escape", "key F4"],
                 "open": ["key Escape", "key Ctrl+O"], "export": ["key Escape", "key Ctrl+E"]}
        if name == "house":
            steps["furniture"] = ["key Escape", "key O"]
        lines = [line for keys in steps.values() for line in [*keys, "wait 8", "texts STATE"]]
        brief = stage.PERIODIC if name == "crank" and (size, text) != ("1024x600", "2") else ()
        found = stage.act(f"{name}-{size}-{text}", "until answered", "pause", *lines,
                          arguments=[path, *brief, "--size", size, "--text", text])
        for step, texts in zip(steps, found):
            check(not cut(texts), f"22: {name}, {size}, text {text}, {step}: no text is cut", cut(texts))
            check(not overlapping(texts), f"22: {name}, {size}, text {text}, {step}: none lies over another",
                  overlapping(texts))
            rows = [t["string"].split(":")[0] for t in texts if step == "export"]
            check((step != "export") or ("Report" in rows) == ("Walkable area" in rows) == (name in ("house", "blocked")),
                  f"{name}: a report and an area are offered for a house only", rows)

# the labels of the beam's drawing lie apart, whatever its forces are
BRIEF = ("--set", "drive.frequency=190", "--set", "run.transient_cycles=20", "--set", "run.cycles=20", "--set", "beam.modes=2")
for size, text, least in (("1024x600", "2", 4), ("1280x720", "2", 2), ("1280x720", "1", 9), ("1024x600", "1", 8)):
    found = stage.act(f"labels-{size}-{text}", "until answered", "pause",
                      *[line for t in range(4) for line in (f"seek {0.0125 + 0.0009 * t:.4f}", "wait 2", "state STATE")],
                      arguments=[FILES["beam"], *BRIEF, "--size", size, "--text", text])
    labels = [[{**label, "clip": 0, "string": f'{label["string"]} ({i})'}
               for i, label in enumerate(state["text_in_view"])] for state in found]
    hidden = [pair for shown in labels for pair in overlapping(shown)]
    counts = [len(shown) for shown in labels]
    columns = [[t["box"][0] for t in state["text_in_view"] if t["string"].startswith(("last ", "0.127 mm"))] for state in found]
    check(text == "2" or max(max(c) - min(c) for c in columns) < 1, f"beam, {size}: forces stand beside the dimensions, not over "
          "them", columns)
    check(not hidden and min(counts) >= least, f"beam, {size}, text {text}: the drawing's labels lie apart", (hidden, counts))

# what is still being worked out is told below the numbers, or not at all
found = stage.act("note", "until answered", *["wait 3", "texts STATE"] * 4,
                  arguments=[FILES["beam"], *BRIEF, "--size", "1280x720", "--text", "2"])
for texts in found:
    head = [t for t in texts if t["box"][3] < 200 and t["box"][1] > 50]
    check(not overlapping(head), "a note below the numbers does not lie over them", overlapping(head))

# what the first cards of the gallery offer is written out, with large letters, too
texts = stage.act("cards", "until answered", "pause", "key F4", "wait 20", "texts STATE",
                  arguments=[FILES["house"], "--size", "1280x720", "--text", "2"])[0]
words = " ".join(t["string"] for t in texts if t["box"][3] <= t["clip"][3])
check("Suggest a fix" in words, "a card's line is whole", words[:400])

# a selected door under the pointer has its name in the tag there
texts, state = stage.act("hovered", "until answered", "pause", "wait 3", "click 430 298", "wait 6", "texts STATE", "state STATE",
                         arguments=[FILES["house"], "--size", "1280x720"])
name = state["hovered"]
tags = [t for t in texts if t["string"] == name and t["box"][2] < state["frame"]["view"][2] and t["box"][1] < 298]
check(name and len(tags) == 1, "the tag at the pointer has the name of a selected door, which stands once",
      (name, [t["string"] for t in texts][:20]))

# the name of the person under the pointer does not hide an exit
texts, state = stage.act("beside-exit", "until answered", "pause", "seek 1.5", "mouse 655 390", "wait 6", "texts STATE",
                         "state STATE", arguments=[FILES["house"], "--size", "1280x720"])
name = [t["box"] for t in texts if t["string"] == "C, wheelchair" and t["box"][2] < state["frame"]["view"][2]]
sign = [t["box"] for t in state["text_in_view"] if t["string"] == "EXIT porch"]
check(len(name) == len(sign) == 1 and (name[0][2] + PAD < sign[0][0] or name[0][3] < sign[0][1] or sign[0][3] < name[0][1]),
      "the name of a person under the pointer hides no exit", (name, sign))

# while a piece is dragged, its four lengths stand about it, and over no name
texts, state = stage.act("lengths", "until answered", "pause", "at 9.20 8.74", "press", "at 9.0 8.4", "at 8.71 7.85", "wait 10",
                         "texts STATE", "state STATE", arguments=[FILES["house"], "--size", "1280x720"])
(left, foot), (right, _), (_, up) = state["floor"]
x, y = ([origin + at * (unit - origin) for at in ends] for origin, unit, ends in
        ((left, right, (8.21, 9.21)), (foot, up, (8.135, 7.585))))
piece = [x[0], y[0], x[1], y[1]]
lengths = [t["box"] for t in texts if re.fullmatch(r"\d\.\d\d m", t["string"]) and t["box"][2] < state["frame"]["view"][2]]
names = [t["box"] for t in state["text_in_view"] if t["string"] in ("bed", "closet", "toilet")]
over = [(a, b) for a in lengths for b in [piece, *names]
        if a[0] - PAD < b[2] and b[0] < a[2] + PAD and a[1] < b[3] and b[1] < a[3]]
check(len(lengths) == 4 and not over, "a dragged piece's lengths hide neither it nor a name", (len(lengths), over))

# the tool tip of a button in the view is next to it
texts = stage.act("tip", "until answered", "pause", "wait 3", "mouse 50 118", *["wait 100", "texts STATE"] * 3,
                  arguments=[FILES["house"], "--size", "1280x720"])
tips = [t["box"] for t in texts[-1] if t["string"].startswith("Edit plan (Ctrl+J)")]
check(len(tips) == 1 and 134 <= tips[0][1] < 160, "the tool tip of the button for editing is next to it", tips)

# beside a column that is lower than wide, a tool tip hides neither rows nor the timeline
texts = stage.act("drawer", "until answered", "pause", "key Ctrl+J", "key H", "wait 3", "mouse 800 345",
                  *["wait 100", "texts STATE"] * 2, "mouse 40 425", *["wait 100", "texts STATE"] * 2,
                  arguments=[FILES["house"], "--size", "1024x600", "--text", "2"])
row = [t["box"] for t in texts[1] if t["string"].startswith("chest: Select")]
tool = [t["box"] for t in texts[3] if "Place people" in t["string"]]
check(len(row) == 1 and row[0][2] < 416 and tool and tool[0][0] > 190 and tool[0][3] < 452,
      "a tool tip of a low column lies beside it, above the timeline", (row, tool))

# with the largest letters there is no strip: messages and what a tool does are whole, above the view
for size in ("1920x1080", "1280x720"):
    lines = ["until answered", "pause", "key Shift+T", "wait 5", "texts STATE", "state STATE", "key Shift+P", "wait 5",
             "texts STATE", "key Escape", "key W", "wait 5", "texts STATE"]
    shaken, state, plots, tool = stage.act(f"largest-{size}", *lines, arguments=[FILES["house"], "--size", size, "--text", "3"])
    top = state["frame"]["view"][1]
    for texts, begin, last in ((shaken, "Shake 1:", "24"), (plots, "No room for plots", "(Ctrl+-)"),
                               (tool, "Click where the wall", "place.")):
        above = [t for t in texts if t["box"][3] <= top + 1]
        words = " ".join(t["string"] for t in above)
        check(begin in words and last in words.split(begin)[-1], f"{size}: {begin} ... is whole above the view", words)

# a tooltip lies over nothing while one types, and comes no more after a click before the pointer has left
waited, typed, clicked = stage.act("tip-typed", "until answered", "pause", "wait 3", "mouse 50 118", "wait 500", "texts STATE",
                                   "type 2", "wait 3", "texts STATE", "mouse 640 400", "wait 500", "click 50 118", "wait 500",
                                   "texts STATE", arguments=[FILES["house"], "--size", "1280x720"])
shown = [any("walls" in t["string"] and t["box"][0] < 400 for t in texts) for texts in (waited, typed, clicked)]
check(shown == [True, False, False], "a tooltip is hidden by typing and by a click", shown)

# a presentation has no note, no word that it is paused, and no scale: only danger 1, EXIT and letters
for name in ("house", "beam"):
    texts, *_ = stage.act(f"plain-{name}", "until answered", "pause", "key F5", "wait 120", "texts STATE",
                          arguments=[FILES[name], "--size", "1280x720"])
    more = [t["string"] for t in texts if t["string"].startswith(("assumed", "identified", "PAUSED")) or t["string"] in ("2 m", "5 m")]
    check(texts and not more, f"a presentation of a {name} has no notes and no scale", more)

# a clock of many words is whole with the largest letters, smaller or without its first words
texts, state = stage.act("clock", "until answered", "pause", "seek 3.5", "wait 5", "texts STATE", "state STATE",
                         arguments=[FILES["crank"], *stage.PERIODIC, "--size", "1024x600", "--text", "3"])
clocks = [t for t in texts if t["string"].endswith(" s") and t["string"] in state["clock"]]
check(clocks and not cut(texts) and all(t["box"][2] <= 1024 for t in clocks), "a clock is whole with the largest letters",
      ([t["string"] for t in texts], state["clock"], cut(texts)))

# the buttons of a lesson have shorter words with large letters
for words in ("vote", "hint"):
    texts = stage.act(f"lesson-{words}", "until answered", "wait 5", "key PageDown", "wait 10",
                      *(["key 1", "key PageDown", "wait 10", "key PageDown", "wait 10"] if words == "hint" else []), "texts STATE",
                      arguments=[str(stage.source / "assets" / "lessons" / "legal-no-way.json"), "--size", "1280x720", "--text", "2"])[0]
    check(len(texts) > 10 and not cut(texts), f"a lesson with large letters, {words}: no text is cut", cut(texts))

# a machine speaks plain words, with the terms of the trade in brackets, and those of a changed number are whole
PLAIN = {"beam": ("How fast to shake", "Where the tip goes (phase plane)", "Impact beam (set B)"),
         "crank": ("How fast it turns", "Where the ball goes (phase plane)", "Slider crank (desk rig)")}
for name, expected in PLAIN.items():
    changed = ("--set", "drive.frequency=301") if name == "beam" else stage.PERIODIC
    texts, state = stage.act(f"plain-{name}-words", "until answered", "pause", "wait 5", "texts STATE", "state STATE",
                             arguments=[FILES[name], *changed, "--size", "1280x720"])
    plot = state["charts"]["phase"]["texts"]
    strings, head = [t["string"] for t in texts + plot], f'{state["answer"]["title"]}: {state["answer"]["detail"]}'
    check(not cut(texts) and set(expected) <= set(strings), f"{name}: its plain words are whole", (cut(texts), strings))
    check(re.search(r"hardest (hit|push)(e?s [0-9]+ to)? [0-9]+ N", head) and not re.search(r"quick|peaks|\d-\d", head),
          f"{name}: the headline is plain", head)

# the feet of a title's letters stand above the progress
for size, text in (("1920x1080", "2"), ("1280x720", "1"), ("1024x600", "2")):
    texts, state = stage.act(f"feet-{size}", "until answered", "pause", "wait 5", "texts STATE", "state STATE",
                             arguments=[FILES["beam"], "--size", size, "--text", text])
    head = [t["box"] for t in texts if t["string"] == state["answer"]["title"]]
    check(head and head[0][3] <= state["frame"]["answer"][3] - 3, f"{size}, text {text}: the title is above the progress",
          (head, state["frame"]["answer"]))

# the fold of the plots has whole names
texts = stage.act("plot-names", "until answered", "pause", "mouse 1100 400", "wheel -60", "wait 10", "click 1080 577", "wait 20",
                  "wheel -60", "wait 10", "texts STATE", arguments=[FILES["beam"], *BRIEF, "--size", "1280x720"])[0]
names = [t["string"] for t in texts if t["box"][0] > 976]
check({"Where the tip goes", "Once a cycle", "Tones", "All rhythms at a glance"} <= set(names) and not cut(texts),
      "the fold of the plots has whole names", (names, cut(texts)))

# a detail of two lines breaks between its clauses
for name in ("beam", "crank"):
    texts, state = stage.act(f"clauses-{name}", "until answered", "pause", "key F5", "wait 20", "texts STATE", "state STATE",
                             arguments=[FILES[name], *(BRIEF if name == "beam" else stage.PERIODIC), "--size", "1280x720"])
    detail, foot = state["answer"]["detail"].split("\n")[0], state["frame"]["answer"][3]
    lines = [t["string"] for t in texts if t["box"][3] <= foot and t["string"] in detail]
    ends = [detail[detail.find(line) + len(line):][:1] for line in lines]
    check(lines and all(end in ("", ",", ";", " ") for end in ends) and all(
        end != " " or "\u00b7" in detail[detail.find(line):][len(line):len(line) + 3] for end, line in zip(ends, lines)),
          f"a presented {name}'s detail breaks between its clauses", (lines, detail))

# a slider that was clicked stays below the pointer when a list is inserted above it
texts = stage.act("anchored", "until answered", "pause", "wait 5", "mouse 1100 400", "wheel -4", "wait 10", "click 1100 214",
                  "wait 10", "texts STATE", "click 1100 330", "wait 3", "until answered", "wait 20", "texts STATE",
                  arguments=[FILES["house"], "--size", "1280x720"])
panels = [[t for t in seen if t["box"][0] > 976] for seen in texts]
places = [next((t["box"][1] for t in panel if t["string"] == "width"), None) for panel in panels]
inserted = [any(t["string"].startswith("Compare:") for t in panel) for panel in panels]
check(inserted == [False, True] and places[0] and abs(places[0] - places[1]) < 1,
      "a list that is inserted above a slider does not move it", (inserted, places))

# the plan stands still while the tools come and go
for size in ("1280x720", "1920x1080"):
    states = stage.act(f"still-{size}", "until answered", "pause", "wait 3", "state STATE", "key Ctrl+J", "wait 4",
                       "state STATE", "key Ctrl+J", "wait 4", "state STATE", arguments=[FILES["house"], "--size", size])
    moved = [abs(a - b) for state in states[1:] for p, q in zip(states[0]["floor"], state["floor"]) for a, b in zip(p, q)]
    check(states[1]["frame"]["view"][0] > states[0]["frame"]["view"][0] and max(moved) < 0.5,
          f"{size}: the plan stands still while the tools open and close", [s["floor"] for s in states])

# folds are remembered by task, from one start to the next: F6 twice is the panel, Return closes its first fold
PLACE = "washroom door"


def is_shown(texts, word):
    return any(t["string"] == word and t["box"][3] > t["clip"][1] and t["box"][1] < t["clip"][3] for t in texts)


lines = ["until answered", "pause", "wait 3", "texts STATE"]
before = stage.act("folds", *lines, "click 1020 118", "wait 4", "texts STATE", "key Ctrl+J", "wait 4", "texts STATE",
                   arguments=[FILES["house"], "--size", "1280x720"])
places = [is_shown([t for t in texts if t["box"][0] > 976], PLACE) for texts in before]
check(places == [True, False, True], "a fold that was closed while watching is open while editing", places)
(stage.folder / "folds" / "states").unlink()
after = stage.act("folds", *lines, arguments=[FILES["house"], "--size", "1280x720"])
check(not is_shown([t for t in after[0] if t["box"][0] > 976], PLACE), "and is closed at the next start")
stage.end()
