#!/usr/bin/env python3
"""Tests that no character of a name acts on the terminal, in any verb: each is shown by its number.

letters.py CLEARANCE
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

from program import check, end, program, source

SECONDS = 100
ACTING = "\r\x1b[31m\x9b1m\u202edcba\u202c\u2066x\u2069\u200f\u200b\x7f\ufeff\U000e0041\x07\u034f\u3164\ufe0f\U000e0100"
# the characters of engine/base/visible.c
ACTS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\xad\u034f\u061c\u115f-\u1160\u17b4-\u17b5\u180e\u200b-\u200f\u2028-\u202e"
                  "\u2060-\u206f\u3164\ufe00-\ufe0f\ufeff\uffa0\ufff9-\ufffb\U0001d173-\U0001d17a"
                  "\U000e0000-\U000e007f\U000e0100-\U000e01ef]")
PROGRESS = re.compile(r"\r *\r|\r(simulated|types:|picture|\d+ of|\d+ changed)[^\r\n\x1b]*")
work = tempfile.mkdtemp()


def name_all(value):
    """Returns the value with the characters in each name and note."""
    if isinstance(value, list):
        return [name_all(element) for element in value]
    if isinstance(value, dict):
        return {key: element + ACTING if key in ("name", "note", "source") and isinstance(element, str) else name_all(element)
                for key, element in value.items()}
    return value


def expect(code, *words, progress=False):
    """Runs a verb, which ends with the code; nothing that it prints acts, but for the line of progress."""
    done = subprocess.run([program, *map(str, words)], capture_output=True, timeout=SECONDS, cwd=work,
                          env=os.environ | ({"CLEARANCE_PROGRESS": "1"} if progress else {}))
    what = f"{words[0]!a} {' '.join(str(word) for word in words[2:])!a}"
    check(done.returncode == code, f"{what}: exit code {done.returncode}, not {code}",
          ascii((done.stdout + done.stderr)[-300:].decode()))
    for stream, output in (("output", done.stdout), ("errors", done.stderr)):
        text = output.decode()
        if progress and stream == "errors":
            text = PROGRESS.sub("", text)
        found = ACTS.search(text)
        check(not found, f"{what}: {stream} with {found and found[0]!a}", ascii(text[:300]))
    return done.stdout.decode(), done.stderr.decode()


# kind, file, and rows: exit code, whether --out is needed, the verb and its options
VERBS = (
    ("house", "houses/straight-corridor.json", (
        (0, False, "check"), (0, False, "check", "--suggest"), (0, False, "run"), (0, True, "run", "--report"),
        (0, True, "study", "--runs", "2"), (0, True, "study", "--vary", "profile.manual-chair.width=0.6:0.7:2"),
        (0, False, "study", "--types", "person.p1.at.x"), (0, False, "loci"), (0, True, "export"),
        (0, True, "export", "--to", "svg"), (2, False, "study", "--set", "person.p1.at=1"))),
    ("shaken", "houses/bedroom-after-earthquake.json", ((0, True, "study", "--shake", "2", "--report"),)),
    ("beam", "assets/beams/ibs.json", (
        (0, False, "run", "--set", "run.transient_cycles=20", "--set", "run.cycles=20", "--set", "beam.modes=2"),
        (2, False, "check"), (0, True, "study", "--vary", "drive.frequency=290:300:2"), (2, False, "export"))),
)


def check_verbs(out):
    for kind, given, rows in VERBS:
        file = out / f"{kind}{ACTING}.json"
        file.write_text(json.dumps(name_all(json.loads((source / given).read_text())), ensure_ascii=False))
        for number, (code, has_out, verb, *more) in enumerate(rows):
            for form in ([], ["--json"]) if verb != "export" else ([],):
                expect(code, verb, file, *more, *form,
                       *(["--out", out / f"{kind}{ACTING}{number}{len(form)}"] if has_out else []))
        if kind == "house":
            expect(0, "run", file, progress=True)
            expect(0, "compare", file, file)
        bad = json.loads(file.read_text())
        for key in ("walls", "people", "sections"):
            for element in bad.get(key, []):
                element["id"] = ACTING
        bad["beam" + ACTING] = 1
        file.write_text(json.dumps(bad, ensure_ascii=False))
        expect(2, "run" if kind == "beam" else "check", file)
    pages = list(out.rglob("report.html"))
    check(len(pages) == 4, "the reports of a run and of shakes are written", len(pages))
    for page in pages:
        check(not ACTS.search(page.read_text()), "the report", page.name)


def check_cases(out):
    shutil.copy(source / "houses/straight-corridor.json", out / f"house{ACTING}.json")
    case = {"format": "clearance-case", "version": 1, "id": "out", "suite": "own", "title": "leaves", "note": "a note" + ACTING,
            "house": f"house{ACTING}.json", "checks": [{"measure": "out", "low": 1, "unit": "1"}]}
    file = out / f"case{ACTING}.json"
    for title, id_, code in (("leaves" + ACTING, "out", 0), ("leaves", "out" + ACTING, 2)):
        file.write_text(json.dumps(case | {"title": title, "id": id_}, ensure_ascii=False))
        expect(code, "cases", file)
        expect(code, "cases", file, "--json")
    file.write_text(json.dumps(case | {"house": "missing" + ACTING}, ensure_ascii=False))
    expect(2, "cases", file)


def check_imports(out):
    text = out / f"plan{ACTING}.wkt"
    text.write_text("POLYGON ((0 0, 6 0, 6 3, 0 3, 0 0))")
    expect(0, "import", text, out / f"made{ACTING}.json")
    expect(2, "import", text, out / f"missing{ACTING}" / "made.json")
    text.write_text("POLYGON ((0 0, 6 0" + ACTING)
    expect(2, "import", text, out / "made.json")


def check_words(out):
    for words in ((ACTING,), ("check", ACTING), ("help", ACTING), ("schema", ACTING), ("run", "--" + ACTING),
                  ("run", source / "houses/straight-corridor.json", "--set", ACTING + "=1"), ("cases", ACTING),
                  ("import", ACTING + ".dxf", "x.json"), ("run", source / "houses/straight-corridor.json", "--route", ACTING)):
        expect(2, *words)
    error = expect(2, "check", "\x1b[2J\x07\x7f\n.json")[1]
    check(error.startswith("\\u001b[2J\\u0007\\u007f\\u000a.json:1:1: ") and error.count("\n") == 1, "the name is shown", error)


def check_lines(out):
    """Faults and notes show each character by its number, and stay one line."""
    sign, shown = "a\x1b\x07\x7f\n\tz", "a\\u001b\\u0007\\u007f\\u000a\\u0009z"
    plan = json.loads((source / "houses/straight-corridor.json").read_text())
    file = out / "house.json"
    for change in ({sign: 1}, {"furniture": [{"id": sign, "centre": [1, 1], "size": [1, 1]}]},
                   {"people": [plan["people"][0] | {"profile": sign}]}):
        file.write_text(json.dumps(plan | change))
        text, error = expect(2, "check", file)
        check(error.count("\n") == 1 and shown in error, f"the fault shows {list(change)[0]!a}", ascii(error))
        faults = json.loads(expect(2, "check", file, "--json")[0])["faults"]
        check(faults == error.splitlines(), "JSON has the same line", ascii(faults))
    file.write_text(json.dumps(plan | {"furniture": [{"id": "f1", "name": sign, "centre": [0.1, 0], "size": [0.3, 0.3]}]}))
    text, _ = expect(0, "check", file)
    notes = [line for line in text.splitlines() if line.startswith("note: ")]
    check(len(notes) == 1 and shown in notes[0], "the note shows the name", ascii(text))
    check(["note: " + note for note in json.loads(expect(0, "check", file, "--json")[0])["notes"]] == notes, "so does JSON")
    file.write_text(json.dumps(plan | {"furniture": [{"id": "f1", "name": sign, "centre": [6, 0.6], "size": [11, 1.19]}],
                                       "people": [{"id": "p1", "profile": "adult", "at": [0.25, 0.6]}]}))
    text, _ = expect(1, "check", file, "--suggest")
    check(f"note: it would help to take {shown} (f1) away;" in text, "the note of --suggest shows the name", ascii(text))
    drawing = out / f"{sign}.dxf"
    groups = ("0 SECTION 2 ENTITIES 0 LINE 8 WALL 10 0 20 0 11 8 21 0 0 LINE 8 GRID\x1b\x7f 10 0 20 0 11 8 21 0 0 ENDSEC 0 EOF").split()
    drawing.write_text("\n".join(groups) + "\n")
    text, _ = expect(0, "import", drawing, out / "made.json", "--unit", "m")
    check("lines on layer GRID\\u001b\\u007f" in text, "what is left out shows its layer", ascii(text))
    note = json.loads((out / "made.json").read_text())["note"]
    check(note.startswith(f"Imported from {shown}.dxf"), "the note of the house shows the file", ascii(note))


def check_data(out):
    """In JSON the characters are the same as in the file."""
    file = out / "house.json"
    shutil.copy(source / "houses/straight-corridor.json", file)
    named = out / "house\u202e.json"
    file.rename(named)
    text, _ = expect(0, "check", named, "--json")
    check(json.loads(text)["people"], "the answer is JSON", text[:300])


for part in (check_verbs, check_cases, check_imports, check_words, check_lines, check_data):
    with tempfile.TemporaryDirectory() as folder:
        part(pathlib.Path(folder))
shutil.rmtree(work)
end()
