#!/usr/bin/env python3
"""Gives the seven lessons that lessons.py does not, each once from the first card to the last by real keys, in
presentation mode at 1280 x 720: the class guesses, watches, answers wrongly and then rightly, tries the obvious wrong
way, and does what the last hint says. Names of lessons as further arguments: only those."""

import sys

from classroom import begin, finish, goal, guess, judged, picture, select, step, type_number, watch
from stage import check, end


def press(screen, key, times):
    for _ in range(times):
        screen.keys(key)


def hints(screen, name):
    screen.keys("question", "question", "question")
    check(screen.state()["lesson"]["hints"] == 3, f"{name}: ? shows three hints")
    picture(screen, name, "4-hints")


def smallest_corner(screen, name):
    guess(screen, name, ("0", "comma", "6", "5", "Return", "0", "period", "9", "5", "BackSpace", "Return"), [0.65, 0.9])
    watch(screen, name, "1", "2")
    goal(screen, name, "the corner as it is does not reach the goal", "no", "4")
    check(select(screen, "block"), f"{name}: Tab comes to the block")
    press(screen, "Right", 5)
    goal(screen, name, "one corridor alone is not enough", "no", "4-wrong")
    hints(screen, name)
    press(screen, "Down", 5)
    goal(screen, name, "the arrow keys of the hint reach the goal", "yes", "4-goal")
    screen.keys("Next")
    step(screen, 5)
    goal(screen, name, "this corner is not too narrow", "no", "5")
    check(select(screen, "block"), f"{name}: Tab comes to the block again")
    press(screen, "Right", 10)
    press(screen, "Down", 10)
    goal(screen, name, "0.85 m is", "yes", "5-goal")
    screen.keys("Prior")
    step(screen, 4)
    goal(screen, name, "going back restores the corner that was enough", "yes", "4-back")
    screen.keys("Next")
    step(screen, 5)
    screen.keys("Next")
    step(screen, 6)
    picture(screen, name, "6-compare")
    finish(screen, name, 8)


def shortest_not_fastest(screen, name):
    guess(screen, name, ("1", "3", "3"), [1, 0, 2])
    watch(screen, name, "1", "2")
    goal(screen, name, "B goes round at first", "no", "4")
    check(select(screen, "counter"), f"{name}: Tab comes to the counter")
    press(screen, "Up", 3)
    goal(screen, name, "3 cm are not enough", "no", "4-wrong")
    hints(screen, name)
    press(screen, "Up", 13)
    goal(screen, name, "the 16 presses of the hint reach the goal", "yes", "4-goal")
    finish(screen, name, 6)


def which_wardrobe(screen, name):
    texts = [text["string"] for text in screen.state()["text_in_view"]]
    check(all(piece in texts for piece in ("wardrobe", "bookshelf", "chest")), f"{name}: each piece has its name", texts)
    screen.keys("shift+t")
    now = screen.state()
    check("guesses first" in (now["message"] or "") and not now["unsaved"], f"{name}: no shake before the guess",
          now["message"])
    guess(screen, name, ("1", "1", "4"), [2, 0, 0, 1])
    press(screen, "shift+t", 3)
    watch(screen, name, "2", "1")
    goal(screen, name, "nothing is fixed at first", "no", "4")
    now = screen.state()["parameters"]
    check(not any(now[f"furniture.{piece}.toppled"] for piece in ("wardrobe", "bookshelf", "dresser")),
          f"{name}: the task begins with everything upright", now)
    check(select(screen, "wardrobe"), f"{name}: Tab comes to the wardrobe")
    type_number(screen, "0", "falls with probability")
    goal(screen, name, "the wardrobe by the door alone is not enough", "no", "4-wrong")
    hints(screen, name)
    check(select(screen, "bookshelf"), f"{name}: Tab comes to the bookshelf")
    type_number(screen, "0", "falls with probability")
    goal(screen, name, "with the bookshelf, too, it is", "yes", "4-goal")
    screen.keys("Next")
    step(screen, 5)
    picture(screen, name, "5")
    finish(screen, name, 7)


def two_doors_locked(screen, name):
    guess(screen, name, ("1", "2", "3", "4", "3"), [1, 1, 2, 1])
    watch(screen, name, "1", "2")
    goal(screen, name, "two doors of 1 m are not enough", "no", "4")
    check(select(screen, "door east", "shift+Tab"), f"{name}: Shift+Tab comes to door east")
    type_number(screen, "1.6")
    goal(screen, name, "60 cm at one door are not enough", "no", "4-wrong")
    hints(screen, name)
    type_number(screen, "1.3")
    check(select(screen, "door west", "shift+Tab"), f"{name}: Shift+Tab comes to door west")
    type_number(screen, "1.3")
    goal(screen, name, "30 cm at each are", "yes", "4-goal")
    finish(screen, name, 6)


def twice_the_push(screen, name):
    guess(screen, name, ("1", "2", "3", "4"), [1, 1, 1, 1])
    texts = [text["string"] for text in screen.state()["text_in_view"]]
    check(any(text.startswith("0.254") for text in texts), f"{name}: what plays has the doubled gap from its beginning", texts)
    watch(screen, name, "3", "1")
    goal(screen, name, "the doubled force is too large", "no", "4")
    type_number(screen, "100", "Force")
    goal(screen, name, "the push alone changes the ratio", "no", "4-wrong")
    hints(screen, name)
    type_number(screen, "0.05644", "Gap")
    goal(screen, name, "push and gap together reach the goal", "yes", "4-goal")
    finish(screen, name, 6)


def one_per_cent(screen, name):
    guess(screen, name, ("1", "2", "3", "4", "1"), [2, 1, 1, 1])
    watch(screen, name, "2", "1")
    goal(screen, name, "at 290 Hz the change is too small", "no", "4")
    type_number(screen, "259")
    goal(screen, name, "on the other flank it hits harder", "no", "4-wrong")
    hints(screen, name)
    type_number(screen, "270")
    goal(screen, name, "270 Hz reaches the goal", "yes", "4-goal")
    finish(screen, name, 6)


def one_per_cent_faster(screen, name):
    guess(screen, name, ("1", "2", "3", "4", "1"), [2, 1, 1, 1])
    watch(screen, name, "2", "1")
    step(screen, 4)
    picture(screen, name, "4")
    screen.keys("Next")
    goal(screen, name, "with a loose joint the force changes too much", "no", "5")
    type_number(screen, "0.15", "Clearance")
    goal(screen, name, "more play is not better", "no", "5-wrong")
    hints(screen, name)
    type_number(screen, "0.02", "Clearance")
    goal(screen, name, "less play is", "yes", "5-goal")
    finish(screen, name, 7)


played = (smallest_corner, shortest_not_fastest, which_wardrobe, two_doors_locked, twice_the_push, one_per_cent,
          one_per_cent_faster)
for give in played:
    name = give.__name__.replace("_", "-")
    if not sys.argv[2:] or name in sys.argv[2:]:
        give(begin(name, minutes=40), name)
end()
