#!/usr/bin/env python3
"""Tests lessons on the command line: every goal is reached and missed as its script says, and sheets have the same bytes.

lessons.py CLEARANCE [--all]: with the lesson that takes a minute of processor time, and its sheet, too
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from program import check, end, expect, source

listed = expect(0, "lesson", "list").stdout
names = sorted(path.stem for path in (source / "assets/lessons").glob("*.json"))
check(len(names) >= 8 and all(name in listed for name in names), f"list: {listed}")

every = "--all" in sys.argv
tried = [name for name in names if every or name != "one-per-cent-faster"]
checked = expect(0, "lesson", "check", *tried, patience=1800).stdout
check(checked.count("expectations of its script are met") == len(tried) >= len(names) - 1, f"check: {checked}")
check(checked.count("the goal of step") >= len(tried), f"goals: {checked}")

with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    sheets = {}
    for turn in ("first", "second"):
        for name in ("legal-no-way", "half-the-rhythm"):
            for more in ([], ["--answers"]):
                expect(0, "lesson", "sheet", name, *more, "--out", str(folder / turn))
        sheets[turn] = {path.name: path.read_bytes() for path in (folder / turn).glob("*.pdf")}
    check(len(sheets["first"]) == 4 and sheets["first"] == sheets["second"], "the sheets differ")

    if every:  # a pupil's sheet does not tell what the class guesses first
        sheet = folder / "first" / "one-per-cent-faster.pdf"
        expect(0, "lesson", "sheet", "one-per-cent-faster", "--out", str(sheet.parent), patience=1800)
        words = subprocess.run(["pdftotext", "-layout", str(sheet), "-"], capture_output=True, text=True).stdout
        check("We guessed" in words and "51" not in words, f"the sheet for pupils tells the result: {words}")

    # A script that expects what is not so is found out.
    copy = folder / "lessons"
    shutil.copytree(source / "assets/lessons", copy)
    (folder / "beams").symlink_to(source / "assets/beams")
    script = copy / "twice-the-push.script"
    script.write_text(script.read_text().replace("lesson.goal no", "lesson.goal yes", 1))
    expect(1, "lesson", "check", str(copy / "twice-the-push.json"), says="lesson.goal is \"no\", expected yes")
    script.write_text("key PageDown\n")
    expect(1, "lesson", "check", str(copy / "twice-the-push.json"), says="no attempt at the task of step 4 fails")

    # A right option or a sentence that a number no longer supports is found out.
    told = json.loads((copy / "twice-the-push.json").read_text())
    alone = next(number for number in told["numbers"] if number["name"] == "alone")
    alone["high"] = 1.5
    (copy / "twice-the-push.json").write_text(json.dumps(told))
    expect(1, "lesson", "check", str(copy / "twice-the-push.json"), says="the lesson holds only if it is at most 1.5")

# A script that changes what the lesson has locked is found out.
with tempfile.TemporaryDirectory() as folder:
    short = pathlib.Path(folder) / "short.json"
    short.write_text(json.dumps({"format": "clearance-lesson", "version": 1, "title": "t", "laboratory": "house", "level": "all",
                                 "file": str(source / "houses/straight-corridor.json"), "script": "s", "lock": ["people"],
                                 "steps": [{"kind": "read", "text": "One."}], "teacher": {"before": []}}))
    (short.parent / "s").write_text("set person.p1.heading 5\n")
    expect(1, "lesson", "check", str(short), says="s:1:1: set: person.p1.heading is locked in this lesson: people")

# A goal that asks what was guessed and selected.
with tempfile.TemporaryDirectory() as folder:
    asked = pathlib.Path(folder) / "asked.json"
    asked.write_text(json.dumps({"format": "clearance-lesson", "version": 1, "title": "t", "laboratory": "house", "level": "all",
                                 "file": str(source / "houses/straight-corridor.json"), "script": "s", "teacher": {"before": []},
                                 "steps": [{"kind": "predict", "ask": "How far?", "unit": "m", "answer": 7},
                                           {"kind": "task", "text": "Do it.", "hints": ["a", "b", "c"], "done": "Done.",
                                            "goal": [{"measure": "answer", "unit": "m", "low": 5, "high": 6},
                                                     {"measure": "selected", "unit": "1", "is": "person p1"}]}]}))
    (asked.parent / "s").write_text("key 5\nkey Return\nkey 9\nkey Return\nkey PageDown\nexpect lesson.goal no\n"
                                    'select "person p1"\nexpect lesson.goal yes\n')
    check("2 expectations" in expect(0, "lesson", "check", str(asked)).stdout, "a goal of a person")

expect(2, "lesson", "lsit", says="did you mean list?")
expect(2, "lesson", "sheet", "legal-no-way", says="needs the NAME or FILE")
expect(2, "lesson", "check", str(source / "tests/data/bad/lessons/truth-beyond.json"), says="truth is 3")
end()
