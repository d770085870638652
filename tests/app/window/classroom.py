"""Gives lessons with a real keyboard, in presentation mode: what a teacher and a pupil do, for the tests of lessons.
With CLEARANCE_SCREENS=FOLDER, a picture of each step is kept there, to be looked at."""

import os
import pathlib
import shutil

import stage
from stage import Screen, check


def lesson(name):
    return str(stage.source / "assets" / "lessons" / f"{name}.json")


def judged(s):
    return s["lesson"] and not s["lesson"]["working"] and not s["answer"]["stale"]


def wait(screen, what):
    """Waits longer than for a click: a crank on a busy machine needs minutes for a verdict."""
    return screen.until(what, patience=4 * stage.PATIENCE)


def step(screen, number):
    """Waits for a step, and returns the state."""
    return screen.until(lambda s: s["lesson"] and s["lesson"]["step"] == number)


def select(screen, key, by="Tab"):
    """Walks with Tab, or Shift+Tab, to a thing of the plan."""
    for _ in range(60):
        if screen.state()["selected"] == key:
            return True
        screen.keys(by)
    return False


def type_number(screen, text, name=None):
    """Opens the first number of the panel by Return, or the one whose help begins with the name, types it, and waits
    for the verdict."""
    screen.keys("Return")
    screen.until(lambda s: s["focus"] == "panel")
    for _ in range(60 if name else 0):
        if (screen.state()["focus_help"] or "").startswith(name):
            break
        screen.keys("Tab")
    screen.keys("Return")
    screen.until(lambda s: s["types"])
    screen.keys("ctrl+a")
    screen.type(text)
    screen.keys("Return")
    return wait(screen, lambda s: not s["types"] and judged(s) and s["focus"] == "view")


def apart(boxes):
    return all(a is b or a[0] > b[2] - 1 or b[0] > a[2] - 1 or a[1] > b[3] - 1 or b[1] > a[3] - 1
               for a in boxes for b in boxes)


def begin(name, minutes=5):
    """Opens a lesson and presentation mode."""
    screen = Screen(name, lesson(name), "--size", "1280x720", minutes=minutes)
    screen.keys("F5")
    now = screen.until(lambda s: s["present"] and not s["answer"]["stale"])
    check(now["lesson"]["step"] == 1, f"{name}: begins at its first step", now["lesson"])
    return screen


def picture(screen, name, what):
    """Keeps a picture of the screen, if somebody wants to look at it."""
    kept = os.environ.get("CLEARANCE_SCREENS")
    if kept:
        shutil.copy(screen.shot(what), pathlib.Path(kept) / f"{name}-{what}.png")


def guess(screen, name, digits, hands):
    """Counts hands, or types numbers, at the second step, and goes on to what is to be watched."""
    picture(screen, name, "1")
    screen.keys("Next")
    now = step(screen, 2)
    check(now["lesson"]["hides"] and not now["playing"], f"{name}: nothing plays before the guess")
    screen.keys(*digits)
    now = screen.state()
    check((now["lesson"]["numbers"] or now["lesson"]["hands"]) == hands, f"{name}: the hands are counted", now["lesson"])
    check(not now["frame"]["plots"] and now["frame"]["panel"][2] == now["frame"]["panel"][0],
          f"{name}: neither plot nor panel tells the result")
    picture(screen, name, "2")
    screen.keys("Next")
    step(screen, 3)
    now = wait(screen, lambda s: not s["answer"]["stale"] and s["playing"])
    check(now["playing"] and now["lesson"]["hides_words"], f"{name}: it plays, and the class says what it sees")
    picture(screen, name, "3")


def watch(screen, name, wrong, right):
    """Answers what was seen, first wrongly."""
    screen.keys(wrong)
    check(screen.state()["lesson"]["chosen"] == int(wrong), f"{name}: a wrong answer is taken")
    picture(screen, name, "3-wrong")
    screen.keys(right)
    now = screen.state()["lesson"]
    check(now["chosen"] == int(right) and not now["hides_words"], f"{name}: and can be mended", now)
    picture(screen, name, "3-right")
    screen.keys("Next")


def goal(screen, name, words, expected, what):
    """Waits for the verdict on a state; for a reached goal, also on later ones."""
    now = wait(screen, lambda s: judged(s) and (expected == "no" or s["lesson"]["goal"] == "yes"))
    check(now["lesson"]["goal"] == expected, f"{name}: {words}", (now["lesson"], now["answer"]))
    picture(screen, name, what)


def finish(screen, name, last):
    """Goes to the last card, and ends."""
    screen.keys("Next")
    wait(screen, lambda s: s["lesson"]["step"] == last - 1 and s["lesson"]["numbered"])
    screen.keys("Next")
    now = screen.until(lambda s: s["lesson"]["model"])
    check(now["lesson"]["step"] == last - 1 and now["lesson"]["numbered"],
          f"{name}: the model answer comes with its numbers", now["lesson"])
    picture(screen, name, f"{last - 1}")
    screen.keys("Next")
    check(step(screen, last)["lesson"]["step"] == last, f"{name}: the last card is reached")
    picture(screen, name, f"{last}")
    screen.end()
