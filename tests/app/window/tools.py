#!/usr/bin/env python3
"""Tests what the tools show before a click and what the click then does, with a real mouse and real keys: exits lie on
doors, openings and new doors, people touch nothing, and a house can be drawn from nothing to an answer."""

import json

import stage
from drawing import Plan
from stage import check


def read(path):
    return json.loads(path.read_text())


def chain(plan, *points):
    plan.keys("w")
    for x, y in points:
        plan.put(x, y)
    plan.keys("Escape", "Escape", "Escape")


def preview(plan, x, y):
    """Moves the pointer to a place, and returns what a click there would do."""
    plan.move(x, y)
    return plan.until(lambda s: "preview" in s["gesture"])["gesture"].get("preview") or {"words": None, "refused": None}


def counts(plan, name):
    """Saves a copy and returns the lists of its house."""
    path = plan.place / f"{name}.json"
    plan.save_as(path)
    house = read(path)
    return {part: house.get(part, []) for part in ("walls", "doors", "exits", "people", "furniture")}


plan = Plan("exits", minutes=9)
plan.keys("ctrl+n")
plan.until(lambda s: s["answer"]["title"] == "No plan yet" and s["floor"])
chain(plan, (-3, -2), (3, -2), (3, 2), (-3, 2), (-3, -2))

# 17: on a solid wall an exit comes with a door, and one step takes both back
before = plan.state()["digest"]
plan.keys("x")
said = preview(plan, 3, 0.5)
check(said["words"] == "solid wall: click makes a door 0.90 m with the exit" and not said["refused"],
      "17, 18: over a solid wall the exit tool says that it makes a door", said)
shot = plan.shot("solid-wall")
check(plan.state()["edits"] == 1, "18: the preview is no edit", plan.state()["edits"])
plan.put(3, 0.5)
plan.keys("Escape", "Escape", "Escape")
made = counts(plan, "solid")
check(len(made["doors"]) == 1 and len(made["exits"]) == 1 and abs(made["doors"][0]["width"] - 0.9) < 1e-9,
      "17: the click makes a door of 0.90 m and the exit in it", made)
plan.keys("p")
plan.put(-2, -1)
plan.keys("Escape", "Escape", "Escape")
left = plan.until(lambda s: s["answer"]["title"].startswith("Out in") and not s["answer"]["stale"])
check(left["answer"]["title"].startswith("Out in"), "17: and the exit can be used", left["answer"])
plan.keys("ctrl+z", "ctrl+z")
back = counts(plan, "back")
check(not back["doors"] and not back["exits"], "17: one step takes both back", back)

# 17: over empty floor it is refused with words, and nothing changes
plan.keys("x")
said = preview(plan, 0, 0)
check(said["refused"] and said["words"] == "exits lie on doors and openings", "17: over floor it says why not", said)
plan.put(0, 0)
state = plan.state()
check(not state["gesture"]["active"] and state["undo_name"] == "Draw walls", "17: a click there does nothing",
      state["gesture"])

# over a door and over an opening between the ends of two walls
plan.keys("d")
said = preview(plan, 0, 2)
check(said["words"] == "door 0.80 m", "18: the door tool shows the door", said)
check({"swing", "dimension"} <= {mark["kind"] for mark in plan.state()["gesture"]["marks"]},
      "18: with its leaf and both gaps")
plan.put(0, 2)
plan.keys("x")
said = preview(plan, 0, 2)
check(said["words"] == "door: exit", "18: over a door the exit lies in it", said)
plan.put(0, 2)
plan.move(0, 0)
said = preview(plan, 0.02, 2)
check(said["refused"] and said["words"] == "there is an exit already", "18: not twice", said)
plan.keys("Escape", "Escape", "Escape")
chain(plan, (-1, -2), (-1, -0.5))
chain(plan, (-1, 2), (-1, 0.5))
plan.keys("x")
said = preview(plan, -1, 0)
check(said["words"] == "opening: exit", "18: over an opening between walls the exit lies in it", said)
plan.put(-1, 0)
plan.keys("Escape", "Escape", "Escape")
made = counts(plan, "opening")
ends = sorted([made["exits"][-1]["from"], made["exits"][-1]["to"]])
check(max(abs(a - b) for end, wall in zip(ends, [(-1, -0.5), (-1, 0.5)]) for a, b in zip(end, wall)) < 0.02,
      "18: from wall to wall", made["exits"])

# a person is red where the body would touch, with the name of what, and refused inside a wall
plan.keys("p")
said = preview(plan, -2.8, 0)
check(said["warns"] and said["words"].startswith("touches wall"), "18: a person that touches says what", said)
plan.shot("touching")
said = preview(plan, -3, 0)
check(said["refused"] and "wall" in said["words"], "18: inside a wall a person is refused", said)
plan.put(-3, 0)
plan.keys("Escape", "Escape", "Escape")
check(not counts(plan, "nobody")["people"], "18: and is not placed there")
plan.keys("p")
said = preview(plan, 1, 0)
check(not said["refused"] and not said["warns"], "18: in free space nothing is wrong", said)

# the first person stands where nobody can: that is said, and no run before it
plan.put(-2.8, 0)
stands = plan.until(lambda s: s["complete"] and s["answer"]["title"] == "A starts inside wall" and not s["answer"]["stale"])
check(stands["answer"]["title"] == "A starts inside wall" and "before" not in stands["answer"]["detail"],
      "who is placed where nobody can stand is no run to compare with", stands["answer"])
plan.put(1, 0)
more = plan.until(lambda s: s["complete"] and "A starts inside wall" in s["answer"]["detail"] and not s["answer"]["stale"])
check("before" not in more["answer"]["detail"], "and is told beside the others", more["answer"])
plan.end()



# 20: what is missing is said, with the tool that adds it
need = Plan("need")
need.keys("ctrl+n")
state = need.until(lambda s: s["answer"]["title"] == "No plan yet" and s["floor"])
check((state["answer"]["title"], state["answer"]["cure"]) == ("No plan yet", "Draw walls"), "an empty plan asks for walls",
      state["answer"])
chain(need, (-3, -2), (3, -2), (3, 2), (-3, 2), (-3, -2))
need.keys("d")
need.put(3, 1)
need.keys("Escape", "Escape", "Escape")
state = need.until(lambda s: s["answer"]["title"] == "No exit yet" and not s["answer"]["stale"])
check(state["answer"]["detail"] == "Add an exit (X) on a door or an opening.", "20: no exit: it says what to do",
      state["answer"])
check(any(mark["kind"] == "ring" and mark.get("words") == "here?" for mark in state["gesture"]["marks"]),
      "20: the door that leads outside is ringed", state["gesture"]["marks"])
need.shot("no-exit")
for _ in range(12):
    if need.state()["focus"] == "answer":
        break
    need.keys("F6")
need.keys("Return")
state = need.until(lambda s: s["answer"]["title"] == "Nobody is here")
check(state["tool"] == "person" and state["undo_name"] == "Place exit",
      "20: Return on the button places the exit there, and takes the tool for people", (state["tool"], state["undo_name"]))
need.keys("Escape", "Escape", "Escape")
check(state["answer"]["cure"] == "Place somebody", "then somebody is missing", state["answer"])
check(not any(mark["kind"] == "ring" for mark in state["gesture"]["marks"]), "and nothing is ringed any more")
need.end()


def answer_of(name, more):
    """Opens a room with what is given; returns its answer."""
    room = {"format": "clearance-house", "version": 1, "name": name,
            "walls": [{"id": "w1", "points": [[-3, -2], [3, -2], [3, 2], [-3, 2], [-3, -2]], "thickness": 0.12}],
            "people": [{"id": "a", "profile": "manual-chair", "at": [-2, -1], "heading": 0}], **more}
    path = stage.folder / f"{name}.json"
    path.write_text(json.dumps(room))
    return stage.act(name, "until answered", "wait 5", "state STATE", arguments=[path])[0]["answer"]


said = answer_of("closed", {"exits": [{"id": "porch", "from": [3, 0], "to": [3, 0.8]}]})
check((said["title"], said["cure"]) == ("No opening at exit porch: add a door", "Add a door") and "w1" in said["detail"],
      "an exit on a solid wall is said to have no opening", said)
room = [[-3, -2], [0, -2], [0, 2], [-3, 2]]
said = answer_of("no-door", {
    "walls": [{"id": "w1", "points": [[-3, -2], [3, -2], [3, 2], [-3, 2], [-3, -2]], "thickness": 0.12},
              {"id": "mid", "points": [[0, -2], [0, 2]], "thickness": 0.12}],
    "doors": [{"id": "d1", "wall": "w1", "segment": 1, "at": 2, "width": 0.9, "kind": "hinged"}],
    "rooms": [{"id": "r1", "name": "bedroom", "outline": room},
              {"id": "r2", "name": "corridor", "outline": [[x + 3, y] for x, y in room]}],
    "exits": [{"id": "porch", "from": [3, -0.45], "to": [3, 0.45]}]})
check((said["title"], said["detail"]) == ("Room without a door", "Add a door (D) in the wall between bedroom and corridor") or
      said["detail"] == "Add a door (D) in the wall between corridor and bedroom", "a room without a door is named", said)

# its button begins with the door at that wall
cure = Plan("cure", stage.folder / "no-door.json", texts=True)
cure.until(lambda s: s["answer"]["cure"] == "Add a door" and not s["answer"]["stale"])
button = next(text["box"] for text in cure.texts() if text["string"] == "Add a door")
cure.click((button[0] + button[2]) / 2, (button[1] + button[3]) / 2)
marks = cure.until(lambda s: s["tool"] == "door")["gesture"]["marks"]
snap = [mark["words"] for mark in marks if mark["kind"] == "snap"]
check(snap in (["on wall between bedroom and corridor"], ["on wall between corridor and bedroom"]),
      "the button of the answer begins with a door in the wall that it names", marks)
cure.end()

# a double click between walls makes the room; a typed place far away stays in the view
room = stage.folder / "rooms.json"
room.write_text(json.dumps({
    "format": "clearance-house", "version": 1, "name": "rooms",
    "walls": [{"id": "w1", "points": [[-3, -2], [3, -2], [3, 2], [-3, 2], [-3, -2]], "thickness": 0.12},
              {"id": "mid", "points": [[0, -2], [0, 2]], "thickness": 0.12},
              {"id": "loose", "points": [[-3, 0], [-1, 0]], "thickness": 0.12}]}))
seen = stage.act("double", "until idle", "key a", "at -1.5 1", "press", "release", "press double", "release", "wait 2",
                 "state STATE", "key Ctrl+Shift+S", "wait 5", "key Ctrl+A", f'type "{stage.folder}/roomed.json"',
                 "key Return", "wait 5", arguments=[room])
made = read(stage.folder / "roomed.json").get("rooms", [])
check(len(made) == 1 and sorted(made[0]["outline"]) == [[-3, -2], [-3, 2], [0, -2], [0, 2]],
      "a double click with the room tool makes the room between the walls", made)
check(seen[0]["undo_name"] == "Draw room" and not seen[0]["gesture"]["active"], "as one step", seen[0]["undo_name"])

far = Plan("far")
far.keys("ctrl+n")
far.until(lambda s: s["answer"]["title"] == "No plan yet" and s["floor"])
far.keys("w", "Return")
for values in (("0", "0"), ("30", "0"), ("20", "90")):
    far.type(values[0])
    far.keys("Tab")
    far.type(values[1])
    far.keys("Return")
state = far.state()
corner, view = far.point(30, 20, state), state["frame"]["view"]
check(view[0] < corner[0] < view[2] and view[1] < corner[1] < view[3], "typed walls stay in the view", (corner, view))
far.keys("Escape", "Escape", "Escape")

# 19: by keys alone the ghost is moved by arrows and placed by Return
far.point_to(0, 0)
far.keys("p", "Return")
begun = far.state()["gesture"]["fields"]
far.keys("shift+Up", *["shift+Right"] * 10, *["shift+Up"] * 9, "Up")
moved = far.state()["gesture"]["fields"]
check(abs(moved["x"] - begun["x"] - 1) < 1e-9 and abs(moved["y"] - begun["y"] - 1.01) < 1e-9,
      "19: arrows move what is placed by keys", (begun, moved))
far.keys("Return", "Escape", "Escape")
check(far.state()["undo_name"].startswith("Place person"), "19: and Return places it", far.state()["undo_name"])

# the real length of a measured distance scales the house
far.keys("m")
far.put(0, 0)
far.put(30, 0)
for _ in range(12):
    if far.state()["focus"] == "panel":
        break
    far.keys("F6")
for _ in range(12):
    if (far.state()["focus_help"] or "").startswith("real length"):
        break
    far.keys("Tab")
far.keys("ctrl+a")
far.type("12 m")
far.keys("Return")
far.until(lambda s: (s["undo_name"] or "").startswith("Set the scale"))
scaled = counts(far, "scaled")
check(scaled["walls"] and max(abs(a - b) for p, q in zip(scaled["walls"][0]["points"], [[0, 0], [12, 0], [12, 8]])
                              for a, b in zip(p, q)) < 0.02, "a typed length sets the scale of the house", scaled["walls"])
far.end()

# all faults of a broken file are shown
broken = stage.folder / "broken.json"
broken.write_text('{"format":"clearance-house","version":1,"walls":[{"points":[[0,0]]}],"exits":[{"id":"e"}]}')
seen = stage.act("broken", "until complete", f'open "{broken}"', "wait 5", "state STATE", "picture FOLDER/broken.png",
                 code=0)
check(seen and seen[0]["sheet"] == "messages" and seen[0]["messages"] >= 3, "all faults of a broken file are shown",
      seen and (seen[0]["sheet"], seen[0]["messages"]))

# a fix is asked for, counted, and used by one key
fix = Plan("fix", stage.house("flat-0.910-module"))
fix.until(lambda s: s["answer"]["title"].endswith("cannot pass the bedroom door") and s["complete"])
for _ in range(12):
    if fix.state()["focus"] == "panel":
        break
    fix.keys("F6")
for _ in range(20):
    if (fix.state()["focus_help"] or "").startswith("Suggest a fix"):
        break
    fix.keys("Tab")
fix.keys("Return")
counted = fix.until(lambda s: s["proposing"] or s["proposals"])
check(counted["proposals"] or counted["proposing"].endswith(" tried"), "the search counts what it has tried",
      counted["proposing"])
fix.until(lambda s: s["proposals"])
begun = fix.state()
check(not begun["unsaved_edits"], "the house is unchanged until a fix is used")
while fix.state()["focus"] != "view":
    fix.keys("F6")
fix.keys("Return")
done = fix.until(lambda s: s["answer"]["title"].startswith("Out in") and not s["answer"]["stale"])
check(done["answer"]["title"].startswith("Out in ") and done["unsaved_edits"] == 1, "Return uses the first fix, as one step",
      (done["answer"]["title"], done["undo_name"], done["unsaved_edits"]))
fix.end()

# 21: three first things to try, ticked by real keys, gone for good, and brought back
def middle_of(box, part=0.5):
    return box[0] + part * (box[2] - box[0]), (box[1] + box[3]) / 2


def third():
    """Returns the words on the third button of the strip."""
    return next((t["string"] for t in first.texts() if t["string"].lstrip("\u2713 ").startswith("3  ")), "")


first = Plan("tries", texts=True)
state = first.until(lambda s: s.get("complete") and s["frame"]["tries"][2] > 0)
strip = state["frame"]["tries"]
check(strip[3] - strip[1] >= 46 and state["frame"]["view"][3] <= strip[1], "21: an empty home has a strip to try", strip)
first.shot("tries")
first.until(lambda s: s["time"] > 3 or not s["playing"])
first.keys("r")
first.until(lambda s: s["tried"] & 1)
check(first.state()["tried"] & 1, "21: watching for 3 s is ticked")
first.click(*middle_of(strip, 0.5))
state = first.state()
check("door" in (state["selected"] or "").lower() and state["focus"] == "panel", "21: the second selects a door",
      (state["selected"], state["focus"]))
state = first.until(lambda s: ".width" in (s["focus_help"] or ""), patience=20)
check("door.d7.width" in (state["focus_help"] or "") and "washroom door, " in state["answer"]["detail"],
      "21: that of the headline, and its width has the focus", (state["selected"], state["focus_help"], state["answer"]))
first.keys("Left")
first.until(lambda s: s["tried"] & 2)
check(first.state()["tried"] & 2, "21: and a narrower door is ticked", first.state()["undo_name"])
check(first.state()["focus"] == "panel", "21: arrow keys may go on", first.state()["focus"])
first.keys("Escape")
check(first.state()["focus"] == "view", "21: Escape leads back to the plan", first.state()["focus"])
first.click(*middle_of(strip, 0.5))
first.until(lambda s: ".width" in (s["focus_help"] or ""), patience=20)
first.keys("Return", "ctrl+a")
first.type("0.7")
first.keys("Return")
check(first.state()["focus"] == "view", "21: a width that was typed leads back to the plan, too", first.state()["focus"])
check(third() == "3  Shake the house (Shift+T)", "21: the third begins with an earthquake", third())
first.keys("shift+t")
state = first.until(lambda s: third() == "3  Fix one piece to the wall", patience=30)
check(state["tried"] == 3 and third() == "3  Fix one piece to the wall", "21: goes on with what to fix", (third(), state["tried"]))
first.shot("fix-one-piece")
first.keys("shift+t")
check(first.state()["tried"] == 3, "21: another earthquake alone is no fix", first.state()["tried"])
first.until(lambda s: "What to fix to the wall" in [row[0] for row in s["rows"]], patience=240)
piece = next(text["string"] for text in first.texts() if text["string"].startswith("Fix the "))
first.click(*middle_of(strip, 0.85))
state = first.until(lambda s: s["undo_name"].startswith("Fix "))
check(state["undo_name"] == piece.replace("the ", "") + " to the wall" and state["focus"] == "view",
      "21: its button fixes the piece that the panel names, as one step", (state["undo_name"], piece, state["focus"]))
check(first.until(lambda s: third() == "3  Shake again (Shift+T)") and first.state()["tried"] == 3,
      "21: and then with the same house shaken again", (third(), first.state()["tried"]))
first.shot("shake-again")
first.keys("ctrl+z")
check(first.until(lambda s: third() == "3  Fix one piece to the wall"), "21: undone, the piece is to be fixed again", third())
first.keys("ctrl+y")
first.until(lambda s: third() == "3  Shake again (Shift+T)")
first.keys("shift+t")
state = first.until(lambda s: s["frame"]["tries"][2] == 0)
check(state["tried"] == 7 and state["frame"]["tries"][2] == 0, "21: after the third the strip is gone", state["tried"])
first.end()
first.log.unlink()
first = Plan("tries")
state = first.until(lambda s: s.get("complete"))
check(state["frame"]["tries"][2] == 0, "21: it stays gone")
first.keys("ctrl+F1")
check(first.until(lambda s: s["frame"]["tries"][2] > 0)["tried"] == 0, "21: Help brings it back")
first.end()

first.log.unlink()
first = Plan("tries", stage.house("two-chairs-corridor"))
state = first.until(lambda s: s.get("complete") and s["frame"]["tries"][2] > 0)
first.click(*middle_of(state["frame"]["tries"], 0.5))
state = first.until(lambda s: s["message"])
check(state["message"].startswith("This house has no door") and state["focus"] == "view",
      "21: a house without doors says so, and nothing of it is typed over", (state["message"], state["focus_help"]))
first.end()

# a new user: a flat of two rooms with a door, an exit, a wardrobe and a person in at most 25 actions
user = Plan("user")
done = 0


def act(what, *with_what):
    global done
    done += 1
    what(*with_what)


user.until(lambda s: s["floor"])
act(user.keys, "ctrl+n")
user.until(lambda s: s["answer"]["title"] == "No plan yet" and s["floor"])
act(user.keys, "w")
for corner in ((-3, -2), (3, -2), (3, 2), (-3, 2), (-3, -2)):
    act(user.put, *corner)
act(user.put, 0, -2)
act(user.put, 0, 2)
act(user.keys, "Escape")
act(user.keys, "d")
act(user.put, 0, 1)
act(user.keys, "x")
act(user.put, 3, -1)
act(user.keys, "o")
state = user.state()
user.shot("catalogue")
done += 1  # a click on the wardrobe, wherever it lies in the catalogue
left, top, right, foot = state["frame"]["panel"]
for y in range(round(top) + 60, round(foot), 30):
    user.click(left + 0.27 * (right - left), y)
    user.move(-2, 0)
    if (user.state()["gesture"].get("preview") or {"words": ""})["words"].startswith("wardrobe"):
        break
act(user.put, -2, 1.6)
act(user.keys, "p")
act(user.put, -2, -1)
answer = user.until(lambda s: s["answer"]["title"].startswith("Out in") and not s["answer"]["stale"])["answer"]
check(answer["title"].startswith("Out in") and done <= 25, "a new user has an answer in at most 25 actions",
      (answer["title"], done))
print("     actions:", done)
user.shot("answer")
user.end()

# a film never takes the place of a file, and its messages name it
film = stage.Screen("film", stage.house("corner-0.90-0.90"))
film.until(lambda s: s["complete"])
kept = film.place / "home" / "clearance"
kept.mkdir(parents=True)
(kept / "corner-0.90-0.90-film.mp4").write_text("mine")
film.keys("ctrl+e")
film.until(lambda s: s["sheet"] == "export")
film.keys(*["Tab"] * 7, "Return")  # the eighth: film
said = film.until(lambda s: (s["message"] or "").startswith("Writing "))["message"]
check(said.endswith("film-2.mp4"), "a second film has a name of its own", said)
told = film.until(lambda s: s["export"] and "picture" in s["export"]["doing"])["export"]
check(told and told["path"].endswith("film-2.mp4"), "its progress names the file", told)
check((kept / "corner-0.90-0.90-film.mp4").read_text() == "mine", "the first film is untouched")
film.end()

# 29: the open dialog begins in the folder of the open file; shipped files are saved to the documents
own = stage.folder / "own"
own.mkdir()
(own / "mine.json").write_text(open(stage.house("closed-door")).read())
(own / "plan.dxf").write_text("")
files = stage.Screen("files", own / "mine.json")
files.until(lambda s: s["complete"])
files.keys("ctrl+o")
listed = files.until(lambda s: s["sheet"] == "open")["listed"]
check("mine.json" in listed and "plan.dxf" in listed, "29: the open dialog lists the folder of the open file", listed)
files.keys("Escape", "ctrl+shift+s")
check(files.until(lambda s: s["sheet"] == "save")["field"].startswith(str(own)), "29: a copy goes beside it",
      files.state()["field"])
files.keys("Escape", "ctrl+o")
files.until(lambda s: s["sheet"] == "open")
files.type(stage.house("closed-door"))
files.keys("Return")
files.until(lambda s: "closed-door" in (s["file"] or "") and s["complete"])
files.keys("ctrl+s")
field = files.until(lambda s: s["sheet"] == "save")["field"]
check(field.startswith(str(files.place / "home" / "Documents")), "29: a shipped house is saved to the documents", field)
files.keys("Escape")

files.end()

# recovered work says how many edits it has, and is edited once it is changed
lost = Plan("lost", stage.house("closed-door"))
lost.until(lambda s: s["complete"])
lost.keys("ctrl+a", "Delete")
lost.until(lambda s: s["unsaved_edits"] == 1)
lost.crash()
lost = Plan("lost")
lost.until(lambda s: s["sheet"] == "recovered")
lost.keys("Return")
state = lost.until(lambda s: s["sheet"] == "none")
check(state["unsaved_edits"] == 1 and state["shown_title"].endswith(" [Recovered]"), "recovered work has its edits",
      (state["unsaved_edits"], state["shown_title"]))
lost.keys("ctrl+z")
lost.keys("p")
lost.put(*[sum(v) / 2 for v in ((1, 1.4), (1, 1.4))])
lost.keys("Escape", "Escape", "Escape")
state = lost.until(lambda s: s["unsaved_edits"] == 2)
check(state["shown_title"].endswith(" [Recovered] (edited)"), "and is edited after the next one", state["shown_title"])
lost.end()

# a path that leads nowhere is told in the dialog, before anybody is asked whether to save, until another one is typed
wrong, typing, right = stage.act("path", "until answered", "pause", "select bed", "key Shift+Right", "wait 10", "key Ctrl+O",
                                 "wait 5", "type /nowhere/x.json", "key Return", "wait 5", "state STATE", "texts FOLDER/wrong",
                                 "type /n", "wait 5", "state STATE", "texts FOLDER/typing", "key Ctrl+A",
                                 f"type {stage.house('straight-corridor')}", "key Return", "wait 5", "state STATE",
                                 arguments=[stage.house("flat-0.910-module")])
told = [(stage.folder / "path" / name).read_text().count("/nowhere/x.json cannot be opened") for name in ("wrong", "typing")]
check((wrong["sheet"], typing["sheet"], told) == ("open", "open", [1, 0]), "a wrong path is told where it is typed",
      (wrong["sheet"], typing["sheet"], told))
check(right["sheet"] == "leave" and right["faults"] == 0, "a right path asks whether to save", (right["sheet"], right["faults"]))

stage.end()
