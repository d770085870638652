#!/usr/bin/env python3
"""Tests reports: complete pages in one file each, well-formed, and readable with a screen reader.

report.py CLEARANCE
"""

import base64
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import xml.etree.ElementTree as tree

from program import check, end, expect, house, run, source

os.environ["SOURCE_DATE_EPOCH"] = "1700000000"
html = "{http://www.w3.org/1999/xhtml}"


def words_of(element):
    return " ".join("".join(element.itertext()).split())


def check_page(page, name):
    """The page is well-formed and self-contained, headings are in order, tables and pictures have descriptions."""
    text = page.read_text()
    root = tree.fromstring(text)
    check(root.get("lang") == "en", f"{name}: the language is told")
    check("<script" not in text and "http:" not in text.replace("http://www.w3.org/1999/xhtml", "") and "https:" not in text,
          f"{name}: needs nothing from elsewhere")
    levels = [int(e.tag[-1]) for e in root.iter() if re.fullmatch(re.escape(html) + "h[1-6]", e.tag)]
    check(levels[0] == 1 and levels.count(1) == 1 and all(b <= a + 1 for a, b in zip(levels, levels[1:])),
          f"{name}: headings are in order", levels)
    ids = {e.get("id") for e in root.iter()}
    check(all(a.get("href")[1:] in ids for a in root.iter(html + "a")), f"{name}: links lead somewhere")
    for table in root.iter(html + "table"):
        columns = len(table.findall(f"{html}thead/{html}tr/{html}th[@scope='col']"))
        check(all(len(row) == columns and row[0].get("scope") == "row" for row in table.findall(f"{html}tbody/{html}tr")),
              f"{name}: rows are as long as their head and named")
    for picture in root.iter(html + "img"):
        kind, data = picture.get("src").split(",", 1)
        begin = base64.b64decode(data, validate=True)[:8]
        check((kind, begin[:5]) == ("data:image/svg+xml;base64", b"<?xml") or
              (kind, begin) == ("data:image/png;base64", b"\x89PNG\r\n\x1a\n"), f"{name}: pictures are inside", kind)
        check(len(picture.get("alt")) > 10, f"{name}: pictures are told in words")
    return root


def check_paper(paper, title, headings, name):
    """Pages have numbers, title and headings are text, and no heading stands alone at the end of a page."""
    facts = subprocess.run(["pdfinfo", paper], capture_output=True, text=True).stdout
    count = int(re.search(r"Pages: +(\d+)", facts)[1])
    check(re.search(r"Tagged: +yes", facts) and "2023" in re.search("CreationDate: .*", facts)[0], f"{name}: properties", facts)
    pages = subprocess.run(["pdftotext", "-layout", paper, "-"], capture_output=True, text=True).stdout.split("\f")[:-1]
    check(len(pages) == count > 1, f"{name}: pages")
    check(title in " ".join(pages[0].split()), f"{name}: the title is on the first page", pages[0][:200])
    for number, page in enumerate(pages, 1):
        lines = [line.strip() for line in page.splitlines() if line.strip()]
        check(f"page {number} of {count}" in lines[-1], f"{name}: page {number} is numbered", lines[-1])
        check(lines[-2] not in headings, f"{name}: a heading alone at the end of page {number}")
    everything = " ".join(" ".join(pages).split())
    check(all(heading in everything for heading in headings), f"{name}: all headings are there")
    return everything


def report(code, *arguments):
    """Returns the report of a command: the page, all text of the page, all text on paper."""
    name = " ".join(arguments[:2])
    with tempfile.TemporaryDirectory(prefix="it's a report ") as out:
        files = [pathlib.Path(out, f"report.{end}") for end in ("html", "pdf")]
        expect(code, *arguments, "--report", "--out", out)
        first = [file.read_bytes() for file in files]
        expect(code, *arguments, "--report", "--out", out)
        check(first == [file.read_bytes() for file in files], f"{name}: the same command writes the same bytes")
        root = check_page(files[0], name)
        headings = [words_of(e) for e in root.iter() if e.tag in (html + "h2", html + "h3")]
        paper = check_paper(files[1], words_of(next(root.iter(html + "h1"))), headings, name)
        command = root.find(f".//{html}pre/{html}code").text
        pasted = subprocess.run(["sh", "-c", f"set -- {command}\nprintf '%s\\n' \"$@\""], capture_output=True, text=True).stdout
        check(pasted.splitlines()[1:] == [*arguments, "--report", "--out", out], f"{name}: the command can be pasted", command)
        return root, words_of(root), paper


def rows_of(root, heading):
    """Returns the cells of the table below a heading."""
    main = list(root.find(f".//{html}main"))
    at = next(i for i, e in enumerate(main) if e.tag[-2:-1] == "h" and words_of(e) == heading)
    table = next(e for e in main[at:] if e.find(f"{html}table") is not None)
    return [[words_of(cell) for cell in row] for row in table.iter(html + "tr")]


def check_run():
    answer = json.loads(run("run", house("ube-techno-house"), "--json").stdout)
    root, words, paper = report(0, "run", house("ube-techno-house"), "--set", "profile.manual-chair.space.friction=0.06")
    check(words_of(next(root.iter(html + "h1"))).startswith("All 4 out"), "the title is the answer")
    for said in ("assumed plan", "no measured times of these routes", "changed here, for this run", "clearance 0."):
        check(said in words and said in paper, f"the report says {said!r}")
    root, words, paper = report(0, "run", house("ube-techno-house"))
    for person, row in zip(answer["people"], rows_of(root, "Who is out")[1:], strict=True):
        check(row[0] == person["route"] and row[5] == f"{person['time']:.2f}", "times are those of the answer", row)
    hazards = rows_of(root, "Tight places")[1:]
    names = {"door d7": "washroom door"}  # as the window names it
    check([row[1] for row in hazards] == [names.get(h["what"], h["what"]) for h in answer["hindrances"]],
          "tight places are those of the answer, by their names")
    check("washroom door is door d7" in words and "door d7:" not in words, "the names are explained once")
    check(answer["digest"] in words, "the digest is that of the answer")
    numbers = {row[0]: row for row in rows_of(root, "Profile manual-chair (driver)")[1:]}
    profile = json.loads((source / "assets/profiles/manual-chair.json").read_text())
    for group in ("body", "drive", "space", "contact"):
        for name, number in profile[group].items():
            row = numbers[f"{group}.{name}"]
            check(float(row[1]) == number["value"] and row[4] == number["provenance"], "numbers are those of the profile", row)


def check_no_way():
    root, words, paper = report(1, "run", house("flat-0.910-module"))
    check("cannot pass the bedroom door" in words_of(next(root.iter(html + "h1"))), "the title says what stops, by its name")
    check("nobody could start" in words and "needs at least" in paper, "not all people are out")


def check_comparison():
    root, words, paper = report(1, "compare", house("flat-0.910-module"), house("flat-0.910-widened"))
    check(words_of(next(root.iter(html + "h1"))) == "B lets all people out, A does not", "the title compares")
    check(["door d3, width, m", "0.75", "0.83"] in rows_of(root, "Differences between the plans"), "the plans differ in d3")
    root, words, _ = report(0, "compare", house("straight-corridor"), house("straight-corridor"))
    check("None: walls, doors" in words and "in both" in words, "a house does not differ from itself")


def check_observed():
    """The observation is the simulation, shifted by 5 cm and slower by a tenth: the report must state both."""
    with tempfile.TemporaryDirectory() as out:
        expect(0, "run", house("straight-corridor"), "--out", out)
        lines = pathlib.Path(out, "trace.csv").read_text().splitlines()[1:]
        rows = [[float(cell or "nan") for cell in line.split(",")] for line in lines]
        file = pathlib.Path(out, "measured.csv")
        middle = 1.1 / 2 - 0.28 # distance of the middle ahead of the drive axle
        file.write_text("x;y;time [s]\n" + "".join(
            f"{r[2] + middle * math.cos(r[4])};{r[3] + middle * math.sin(r[4]) + 0.05};{1.1 * r[0]}\n"
            for r in reversed(rows)))
        root, words, paper = report(0, "run", house("straight-corridor"), "--observed", str(file))
        tables = [[[words_of(c) for c in row] for row in t.iter(html + "tr")] for t in root.iter(html + "table")]
        driver = next(t for t in tables if t[0][2] == "Observed, s")[2]
        check(driver[1] == "driver" and driver[4] == "-9.1 %" and driver[5] == "0.050" and float(driver[6]) < 0.06, "observed loci", driver)
        check("observed: the measured loci" in paper, "the observed locus is drawn")
        file.write_text("time,x,y,person\n0,1,1,p1\n1,2,1,p9\n2,2,1,p9\n1,2,1,p1\n")
        expect(2, "run", house("straight-corridor"), "--observed", str(file), "--report", "--out", out,
               says='measured.csv:3:1: there is no person or route "p9"')
        expect(2, "run", house("hall-10000"), "--observed", str(file), "--report", "--out", out, says="a few people in chairs")
        expect(2, "run", house("straight-corridor"), "--observed", str(file), "--out", out, says="--observed needs --report")


def check_crowd():
    root, words, paper = report(1, "run", house("hall-10000"), "--until", "0.1")
    check("people on foot have one model only" in words, "loci of a crowd are left out")
    check(all("svg" in i.get("src")[:30] or "png" in i.get("src")[:30] for i in root.iter(html + "img")), "pictures of a crowd")


def check_nobody():
    """A house without people whose name contains characters that a page must escape."""
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place, "empty.json")
        file.write_text(json.dumps({
            "format": "clearance-house", "version": 1, "name": "<nobody & 'nothing'>",
            "walls": [{"id": "w", "points": [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]}]}))
        root, words, paper = report(0, "run", str(file))
        check("<nobody & 'nothing'>" in words and "<nobody & 'nothing'>" in paper, "a name is a name")
        check("The house has no people" in words and "No person takes part" in words, "nobody takes part")


def check_wrong_use():
    expect(2, "run", house("straight-corridor"), "--report", says="--report needs --out DIR")
    expect(2, "compare", house("straight-corridor"), house("straight-corridor"), "--report", says="--report needs --out DIR")
    expect(2, "compare", house("straight-corridor"), house("straight-corridor"), "--observed", "x", says="unknown option")
    with tempfile.TemporaryDirectory() as out:
        expect(2, "run", house("straight-corridor"), "--report", "--out", out, "--observed", "nowhere.csv",
               says="nowhere.csv:1:1: cannot be read")
        os.mkdir(os.path.join(out, "report.pdf"))
        expect(2, "run", house("straight-corridor"), "--report", "--out", out, says="report.pdf cannot be written: a folder has this name")


for part in (check_run, check_no_way, check_comparison, check_observed, check_crowd, check_nobody, check_wrong_use):
    part()
end()
