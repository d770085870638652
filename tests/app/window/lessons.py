#!/usr/bin/env python3
"""Tests lessons in the window: a house and a beam from the first card to the last by real keys, in presentation mode at
1280 x 720, the wrong way first and then the right one; guesses, a second vote, going back, hints, leaving; and that
nothing of the result can be seen before the class has guessed."""

import json
import shutil

import stage
from classroom import apart, judged, lesson, select, step, type_number
from stage import Screen, act, check, differing

# a house, from the first card to the last
screen = Screen("house", lesson("legal-no-way"), "--size", "1280x720")
screen.keys("F5")
now = screen.until(lambda s: s["present"] and not s["answer"]["stale"])
check(now["lesson"]["step"] == 1 and now["lesson"]["steps"] == 6, "the lesson begins at its first step", now["lesson"])
frame = now["frame"]
check(apart([frame[name] for name in ("answer", "card", "view", "timeline")]),
      "the card covers neither the answer nor the view nor the timeline", frame)
screen.keys("Next")
now = step(screen, 2)
check(now["lesson"]["hides"] and not now["playing"], "nothing plays while the class guesses")
screen.keys("space")
check(screen.state()["time"] == 0, "Play does not play before the guess")
told = [screen.tool("getwindowname", screen.window).stdout]
for _ in range(12):
    screen.keys("Tab")
    now = screen.state()
    told += [now["focus_help"] or "", now["selected"] or "", now["hovered"] or ""]
    told += [text["string"] for text in now["text_in_view"]]
for _ in range(8):
    screen.keys("F6")
    told.append(screen.state()["focus_help"] or "")
left, top, right, bottom = now["frame"]["view"]
for i in range(1, 6):
    screen.point_to(left + (right - left) * i / 6, top + (bottom - top) * 0.33)
    now = screen.state()
    told += [now["hovered"] or "", now["focus_help"] or ""]
check(not [text for text in told for word in ("cannot", "bedroom door", "0.82", "tight", "under") if word in text],
      "neither text, title, tooltip nor Tab tells the result", told)
while screen.state()["focus"] != "view":
    screen.keys("F6")
screen.keys("1", "1", "2", "3")
check(screen.state()["lesson"]["hands"] == [2, 1, 1], "1 1 2 3 counts 2 1 1", screen.state()["lesson"])
screen.keys("3", "3")
check(screen.state()["lesson"]["hands"] == [2, 1, 3], "number keys count hands", screen.state()["lesson"])
screen.keys("BackSpace")
check(screen.state()["lesson"]["hands"] == [2, 1, 2], "Backspace takes one back")
screen.keys("0", "3", "3", "1")
now = screen.state()["lesson"]
check(now["vote"] == 2 and now["hands"] == [1, 0, 2], "0 begins a second vote", now)
screen.keys("Next")
now = step(screen, 3)
check(now["lesson"]["hides_words"], "what was seen is asked before the answer says it")
screen.keys("2")
screen.keys("1")
check(screen.state()["lesson"]["chosen"] == 1 and not screen.state()["lesson"]["hides_words"], "a wrong answer can be mended")
screen.keys("Next")
now = screen.until(lambda s: s["lesson"]["step"] == 4 and judged(s))
check(now["lesson"]["goal"] == "no", "the task begins unsolved", now["lesson"])
check(select(screen, "door d1"), "Tab comes to the entrance door")
now = type_number(screen, "0.98")
check(now["lesson"]["goal"] == "no" and now["parameters"]["door.d1.width"] == 0.98,
      "the obvious way, a wider entrance, does not reach the goal", (now["lesson"], now["parameters"].get("door.d1.width")))
screen.keys("question", "question", "question")
check(screen.state()["lesson"]["hints"] == 3, "? shows three hints, one after another", screen.state()["lesson"])
screen.keys("ctrl+z")
screen.until(lambda s: s["parameters"]["door.d1.width"] != 0.98 and judged(s))
check(select(screen, "door d3"), "Tab comes to the bedroom door")
now = type_number(screen, "0.83")
check(now["lesson"]["goal"] == "yes", "the right door reaches the goal", (now["lesson"], now["answer"]))
wide = now["digest"]
screen.keys("Next")
step(screen, 5)
screen.keys("ctrl+z")
now = screen.until(lambda s: s["parameters"]["door.d3.width"] != 0.83 and not s["answer"]["stale"])
screen.keys("Prior")
now = screen.until(lambda s: s["lesson"]["step"] == 4 and judged(s))
check(now["parameters"]["door.d3.width"] == 0.83 and now["lesson"]["goal"] == "yes" and now["digest"] == wide,
      "going back restores the house as the step was left", (now["parameters"]["door.d3.width"], now["lesson"]))
screen.keys("Prior")
now = screen.until(lambda s: s["lesson"]["step"] == 3 and s["parameters"]["door.d3.width"] != 0.83)
check(now["parameters"]["door.d3.width"] != 0.83, "and the one before that, too", now["parameters"]["door.d3.width"])
screen.keys("Next")
step(screen, 4)
screen.keys("Next")
step(screen, 5)
screen.keys("Next")
check(screen.until(lambda s: s["lesson"]["model"])["lesson"]["step"] == 5, "a model answer comes before the next step")
screen.keys("Next")
check(step(screen, 6)["lesson"]["step"] == 6, "the last card is reached")
screen.keys("Escape")
screen.until(lambda s: s["sheet"] == "lesson" or not s["selected"])
while screen.state()["sheet"] != "lesson":
    screen.keys("Escape")
screen.keys("Escape")
check(screen.until(lambda s: s["sheet"] == "none")["lesson"], "Escape asks before the lesson is left, and again returns to it")
screen.keys("Next")
screen.until(lambda s: s["sheet"] == "lesson")
screen.keys("Tab", "Return")
check(not screen.until(lambda s: not s["lesson"])["lesson"], "the question is answered by keys, and the lesson ends")
screen.end()

# the card folds to a line by key and mouse; nothing is lost by it, or by another file
screen = Screen("folding", lesson("legal-no-way"), "--size", "1280x720")
fold = lambda now: (now["frame"]["card"][2] - 27 * now["unit"], now["frame"]["card"][1] + 20 * now["unit"])
screen.keys("Next", "1", "1", "3")
whole = step(screen, 2)
screen.keys("c")
now = screen.until(lambda s: s["lesson"]["folded"])
frame = now["frame"]
check(now["lesson"]["hands"] == [2, 0, 1] and frame["card"][3] - frame["card"][1] < 60 and
      apart([frame[name] for name in ("answer", "card", "view", "timeline")]), "C folds the card to a line", frame)
check(frame["view"][2] - frame["view"][0] > 1.4 * (whole["frame"]["view"][2] - whole["frame"]["view"][0]),
      "the view takes its place", (frame["view"], whole["frame"]["view"]))
screen.keys("2")
check(screen.state()["lesson"]["hands"] == [2, 1, 1], "hands are counted while it is folded")
screen.click(frame["card"][2] - 190, (frame["card"][1] + frame["card"][3]) / 2)
now = screen.until(lambda s: not s["lesson"]["folded"])
check(not now["lesson"]["folded"] and now["lesson"]["hands"] == [2, 1, 1], "the mouse unfolds it", now["lesson"])
screen.click(*fold(now))
check(screen.until(lambda s: s["lesson"]["folded"])["lesson"]["folded"], "and folds it")
screen.keys("F5")
now = screen.until(lambda s: s["present"])
check(now["lesson"]["folded"], "in presentation mode, too")
screen.click(now["frame"]["card"][2] - 80 * now["unit"], (now["frame"]["card"][1] + now["frame"]["card"][3]) / 2)
now = step(screen, 3)
check(now["lesson"]["step"] == 3 and now["lesson"]["folded"], "the line's button goes on", now["lesson"])
screen.keys("1", "Next")
now = screen.until(lambda s: s["lesson"]["step"] == 4 and judged(s))
check(select(screen, "door d3"), "Tab selects while it is folded")
now = type_number(screen, "0.83")
check(now["lesson"]["goal"] == "yes" and now["lesson"]["folded"], "and a task is solved", now["lesson"])
screen.keys("c", "F5")
screen.until(lambda s: not s["lesson"]["folded"] and not s["present"])
screen.keys("ctrl+z")
screen.until(lambda s: not s["unsaved"] and judged(s))
screen.keys("ctrl+n")
now = screen.until(lambda s: s["sheet"] == "none" and not s["lesson"])
check(not now["lesson"] and now["title"] != "flat on the 0.910 module", "a new house asks nothing: the guesses are kept",
      now["title"])
screen.keys("ctrl+l")
screen.until(lambda s: s["sheet"] == "gallery" and s["focus"] == "sheet")
screen.keys("Tab", "Return")  # the same lesson
now = screen.until(lambda s: s["sheet"] == "kept")
check(now["sheet"] == "kept", "the same lesson offers to go on with them", now["sheet"])
screen.keys("Return")
now = screen.until(lambda s: s["sheet"] == "none" and s["lesson"]["step"] == 4)
check(now["lesson"]["step"] == 4 and not now["lesson"]["hides"], "and goes on at the task", now["lesson"])
screen.keys("Prior", "Prior")
now = step(screen, 2)
check(now["lesson"]["hands"] == [2, 1, 1], "with the hands of the class", now["lesson"])
screen.end()

# lessons over an edited plan, and one after the other: what would be lost is asked about
screen = Screen("over", stage.house("straight-corridor"), "--size", "1280x720")
check(select(screen, "person p1") or screen.state()["selected"], "something is selected")
screen.keys("Up")
screen.until(lambda s: s["unsaved"])
screen.keys("ctrl+l")
screen.until(lambda s: s["sheet"] == "gallery" and s["focus"] == "sheet")
screen.keys("Tab", "Return")  # the second one, of a house
check(screen.until(lambda s: s["sheet"] != "gallery")["sheet"] == "leave", "a lesson asks before it takes an edited plan's place")
screen.keys("Tab", "Return")
now = screen.until(lambda s: s["lesson"])
check(now["lesson"]["title"] == "Legal, and yet no way out" and not now["unsaved"], "then it begins", now["lesson"])
screen.keys("Next")
step(screen, 2)
screen.keys("3", "ctrl+l")
screen.until(lambda s: s["sheet"] == "gallery" and s["focus"] == "sheet")
screen.keys("Return")  # the first one, of a beam
now = screen.until(lambda s: s["sheet"] == "none" and s["lesson"] and s["lesson"]["step"] == 1)
check(now["laboratory"] == "beam" and now["lesson"]["hands"] == [], "another lesson takes its place: the guesses are kept", now["lesson"])
screen.end()

# a beam
screen = Screen("beam", lesson("half-the-rhythm"), "--size", "1280x720")
screen.keys("F5")
screen.keys("Next")
step(screen, 2)
screen.keys("1", "2", "2")
check(screen.state()["lesson"]["hands"] == [1, 2], "hands are counted for a beam", screen.state()["lesson"])
check(not screen.state()["frame"]["plots"], "no plot tells the result")
screen.keys("Next")
now = screen.until(lambda s: s["lesson"]["step"] == 3 and s["playing"])
check(now["playing"] and now["frame"]["plots"], "the beam plays, with plots", now["frame"])
screen.keys("1")
screen.keys("Next")
now = screen.until(lambda s: s["lesson"]["step"] == 4 and judged(s))
check(now["lesson"]["goal"] == "no", "at 112 Hz there is no period 2")
now = type_number(screen, "103")
check(now["lesson"]["goal"] == "no" and now["parameters"]["drive.frequency"] == 103, "irregular motion is not enough",
      (now["lesson"], now["parameters"]["drive.frequency"]))
now = type_number(screen, "105.5")
check(now["lesson"]["goal"] == "yes", "105.5 Hz reaches the goal", now["lesson"])
screen.keys("Next")
step(screen, 5)
screen.keys("Prior")
now = screen.until(lambda s: s["lesson"]["step"] == 4 and judged(s))
check(now["parameters"]["drive.frequency"] == 105.5 and now["lesson"]["goal"] == "yes", "the beam is as it was left")
screen.keys("Prior")
now = step(screen, 3)
check(now["parameters"]["drive.frequency"] == 112, "and as the step before was left", now["parameters"]["drive.frequency"])
screen.keys("Next")
now = screen.until(lambda s: s["lesson"]["step"] == 4 and judged(s))
screen.keys("Next", "Next")
screen.keys("Next")
check(step(screen, 6)["lesson"]["step"] == 6, "the last card of the beam is reached")
screen.end()

# nothing of the result is painted before the guess: the hidden picture is that of a house without a result
lines = ("until answered", "wait 3", "state STATE", "view FOLDER/before.png", "key PageDown", "wait 3",
         "view FOLDER/guess.png", "key 3", "wait 3", "view FOLDER/counted.png", "key PageDown", "until answered", "wait 3",
         "key 1", "wait 3", "view FOLDER/after.png", "state STATE")
found = act("hidden", *lines, arguments=[lesson("legal-no-way"), "--size", "1280x720"])
place = stage.folder / "hidden"
check(differing(place / "guess.png", place / "counted.png") == 0, "counting changes nothing in the view")
check(differing(place / "before.png", place / "after.png") > 200, "the result is seen only after the guess")
check(found[0]["frame"]["panel"][2] - found[0]["frame"]["panel"][0] == 0, "the panel tells nothing before the guess")

# a step is started again, what is locked is put back, and what a step names has a frame
short = stage.folder / "short.json"
task = {"kind": "task", "text": "Do it.", "hints": ["a", "b", "c"], "done": "Done.",
        "goal": [{"measure": "time", "unit": "s", "high": 900}]}
short.write_text(json.dumps({"format": "clearance-lesson", "version": 1, "title": "Short", "laboratory": "house", "level": "all",
                             "file": stage.house("corner-1.80-1.80"), "script": "none", "lock": ["people"],
                             "steps": [{"kind": "read", "text": "A.", "mark": ["person p1", "answer"], "show": "person p1"},
                                       task, {"kind": "explain", "ask": "Why?", "model": "So."}],
                             "teacher": {"before": []}}))
first, begun, changed, again, held, undone, later, earlier, freed = act(
    "restart", "until answered", "wait 3", "state STATE", "key PageDown", "until answered", "state STATE",
    "key Tab", "wait 3", "texts FOLDER/texts", "wait 2", "set run.until 50", "until answered", "state STATE", "key Ctrl+R", "until answered", "wait 3", "state STATE",
    "set person.p1.heading 5", "wait 3", "until answered", "state STATE", "set run.until 60", "until answered",
    "key PageDown", "wait 2", "key Ctrl+Z", "wait 2", "set person.p1.heading 5", "wait 3", "until answered", "state STATE",
    "key Ctrl+R", "wait 2", "until answered", "key PageUp", "wait 2", "key PageDown", "wait 2", "key Ctrl+R", "wait 2", "key PageUp", "wait 2", "until answered", "state STATE",
    "key Ctrl+R", "wait 2", "until answered", "state STATE", "key Ctrl+U", "set person.p1.heading 5", "wait 3",
    "until answered", "state STATE", arguments=[short, "--size", "800x450"])
check(first["lesson"]["framed"] == 2 and begun["lesson"]["framed"] == 0, "what the step names has a frame", first["lesson"])
labels = (stage.folder / "restart" / "texts").read_text()
check("Numbers: " in labels, "the card has a button for the numbers of what is selected",
      [text["string"] for line in labels.splitlines() for text in json.loads(line)])
check(first["zoom"] > 1.5 > begun["zoom"], "what it shows is near", (first["zoom"], begun["zoom"]))
check(changed["parameters"]["run.until"] == 50 and again["parameters"] == begun["parameters"] and again["lesson"]["step"] == 2,
      "Ctrl+R puts the house back as the step began", again["parameters"]["run.until"])
check(held["parameters"] == begun["parameters"] and not held["edits"] and "Locked in this lesson: people" in held["message"],
      "what is locked is put back, and says so", (held["message"], held["edits"]))
check(undone["parameters"]["person.p1.heading"] != 5 and undone["lesson"]["step"] == 3,
      "also after an undo beyond the beginning of the step", undone["parameters"]["person.p1.heading"])
check(freed["parameters"]["person.p1.heading"] == 5, "and is free once the teacher unlocks it", freed["message"])
check(later["parameters"]["run.until"] == 60 and later["lesson"]["step"] == 2, "a step that was gone back to is as it was left")
check(earlier["parameters"] == begun["parameters"], "and starts again from its beginning", earlier["parameters"]["run.until"])

# the house of a shipped lesson is not written over, also where it may be written
assets = stage.folder / "assets"
for part in ("lessons", "profiles", "populations", "furniture", "help", "rules"):
    shutil.copytree(stage.source / "assets" / part, assets / part)
flat = assets / "lessons" / "houses" / "flat.json"
before = flat.read_bytes()
saved, = act("saved", "until answered", "set run.until 50", "until answered", "key Ctrl+S", "wait 3", "state STATE",
             arguments=[assets / "lessons" / "legal-no-way.json", "--size", "800x450"], CLEARANCE_ASSETS=str(assets))
check(saved["sheet"] == "save" and flat.read_bytes() == before, "Ctrl+S asks for a name", (saved["sheet"], saved["message"]))
check(saved["field"].startswith(str(stage.folder / "saved" / "home" / "Documents")), "in the documents", saved["field"])

# a lesson of one step is left by the key that goes on
told = json.loads(short.read_text())
told["steps"] = [{"kind": "read", "text": "A."}]
one = stage.folder / "one.json"
one.write_text(json.dumps(told))
left, = act("one", "until answered", "key PageDown", "wait 3", "state STATE", arguments=[one, "--size", "800x450"])
check(not left["lesson"] or left["sheet"] == "lesson", "a lesson of one step ends", (left["lesson"], left["sheet"]))

# guesses that are numbers: typed, added by Return, taken back, a second vote, and kept
told = json.loads(short.read_text())
told["steps"] = [{"kind": "predict", "ask": "How wide?", "unit": "m", "answer": 0.9}, {"kind": "compare", "text": "So."}]
short.write_text(json.dumps(told))
typed, voted, back = act(
    "numbers", "until answered", "key 0", "key ,", "key 7", "key Return", "key Return", "key 1", "key .", "key .", "key 2",
    "key 5", "key Backspace", "key Return", "key 3", "key Return", "key Backspace", "key 8", "wait 2", "state STATE",
    "key Backspace", "key F10", "key Escape", "key PageDown", "wait 2", "state STATE", "key PageUp", "wait 2", "state STATE",
    arguments=[short, "--size", "800x450"])
check(typed["lesson"]["numbers"] == [0.7, 1.2] and typed["lesson"]["typed"] == "8" and typed["lesson"]["step"] == 1,
      "numbers are typed, with a comma or a point, and taken back", typed["lesson"])
check(voted["lesson"]["step"] == 2 and back["lesson"]["numbers"] == [0.7, 1.2], "and stay when the lesson goes on and back",
      back["lesson"])
offered, on = act("numbers", "wait 3", "state STATE", "key Escape", "wait 3", "state STATE",
                  arguments=[short, "--size", "800x450"])[-2:]
check(offered["sheet"] == "kept" and on["lesson"]["numbers"] == [0.7, 1.2], "they are kept for the next time", on["lesson"])

# a goal that asks what the class has guessed, and what is selected
told["steps"] = [{"kind": "predict", "ask": "Who?", "options": ["door", "person"], "truth": 2},
                 {**task, "goal": [{"measure": "answer", "unit": "1", "is": 2},
                                   {"measure": "selected", "unit": "1", "is": "person p1", "title": "the driver"}]}]
short.write_text(json.dumps(told))
act("person", "until answered", "key 1", "key 2", "key PageDown", "until answered", "expect lesson.goal no", 'select "exit e1"',
    "wait 2", "until answered", "expect lesson.goal no", 'select "person p1"', "wait 2", "until answered",
    "expect lesson.goal yes", "key PageUp", "key 1", "key PageDown", "until answered", 'select "person p1"', "wait 2",
    "until answered", "expect lesson.goal no", arguments=[short, "--size", "800x450"])

# before the class has guessed, no key and no button goes to another time
told["steps"] = [{"kind": "predict", "ask": "Who?", "options": ["door", "person"], "truth": 2}, {"kind": "compare", "text": "So."}]
short.write_text(json.dumps(told))
for name, file, machine in (("house", stage.house("corner-1.80-1.80"), "house"), ("beam", stage.beam("ibs"), "beam")):
    told |= {"laboratory": machine, "file": str(file), "lock": []}
    short.write_text(json.dumps(told))
    before, *after = act(f"guess-{name}", "until answered", "wait 5", "state STATE",
                         *(word for key in ("End", ".", "Shift+.", "Shift+Right", "R", "Space") for word in (f"key {key}", "wait 3", "state STATE")),
                         arguments=[short, "--size", "800x450"])
    check(all(state["time"] == before["time"] and not state["playing"] for state in after),
          f"{name}: nothing moves before the guess", [(state["time"], state["playing"]) for state in after])
    check("guesses first" in after[0]["message"], f"{name}: and it says why", after[0]["message"])
told |= {"laboratory": "house", "file": stage.house("corner-1.80-1.80"), "lock": ["people"]}

# what the window shows in a step, and after the lesson
told["view"] = {"layers": [1, 3], "plots": "none", "speed": 2}
told["steps"] = [{"kind": "predict", "ask": "Who?", "options": ["door", "person"], "truth": 2},
                 {"kind": "compare", "text": "So."},
                 {"kind": "compare", "text": "So.", "view": {"layers": [7], "plots": "force,ring", "speed": 0.5}}]
short.write_text(json.dumps(told))
alone, lesson_s, step_s, back, after = [(now["layers"], sorted(now["frame"]["plots"]), now["speed"]) for now in act(
    "view", f"open {stage.house('corner-1.80-1.80')}", "until answered", "wait 2", "state STATE", f"open {short}",
    "until answered", "key PageDown", "wait 2", "state STATE", "key PageDown", "wait 3", "state STATE", "key PageUp", "wait 3",
    "state STATE", f"open {stage.house('corner-1.80-1.80')}", "until answered", "wait 3", "state STATE",
    arguments=["--size", "1920x1080"])]
check(lesson_s == (0b101, [], 2), "the view of the lesson", lesson_s)
check(step_s == (0b1000000, ["force", "ring"], 0.5), "and of a step, in its place", step_s)
check(back == lesson_s and after == alone and alone[1], "and back; after the lesson all is as it was", (alone, back, after))

# the card at other sizes, in both themes: beside the view, never over it
for width, height in ((1280, 720), (1920, 1080), (1024, 600)):
    for key in ("wait 1", "key F5"):
        found = act(f"size-{width}-{key[:3]}", key, "until answered", "wait 3", "state STATE", "key Ctrl+T", "wait 3",
                    "state STATE", arguments=[lesson("two-doors-locked"), "--size", f"{width}x{height}"])
        for now in found:
            frame = now["frame"]
            check(apart([frame[name] for name in ("answer", "card", "view", "timeline")]),
                  f"{width} x {height}, {key}, {now['theme']}: the card stands beside the view", frame)
stage.end()
