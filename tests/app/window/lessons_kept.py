#!/usr/bin/env python3
"""Tests that no guess of a class is lost: the program is killed while hands are counted, it ends in the middle of a
lesson, its folder cannot be written, what it kept is damaged, or belongs to another lesson."""

import json
import shutil
import signal
import subprocess
import time

import stage
from classroom import lesson
from stage import act, check, environment, folder, program

name = lesson("legal-no-way")
small = ["--size", "800x450"]


def kept_in(place):
    return folder / place / "home" / ".local" / "state" / "clearance" / "lessons.json"


def lessons_in(place):
    return json.loads(kept_in(place).read_text())["lessons"]


def kill_after(place, *lines):
    """Follows a script, and kills the program without a warning once it has written a state."""
    where = folder / place
    where.mkdir(exist_ok=True)
    begun = where / "begun"
    (where / "script").write_text("\n".join([*lines, f"state {begun}", "wait 100000"]) + "\n")
    window = subprocess.Popen([program, "open", name, *small, "--script", str(where / "script")], cwd=where,
                              env=environment(where / "home", SDL_VIDEODRIVER="offscreen"))
    while window.poll() is None and not stage.states(begun):
        time.sleep(0.01)
    window.send_signal(signal.SIGKILL)
    check(window.wait() == -signal.SIGKILL, f"{place}: the program is killed")


def go(place, *lines, file=name):
    """Opens a lesson in the home of an earlier run, and returns the states of the script."""
    (folder / place / "states").unlink(missing_ok=True)
    return act(place, "wait 3", *lines, arguments=[file, *small])


# killed while hands are counted
kill_after("killed", "key PageDown", "key 1", "key 1", "key 3", "key 0", "key 3", "key 2")
at_once, after = go("killed", "state STATE", "key Escape", "wait 3", "state STATE")
check(at_once["sheet"] == "kept" and at_once["lesson"]["step"] == 1, "what was kept is offered", at_once["sheet"])
check(after["sheet"] == "none" and after["lesson"]["step"] == 2 and after["lesson"]["vote"] == 2 and
      after["lesson"]["hands"] == [0, 1, 1] and after["lesson"]["hides"],
      "Escape goes on: the place, and the hands of the second vote, are as they were", after["lesson"])

# it ends without a question, and goes on later, at another step
on = ("key Escape", "wait 3", "key PageDown", "until answered", "key 2", "key PageDown", "wait 3")
far, = go("killed", *on, "key ?", "key ?", "state STATE")
check(far["lesson"]["step"] == 4 and far["lesson"]["hints"] == 2, "it goes on to the task", far["lesson"])
task, back = go("killed", "key Return", "wait 3", "until answered", "state STATE", "key PageUp", "wait 3", "state STATE")
check(task["lesson"]["step"] == 4 and task["lesson"]["hints"] == 2 and task["lesson"]["goal"] == "no",
      "the hints are kept, and the goal is judged anew", task["lesson"])
check(back["lesson"]["step"] == 3 and back["lesson"]["chosen"] == 2, "going back comes to the answer of the class",
      back["lesson"])
asked, = go("killed", "key Return", "wait 3", "key Ctrl+Q", "wait 3", "state STATE") or [None]
check(False, "quitting asks nothing, since all is kept", asked) if asked else None

# a numbers-of-a-machine lesson goes on with the settings of its steps
machine = lesson("one-per-cent")
go("machine", "key PageDown", "key 2", "key PageDown", "wait 3", file=machine)
there, = go("machine", "key Return", "wait 3", "state STATE", file=machine)
check(there["lesson"]["step"] == 3 and there["parameters"]["beam.length"] == 0.284012,
      "a beam is as the step begins it", (there["lesson"], there["parameters"]["beam.length"]))

# restarted, ended at its last card, changed since, damaged
anew, later = go("killed", "key Tab", "key Return", "wait 3", "state STATE", "key PageDown", "wait 2", "state STATE")
check(anew["sheet"] == "none" and anew["lesson"]["step"] == 1 and later["lesson"]["hands"] == [0, 0, 0],
      "Restart forgets the guesses", later["lesson"])
steps = [line for _ in range(8) for line in ("key PageDown", "wait 3")]
go("ended", *steps, "key Tab", "key Return", "wait 3")
check(lessons_in("ended") == [], "what has come to its end is forgotten", lessons_in("ended"))

copy = folder / "copy"
shutil.copytree(stage.source / "assets" / "lessons", copy / "lessons")
own = copy / "lessons" / "legal-no-way.json"
go("changed", "key PageDown", "key 3", "wait 2", file=str(own))
check(len(lessons_in("changed")) == 1, "a lesson of one's own is kept, too")
own.write_text(own.read_text().replace("yes, easily", "yes, quickly"))
now, = go("changed", "state STATE", file=str(own))
check(now["sheet"] == "none", "a lesson that was changed restarts", now["sheet"])

for what, words in (("damaged", "{"), ("strange", '{"lessons": 3}'),
                    ("huge", json.dumps({"lessons": [{"path": name, "step": 7000000000}]}))):
    kept_in(what).parent.mkdir(parents=True)
    kept_in(what).write_text(words)
    now, after = go(what, "state STATE", "key PageDown", "key 1", "wait 2", "state STATE")
    check(now["sheet"] == "none" and after["lesson"]["hands"] == [1, 0, 0], f"a {what} file is no obstacle", now["sheet"])
    check(what == "huge" or ("lessons.json.bad" in now["message"] and (kept_in(what).parent / "lessons.json.bad").exists()),
          f"a {what} file is kept as another one, and said", now["message"])
    check(len(lessons_in(what)) == 1, f"and the guesses are kept ({what})")

# nothing can be written: it is said, and then quitting asks
(folder / "unwritable" / "home").mkdir(parents=True)
(folder / "unwritable" / "home" / ".local").write_text("a file, not a folder")
said, asked = go("unwritable", "key PageDown", "key 3", "wait 2", "state STATE", "key Ctrl+Q", "wait 3", "state STATE")
check("cannot be kept" in (said["message"] or "") and said["lesson"]["hands"] == [0, 0, 1],
      "it is said that guesses cannot be kept, and they are counted", said["message"])
check(asked["sheet"] == "lesson", "then quitting asks", asked["sheet"])
stage.end()
