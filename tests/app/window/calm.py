#!/usr/bin/env python3
"""Tests the calm window by what is seen: space, labels, one run at a time, menus, messages and words, at 1280x720 and
1920x1080. The numbers are those of the window's acceptance checks."""

import itertools
import json
import re

import stage
from stage import act, check, differing

HOUSES = ["ube-techno-house", "flat-0.910-module", "flat-0.910-widened", "corner-0.90-0.90", "bedroom-after-earthquake",
          "closed-door", "two-chairs-corridor", "straight-corridor"]


def width(box):
    return box[2] - box[0]


def overlap(a, b):
    return a[0] < b[2] - 0.5 and b[0] < a[2] - 0.5 and a[1] < b[3] - 0.5 and b[1] < a[3] - 0.5


# 1, 2: the view is large, and a larger screen shows more
small, edits = act("space", "until complete", "wait 3", "state STATE", "key Ctrl+J", "wait 3", "state STATE",
                   arguments=["--size", "1280x720"])
large = act("large", "until complete", "wait 3", "state STATE", arguments=["--size", "1920x1080"])[0]
check(width(small["frame"]["view"]) >= 0.70 * 1280, "1: the view has 70 % of the width", small["frame"])
check(width(edits["frame"]["view"]) >= 0.65 * 1280 and edits["editing"], "1: while editing 65 %", edits["frame"])
check(width(large["frame"]["view"]) >= 0.50 * 1920 and large["frame"]["plots"], "2: Full HD has plots beside it",
      large["frame"])
check(len(large["frame"]["plots"]) == 3, "2: Full HD has three plots", large["frame"]["plots"])
largest = act("largest", "until complete", "wait 3", "state STATE", arguments=["--size", "3840x2160"])[0]
check(len(largest["frame"]["plots"]) == 4 and width(largest["frame"]["view"]) >= 0.50 * 3840, "2: 3840x2160 has four plots",
      largest["frame"])
stuck = act("stuck", "until answered", "wait 5", "state STATE", "key Shift+P", "wait 5", "state STATE",
            arguments=[stage.house("flat-0.910-module"), "--size", "1920x1080"])
check(not stuck[0]["frame"]["plots"] and stuck[1]["frame"]["plots"], "2: plots without data open only when they are asked for",
      [state["frame"]["plots"] for state in stuck])
check(abs(large["unit"] - 1.22) < 0.01, "2: a point of Full HD is 1.22 pixels", large["unit"])
check(len(large["text_in_view"]) > len(small["text_in_view"]), "2: Full HD shows more names",
      (len(large["text_in_view"]), len(small["text_in_view"])))

# the grade follows the time as soon as it is known
timed, graded = act("graded", "until complete", "pause", "state STATE", "until idle", "state STATE",
                    arguments=[stage.house("flat-0.910-widened"), "--size", "1280x720"])
check(graded["answer"]["title"] == "Out in 22.6 s, grade D" and graded["answer"]["detail"].startswith("touching likely; "),
      "nobody is out without a grade", graded["answer"])
check(timed["answer"]["title"] in ("Out in 22.6 s", graded["answer"]["title"]), "the time is told first",
      timed["answer"])

# 3, 4, 12, 28: labels of every house
for name in HOUSES:
    if not (stage.source / "houses" / f"{name}.json").exists():
        continue
    found = act(f"labels-{name}", "until answered", "pause", "seek 2", "wait 4", "state STATE", "seek 6", "wait 4",
                "state STATE", "key V", "wait 4", "state STATE",
                arguments=[stage.house(name), "--size", "1280x720"])
    for moment, state in zip(("2 s", "6 s", "raised"), found):
        texts, view = state["text_in_view"], state["frame"]["view"]
        discs = [t for t in texts if t["kind"] != "disc" or not t["string"].isalpha()]
        pairs = [(a["string"], b["string"]) for a, b in itertools.combinations(discs, 2) if overlap(a["box"], b["box"])]
        if moment != "raised" or name == "flat-0.910-module":
            check(not pairs, f"3: {name}, {moment}: no two texts overlap", pairs)
        out = [t["string"] for t in texts if not (view[0] <= t["box"][0] and t["box"][2] <= view[2]
                                                  and view[1] <= t["box"][1] and t["box"][3] <= view[3])]
        check(not out, f"3: {name}, {moment}: none leaves the view", out)
        names = [t for t in texts if t["kind"] == "name" and not t["string"].endswith(" m")]
        area = width(view) * (view[3] - view[1])
        check(len(names) <= area / 30000, f"3: {name}, {moment}: not too many names", len(names))
        longest = 80 if moment == "raised" else 40
        far = [t["string"] for t in texts if max(t["box"][0] - t["pointed"][0], t["pointed"][0] - t["box"][2],
                                                 t["box"][1] - t["pointed"][1], t["pointed"][1] - t["box"][3]) > longest]
        check(not far, f"4: {name}, {moment}: no label is far from its thing", far)
    state = found[0]
    cells = [row[0] for row in state["rows"]]
    check(len(set(cells)) == len(cells) or any(" wall of " in cell for cell in cells) or len(cells) > 12, f"12: {name}: nothing stands twice", cells)
    words = [t["string"] for t in state["text_in_view"]] + [c for row in state["rows"] for c in row]
    words += [state["answer"]["title"], state["answer"]["detail"] or ""]
    wrong = [w for w in words if re.search(r"-chair|p-[a-d]|\bd[0-9]+\b|xref|ghost|locus", w)]
    check(not wrong, f"28: {name}: no internal word", wrong)
    detail = re.search(r"most time lost: (.*), [0-9.]+ s", state["answer"]["detail"] or "")
    if detail:
        first = next(row for row in state["rows"][1:] if row[2])
        check(first[0] == detail.group(1) and first[2] in state["answer"]["detail"],
              f"12: {name}: the headline's place is the first row", (first, state["answer"]["detail"]))

    check("wall" not in cells, f"12: {name}: a wall is named by its room", cells)

# 5: each door in turn by Tab: its label stands at its own opening
def openings(house):
    """Returns the middle of each door's opening, m."""
    plan, found = json.loads(open(stage.house(house)).read()), {}
    walls = {wall["id"]: wall["points"] for wall in plan["walls"]}
    for door in plan.get("doors", []):
        a, b = walls[door["wall"]][door.get("segment", 0):][:2]
        length = ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5
        found[door["id"]] = [a[i] + (b[i] - a[i]) * door["at"] / length for i in (0, 1)]
    return found


def pixel(state, at):
    origin, right, up = state["floor"]
    return [origin[i] + at[0] * (right[i] - origin[i]) + at[1] * (up[i] - origin[i]) for i in (0, 1)]


def distance(box, at):
    return max(box[0] - at[0], at[0] - box[2], box[1] - at[1], at[1] - box[3], 0)


for name in ("ube-techno-house", "flat-0.910-module"):
    places = openings(name)
    found = act(f"doors-{name}", "until answered", "pause", "wait 4", *(["key Tab", "wait 3", "state STATE"] * 30),
                arguments=[stage.house(name), "--size", "1280x720"])
    named = {}
    for state in found:
        door = (state["selected"] or "").removeprefix("door ")
        if door in places and door not in named:
            labels = [t for t in state["text_in_view"] if t["kind"] == "selected"]
            near = [(distance(t["box"], pixel(state, places[door])), t) for t in labels]
            named[door] = min(near, key=lambda pair: pair[0]) if near else None
            if named[door]:
                box = named[door][1]["box"]
                others = [distance(box, pixel(state, at)) for other, at in places.items() if other != door]
                check(named[door][0] <= 24 and named[door][0] < min(others, default=1e9),
                      f"5: {name}: the label of door {door} stands at its opening", (named[door], min(others, default=0)))
    check(len(named) == len(places), f"5: {name}: Tab reaches all doors", sorted(set(places) - set(named)))
    unnamed = [door for door, label in named.items() if label is None]
    check(not unnamed, f"5: {name}: doors are named while they are selected", unnamed)

# a crowd is told by when most are out, and its people by their words
crowd = stage.folder / "crowd.json"
crowd.write_text(json.dumps({
    "format": "clearance-house", "version": 1, "name": "hall",
    "walls": [{"id": "w1", "points": [[8, 2], [8, 0], [0, 0], [0, 8], [8, 8], [8, 4]], "thickness": 0.12}],
    "exits": [{"id": "e1", "from": [8, 2], "to": [8, 4]}],
    "people": [{"id": "chair", "profile": "manual-chair", "at": [1, 1], "heading": 0}] +
              [{"id": f"n{i}", "profile": "adult", "at": [2 + i % 8 * 0.7, 1.5 + i // 8 * 0.9], "heading": 0}
               for i in range(40)]}))
state, early, end = act("crowd", "until answered", "wait 5", "state STATE", "pause", "seek 4", "wait 5", "state STATE",
                        "seek 1000", "wait 5", "state STATE", arguments=[crowd, "--size", "1280x720"])
told = re.match(r"95 % out in ([0-9.]+) s \u00b7 ", state["answer"]["detail"] or "")
last = re.search(r"in ([0-9.]+) s", state["answer"]["title"])
check(told and last and float(told.group(1)) <= float(last.group(1)), "a crowd: when 95 % are out, and when all",
      state["answer"])
check(["wheelchair", "adult"] == [row[0] for row in state["rows"] if "/" in row[1]], "a crowd: kinds by their words",
      state["rows"])


# 27: how many are out now, at each exit; the plots open by themselves, and the line of time marks half, 95 % and all
def out_now(state):
    return {row[0]: [int(word) for word in row[1].split(" of ")] for row in state["rows"] if row[1] and " of " in row[1]}


check(state["frame"]["plots"].keys() == {"out", "flow"}, "27: the plots of a crowd open by themselves", state["frame"]["plots"])
for name, moment in (("at 4 s", early), ("at the end", end)):
    now = out_now(moment)
    everybody = now.pop("out", [0, 0])
    check(everybody[1] == 41 and sum(n[0] for n in now.values()) == everybody[0] > 0,
          f"27: {name}: the exits' numbers add up to all who are out", (everybody, now))
    drawn = sum(int(t["string"].split(": ")[1]) for t in moment["text_in_view"] if t["string"].startswith("EXIT") and ":" in t["string"])
    check(drawn in (0, everybody[0]), f"27: {name}: and equal those in the picture", (drawn, everybody))
check(everybody == [41, 41], "27: at the end all are out", everybody)
exits = state["ticks"]
check(len(exits) == 3 and abs(exits[1] - float(told.group(1))) < 0.06, "27: half, 95 % and all are marked", exits)

# 9, 10, 11: a change during a run
lines = []
for step in range(40):
    lines += ["state STATE", "wait 1"]
found = act("change", "until complete", "seek 5", "play", "wait 5", "state STATE", "set door.d7.width 0.7", *lines,
            "until complete", "wait 5", "state STATE", arguments=["--size", "1280x720"])
before, after = found[0], found[-1]
times = [s["time"] for s in found[1:-1] if s["runs"]["working"]]
for state in found:
    runs = state["runs"]
    check(runs["answer"] == runs["picture"] == runs["rows"] == runs["plots"],
          "9: headline, picture, rows and plots are of one run", runs)
    check(not state["answer"]["grey"] or (runs["working"] and "working it out" in state["answer"]["doing"]),
          "10: a grey headline says what is being done", state["answer"])
    check(not state["answer"]["grey"] or state["time"] == 0, "9: nobody moves while it is worked out", state["time"])
check(len(set(times)) <= 2, "9: the clock stands or begins anew while it is worked out", times)
check(after["runs"]["answer"] != before["runs"]["answer"], "9: then another run is shown")
found = act("end", "until complete", "seek 1000", "wait 3", "key R", "wait 5", "state STATE")
check(found[0]["playing"] and found[0]["time"] < 5, "7: R after the end runs it again", (found[0]["playing"], found[0]["time"]))

# 13: menus by a real mouse
screen = stage.Screen("menus")
state = screen.until(lambda s: s.get("complete") and s["time"] > 0.3)
screen.keys("space")
frame = state["frame"]
closed = screen.shot("closed")
screen.click(74, 15)
opened = screen.state()
check(opened["sheet"] == "menu" and opened["menu"] == "Edit", "13: a click opens the menu below the word", opened["sheet"])
beside = [700, 100, 1270, 620]
check(differing(closed, screen.shot("opened"), beside) == 0, "13: nothing else is dimmed or changed")
screen.point_to(126, 15)
check(screen.state()["menu"] == "View", "13: the pointer on another word opens its menu", screen.state().get("menu"))
screen.keys("Right")
check(screen.state()["menu"] == "Run", "13: Right opens the next while the pointer rests on a word", screen.state().get("menu"))
screen.keys("Left")
check(screen.state()["menu"] == "View", "13: and Left the one before", screen.state().get("menu"))
screen.point_to(640, 400)
selected = screen.state()["selected"]
screen.click(300, 600)
now = screen.state()
check(now["sheet"] == "none" and now["selected"] == selected, "13: a click outside only closes it", now["selected"])
screen.point_to(126, 15)
screen.press()
check(screen.state()["sheet"] == "menu", "13: a press opens it")
screen.point_to(200, 30 + 6 + 28 * 9 + 2 * 9 + 14)  # nine rows and the lines of two groups above it
screen.release()
now = screen.until(lambda s: s["sheet"] == "none")
check(now["sheet"] == "none" and width(now["frame"]["panel"]) == 0, "13: press, drag, release chooses a row",
      (now["sheet"], now["frame"]["panel"]))
screen.keys("h")

# 16: messages stand in the strip
view = [0, 94, 970, 636]
screen.point_to(1270, 700)
screen.until(lambda s: not s["answer"]["doing"] and not s["answer"]["grading"])  # what is worked out comes into the picture
quiet = screen.shot("quiet")
screen.keys("n")
said = screen.until(lambda s: s["message"] and "napping" in s["message"])
shown = screen.shot("said")  # once: a note stays for some seconds only
check(differing(quiet, shown, view) == 0, "16: a message lies over nothing", said["message"])
check(differing(quiet, shown, said["frame"]["strip"]) > 50, "16: it stands in the strip")
screen.end()

# 6: letters and the headline's capitals; 7: contrast of what is written, on both themes
for theme in ("paper", "board"):
    state = act(f"contrast-{theme}", "until answered", "pause", "wait 5", "state STATE", "picture FOLDER/shot.png",
                arguments=["--size", "1280x720", "--theme", theme])[0]
    shot = stage.folder / f"contrast-{theme}" / "shot.png"
    check(all(t["size"] >= 13 for t in state["text_in_view"] if t["kind"] == "disc") and
          all(t["size"] >= 16 for t in state["text_in_view"] if t["kind"] != "disc"), f"6: {theme}: letters can be read",
          [(t["string"], t["size"]) for t in state["text_in_view"]])
    poor = []
    for text in state["text_in_view"]:
        seen = stage.colours(shot, text["box"])
        most = max(stage.contrast(seen[0][1], other) for _, other in seen[:60])
        if most < 4.5:
            poor.append((text["string"], most))
    check(not poor, f"7: {theme}: what is written in the view has a contrast of 4.5", poor)
for key, least, box in (("F24", 29, [0, 32, 290, 90]), ("F5", 42, [0, 4, 430, 108])):
    act(f"capitals-{key}", "until answered", "pause", *(["key F5"] if key == "F5" else []), "wait 5",
        "picture FOLDER/shot.png", arguments=["--size", "1280x720"])
    shot = stage.folder / f"capitals-{key}" / "shot.png"
    height = stage.magick("convert", str(shot), "-crop", stage.crop(box), "+repage", "-trim", "-format", "%h", "info:").stdout
    check(int(height) >= least, f"6: capitals of the headline are {least} pixels high", height)

# 6, 11: presenting, a long detail takes nothing from the headline; the strip names four keys at most, and the card of all
state = act("capitals-long", "until answered", "until idle", "pause", "key F5", "wait 5", "picture FOLDER/shot.png", "state STATE",
            arguments=[stage.house("flat-0.910-module"), "--size", "1280x720"])[0]
shot = stage.folder / "capitals-long" / "shot.png"
answer = state["frame"]["answer"]
head = [answer[0], answer[1] + 2, answer[0] + 60, answer[1] + 0.68 * (answer[3] - answer[1])]
height = stage.magick("convert", str(shot), "-crop", stage.crop(head), "+repage", "-trim", "-format", "%h", "info:").stdout
check(int(height) >= 42, "6: presenting, capitals of a long headline are 42 pixels high, too", height)
for name, keys in (("watching", []), ("editing", ["key Ctrl+J"]), ("beam", ["laboratory beam", "until answered"])):
    state = act(f"strip-{name}", "until answered", "pause", *keys, "wait 4", "state STATE")[0]
    check(len(state["strip_keys"]) <= 4 and "F1" in state["strip_keys"], f"{name}: the strip names four keys at most",
          state["strip_keys"])
    check(name == "editing" or "F4" in state["strip_keys"], f"{name}: it names the gallery", state["strip_keys"])

# 6: text of another size is there the next time
for keys, size in ((["key Ctrl+-"], 0.75), (["key Ctrl+0", "key Ctrl+="], 1.25), (["key Ctrl+="] * 3, 2)):
    act("text-size", "until answered", "pause", *keys, "wait 5", arguments=["--size", "1280x720"])
    state = act("text-size", "until answered", "pause", "wait 5", "state STATE", arguments=["--size", "1280x720"])[-1]
    check(abs(state["unit"] - size) < 0.01, f"6: a text size of {size:.0%} is there the next time", state["unit"])

# 28: the numbers of a person and of a comparison have the window's words
state = act("words", "until answered", "key Tab", "wait 4", "state STATE", arguments=[stage.house("corner-0.90-0.90")])[0]
cells = {row[0] for row in state["rows"]}
check({"touches", "hardest touch", "least room to spare"} <= cells and not cells & {
      "contacts", "hardest contact", "narrowest clearance", "dangerous points", "personal space entered"},
      "28: the panel says touches and room to spare", cells)
shown = {row[0]: row[1] for row in state["rows"]}
check(re.fullmatch(r"[0-9]+\.[0-9] cm|over [0-9]+\.[0-9] cm|touches", shown["least room to spare"]) and
      re.fullmatch(r"[0-9]+\.[0-9] s", shown["time"]), "the panel gives gaps in centimetres and times with one digit", shown)

# 30: while it runs, no label moves but those of people
steps = []
for _ in range(12):
    steps += ["wait 8", "state STATE"]
found = act("still", "until complete", "seek 0", "play", *steps, arguments=["--size", "1280x720"])
labels = [{t["string"]: t["box"] for t in s["text_in_view"] if len(t["string"]) > 1 or not t["string"].isalpha()}
          for s in found]
moved = {name for state in labels for name in state if labels[0].get(name) != state[name]}
check(found[-1]["time"] > found[0]["time"] and not moved, "30: no label moves or comes while it runs", moved)

# a name at the pointer; Return on a selection goes to its number; presentation mode shows one danger, ring and key
found = act("hover", "until answered", "pause", "mouse 270 235", "wait 3", "state STATE", "click 430 298", "wait 3",
            "key Return", "wait 5", "state STATE", "key Escape", "key Escape", "wait 2", "key F5", "wait 5", "mouse 640 330",
            "key V", "wait 2", "state STATE", arguments=["--size", "1280x720"])
check(found[0]["hovered"], "the thing under the pointer is named", found[0]["hovered"])
check(".width" in (found[1]["focus_help"] or ""), "Return on a selected door goes to its width", found[1]["focus_help"])
discs = [t["string"] for t in found[2]["text_in_view"] if t["kind"] == "disc" and t["string"].isdigit()]
check(len(discs) <= 1 and found[2]["echo"].startswith("V "), "presenting: one danger, and the key is named",
      (discs, found[2]["echo"]))

# Escape leaves a presentation, and nothing moves; what is chosen goes first
kept = act("leave", "until answered", "pause", "seek 3", "key F5", "wait 5", 'select "door d7"', "wait 3", "key Escape", "wait 3",
           "state STATE", "key Escape", "wait 3", "state STATE", arguments=["--size", "1280x720"])
check([state["present"] for state in kept] == [True, False] and kept[0]["time"] == kept[1]["time"], "Escape leaves a presentation",
      [(state["present"], state["time"]) for state in kept])

# presenting, nothing lies over the plan: a note is kept by F7
texts = act("quiet", "until answered", "pause", "key F5", "wait 5", "key 7", "wait 5", "texts STATE", arguments=["--size", "1280x720"])[0]
said = [t["string"] for t in texts if "names: " in t["string"]]
check(len(said) == 1 and said[0].startswith("7   names: "), "presenting: the key is named with what it did, and no message lies over the plan", said)

# 25: the beam at 720 lines has two plots, and choices of many words are listed below a button
found = act("pulled", "until answered", "wait 20", "mouse 1100 400", "wheel -30", "wait 4", "click 1080 502", "wait 4",
            "wheel -3", "wait 4", "state STATE", "click 1128 499", "wait 4", "click 1128 567", "wait 4", "state STATE",
            arguments=[stage.beam("ibs"), "--size", "1280x720"])
check(found[0]["frame"]["plots"].keys() == {"phase", "orbit"}, "25: the beam has two plots", found[0]["frame"]["plots"])
check([state["choices"]["Rhythms over"] for state in found] == ["shaker frequency", "shaker force"],
      "25: a click opens the list, a click in it chooses", [state["choices"] for state in found])

# 26: presentation mode
for name in HOUSES[:3]:
    for size in ("1280x720", "1024x768"):
        state = act(f"present-{name}-{size}", "until answered", "key F5", "wait 5", "state STATE",
                    arguments=[stage.house(name), "--size", size])[0]
        check(width(state["frame"]["panel"]) == 0 and state["frame"]["menu"][3] == 0, f"26: {name}, {size}: only the picture")
        check(all(t["size"] >= (22 if t["kind"] == "name" and size == "1280x720" else 16) for t in state["text_in_view"]), f"26: {name}, {size}: letters can be read")
state = act("present-beam", "until answered", "pause", "key F6", "key F5", "wait 5", "picture FOLDER/shot.png",
            "state STATE", arguments=[stage.beam("ibs"), "--size", "1280x720"])[0]
notes = [t["string"] for t in state["text_in_view"] if t["string"].startswith(("stops", "deflection", "beam "))]
check(state["text_in_view"] and not notes and all(14 <= t["box"][0] and t["box"][2] <= 1266 for t in state["text_in_view"]),
      "26: a machine has no notes, and its words keep off the edges", (notes, state["text_in_view"]))
view = state["frame"]["view"]
edge = stage.colours(stage.folder / "present-beam" / "shot.png", [view[0], view[1] + 20, view[0] + 6, view[3] - 20])
check(state["focus"] == "view" and len(edge) == 1, "26: the picture has no frame of the focus", (state["focus"], edge))
stage.end()
