#!/usr/bin/env python3
"""Tests files of other programs: the messages, results and errors of `import` and `export`, also for malicious files.

imports.py CLEARANCE
"""

import json
import os
import pathlib
import resource
import subprocess
import tempfile
import time
import zipfile

from program import check, end, expect, house, program, source

SECONDS = 60  # a file takes a second or two, more with sanitizers or on a busy machine
MEGABYTES = 2000  # includes the overhead of the address sanitizer
MANY = 1_000_000

bad = source / "tests/data/bad/imports"
place = tempfile.TemporaryDirectory()
folder = pathlib.Path(place.name)


def groups(*pairs):
    return "".join(f"{code}\n{value}\n" for code, value in pairs)


def line(layer, x0, y0, x1, y1):
    return groups((0, "LINE"), (8, layer), (10, x0), (20, y0), (11, x1), (21, y1))


def drawing(entities, blocks="", unit=4):
    return (groups((0, "SECTION"), (2, "HEADER"), (9, "$INSUNITS"), (70, unit), (0, "ENDSEC"), (0, "SECTION"), (2, "BLOCKS"))
            + blocks + groups((0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")) + entities + groups((0, "ENDSEC"), (0, "EOF")))


def home(elements):
    return f"<?xml version='1.0'?>\n<home version='7200'>\n{elements}\n</home>\n"


def new(name, text):
    """Writes a file with this name to the folder; for a Sweet Home 3D file the text is its Home.xml."""
    file = folder / name
    if name.endswith(".sh3d"):
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("Home.xml", text)
    else:
        file.write_text(text)
    return str(file)


def import_new(code, name, text, *options, says=""):
    """Imports a file and checks the house; returns the JSON, or None if the file is refused."""
    out = folder / "house.json"
    out.unlink(missing_ok=True)
    done = expect(code, "import", new(name, text), str(out), "--json", *options, says=says)
    check(out.exists() == (code == 0), f"{name}: a house is written when it is answered, and only then")
    if code:
        check(len(done.stderr.splitlines()) == 1, f"{name}: is refused in one line", done.stderr)
        return None
    expect(0, "check", str(out), "--json")
    answer = json.loads(done.stdout)
    check((answer["kind"], answer["file"], answer["out"]) == ("import", str(folder / name), str(out)), f"{name}: JSON", answer)
    return answer | {"house": json.loads(out.read_text())}


def left(answer):
    return {row["what"]: row["count"] for row in answer["left_out"]}


FLAT = "".join(line("A-WALL", *ends) for ends in [(0, 0, 8000, 0), (8000, 0, 8000, 6000), (8000, 6000, 0, 6000), (0, 6000, 0, 0)])
WALLS = "".join(f"<wall xStart='{a}' yStart='{b}' xEnd='{c}' yEnd='{d}' height='250' thickness='10'/>"
                for a, b, c, d in [(0, 0, 700, 0), (700, 0, 700, 400), (700, 400, 0, 400), (0, 400, 0, 0)])


def check_each_kind():
    answer = import_new(0, "flat.sh3d", home(WALLS + "<doorOrWindow name='Door' x='100' y='400' width='90' depth='10' height='210'/>"
                                             "<doorOrWindow name='Window' x='300' y='400' width='90' depth='10' height='90' elevation='90'/>"))
    check(answer["format"] == "Sweet Home 3D" and answer["taken"]["walls"] == 1 and answer["taken"]["doors"] == 1, "a home", answer)
    check(left(answer) == {"windows": 1}, "what is left out of a home", answer["left_out"])
    check(answer["house"]["note"] == "Imported from flat.sh3d (Sweet Home 3D); left out: windows (1)", "the house's note")
    answer = import_new(0, "flat.dxf", drawing(FLAT + line("FURN", 0, 0, 1, 1)))
    check(answer["taken"]["walls"] == 1 and left(answer) == {"open lines on furniture layers": 1}, "a drawing", answer)
    answer = import_new(0, "area.wkt", "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))")
    check(answer["house"]["walls"][0]["points"][0] == [0, 0] and answer["notes"], "an area", answer)
    scenario = {"name": "hall", "release": "2.4", "scenario": {"topography": {
        "attributes": {"bounds": {"x": 0, "y": 0, "width": 14, "height": 8}, "boundingBoxWidth": 0.5, "bounded": True},
        "targets": [{"id": 1, "shape": {"type": "RECTANGLE", "x": 12, "y": 2, "width": 1, "height": 4}}],
        "sources": [{"shape": {"type": "RECTANGLE", "x": 1, "y": 2, "width": 4, "height": 4}, "targetIds": [1],
                     "spawner": {"eventElementCount": 12, "constraintsTimeStart": 0, "constraintsTimeEnd": 60}}]}}}
    answer = import_new(0, "hall.scenario", json.dumps(scenario))
    check(answer["taken"]["people"] == 12 and answer["taken"]["exits"] == 1, "a scenario", answer)
    check(json.loads(expect(0, "run", str(folder / "house.json"), "--json").stdout)["completed"], "people of a scenario get out")


def check_options():
    import_new(2, "flat.dxf", drawing(FLAT, unit=6), says="8 m by 6 m in mm, 80 m by 60 m in cm, say --unit mm|cm|m|inch|ft")
    answer = import_new(0, "flat.dxf", drawing(FLAT), "--unit", "cm")
    check(answer["house"]["walls"][0]["points"][1] == [80, 0], "--unit overrides", answer["house"]["walls"])
    import_new(2, "flat.dxf", drawing(FLAT), "--layers", "walls=WALLS", says='no layer "WALLS", there are 0, A-WALL')
    import_new(2, "flat.sh3d", home(WALLS), "--level", "Cellar", says='leave out --level Cellar')
    expect(2, "import", new("flat.dxf", drawing(FLAT)), str(folder / "x.json"), "--unit", "mile", says="--unit takes mm|cm|m|inch|ft")
    expect(2, "import", new("flat.dxf", drawing(FLAT)), says="usage: clearance import FILE HOUSE")


def check_files():
    """Existing files stay, write errors are reported, and no temporary files remain."""
    flat, there = new("flat.dxf", drawing(FLAT)), folder / "there.json"
    there.write_text("mine")
    expect(2, "import", flat, str(there), says="exists and is not overwritten")
    check(there.read_text() == "mine", "a file that is there stays as it was")
    expect(2, "import", flat, str(folder / "nowhere" / "x.json"), says="cannot be written")
    expect(2, "import", str(folder / "nowhere.dxf"), str(folder / "y.json"), says="cannot be read")
    expect(2, "import", str(folder), str(folder / "y.json"), says="must end in .sh3d, .dxf, .wkt or .scenario")
    text = expect(0, "import", flat, str(folder / "flat.json")).stdout
    check(text.startswith(f"{flat} (DXF drawing)\nwalls  1\n") and text.endswith(f"written to {folder / 'flat.json'}\n"), "words", text)
    check(not list(folder.glob("*.part")), "nothing is left beside")


def check_export():
    ube = house("ube-techno-house")
    wkt = expect(0, "export", ube).stdout
    check(wkt.startswith("POLYGON ((") and wkt.endswith("))\n"), "export prints WKT", wkt[:80])
    out = folder / "ube-techno-house.wkt"
    expect(0, "export", ube, "--to", "wkt", "--out", str(folder))
    check(out.read_text() == wkt, "export --out writes the same")
    expect(2, "export", ube, "--out", str(out), says="is not overwritten")
    out.rename(folder / "area.wkt")
    expect(0, "import", str(folder / "area.wkt"), str(folder / "area.json"))
    again = expect(0, "export", str(folder / "area.json")).stdout
    check(sorted(again.replace("(", " ").replace(")", " ").replace(",", " ").split())
          == sorted(wkt.replace("(", " ").replace(")", " ").replace(",", " ").split()), "the area has the same points again", again)
    wider = expect(0, "export", ube, "--set", "door.d1.width=1.2").stdout
    check(wider != wkt, "export --set")
    expect(0, "export", ube, "--to", "svg", "--out", str(folder))
    picture = (folder / "ube-techno-house.svg").read_text()
    check(picture.startswith("<?xml") and "</svg>" in picture, "a picture")
    for ending, begin in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("PNG", b"\x89PNG")):
        file = folder / f"plan.{ending}"
        expect(0, "export", ube, "--out", str(file))
        check(file.read_bytes().startswith(begin), f"export --out {file.name} writes what the name says")
    expect(2, "export", ube, "--out", str(folder / "plan.jpg"), says="ends in none of .wkt, .svg, .pdf and .png")
    check(not (folder / "plan.jpg").exists(), "nothing is written by an unknown ending")
    expect(0, "export", ube, "--to", "wkt", "--out", str(folder / "plan.jpg"))
    expect(2, "export", ube, "--to", "dwg", says="--to takes wkt|svg")
    expect(2, "export", str(source / "tests/data/bad/houses/many-faults.json"), says="many-faults.json:")


def measure(name, text):
    """Imports a malicious file; returns the exit code, the messages, seconds and MB."""
    out = folder / "hostile.json"
    out.unlink(missing_ok=True)
    begin = time.monotonic()
    process = subprocess.Popen([program, "import", new(name, text), str(out)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (2 * SECONDS, 2 * SECONDS)))
    said = process.stderr.read().decode()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, said, time.monotonic() - begin, usage.ru_maxrss / 1024


def hurt(name, text, code, says=""):
    got, said, seconds, megabytes = measure(name, text)
    lines = said.splitlines()
    check(got == code, f"{name}: exit code {got}, expected {code}", said[:300])
    check(says in said and len(lines) == (code == 2), f"{name}: says {said[:300]!r}, expected {says!r}")
    check(seconds < SECONDS and megabytes < MEGABYTES, f"{name}: {seconds:.1f} s, {megabytes:.0f} MB")


def check_hostile():
    bomb = "<home>" + " " * 60_000_000 + "</home>"
    hurt("bomb.sh3d", bomb, 2, "compressed more than 200 times")
    hurt("large.sh3d", bomb + " " * 10_000_000, 2, "larger than 64 MB")
    laughs = "".join(f"<!ENTITY l{i + 1} '{f'&l{i};' * 10}'>" for i in range(10))
    hurt("laughs.sh3d", f"<!DOCTYPE home [<!ENTITY l0 'ha'>{laughs}]><home>&l9;</home>", 2, "declares the entity")
    hurt("deep.sh3d", "<home>" + "<furnitureGroup>" * 60_000, 2, "nested too deeply")
    hurt("walls.sh3d", home("".join(f"<wall xStart='{i}' yStart='{i % 7919}' xEnd='1' yEnd='0'/>" for i in range(300_000))), 2, "more than")
    hurt("doors.sh3d", home(WALLS + "<doorOrWindow x='1' y='1' width='90' depth='10' height='210'/>" * 10_000), 2, "more than 2000 doors")
    hurt("star.sh3d", home("".join(f"<wall xStart='0' yStart='0' xEnd='{i}' yEnd='99999'/>" for i in range(30_000))), 0)
    hurt("lines.dxf", drawing("".join(line("WALL", i, i * 7919 % 100_003, i + 5, 9) for i in range(200_000))), 2, "more than")
    hurt("one-line.dxf", drawing(line("WALL", 0, 0, 8000, 6000) * 200_000), 0)
    hurt("layers.dxf", drawing("".join(line(f"L{i}", 0, 0, 1, 1) for i in range(5000))), 2, "more than 1000 layers")
    nested = "".join(groups((0, "BLOCK"), (2, f"B{i}"), (10, 0), (20, 0))
                     + groups((0, "INSERT"), (2, f"B{i + 1}"), (10, 0), (20, 0)) * 50
                     + groups((0, "ENDBLK")) for i in range(15))
    hurt("blocks.dxf", drawing(groups((0, "INSERT"), (2, "B0"), (10, 0), (20, 0)), nested), 2, "blocks hold more than")
    grid = groups((0, "INSERT"), (8, "WALL"), (2, "B0"), (10, 0), (20, 0), (70, 2_000_000), (71, 2_000_000))
    hurt("grid.dxf", drawing(grid, groups((0, "BLOCK"), (2, "B0"), (0, "ENDBLK"))), 2, "blocks are put in more than")
    arcs = groups((0, "ARC"), (8, "DOOR"), (10, 5000), (20, 0), (40, 900), (50, 0), (51, 90))
    hurt("doors.dxf", drawing(FLAT + arcs * 30_000), 2, "more than 2000 arcs")
    hurt("deep.wkt", "GEOMETRYCOLLECTION (" * 500_000, 2, "nested too deeply")
    comb = ", ".join(f"POLYGON (({i / 50} 0, {i / 50 + .01} 0, {i / 50 + .01} 99, {i / 50} 99, {i / 50} 0)), POLYGON ((0 {i / 50}, 99 {i / 50}, 99 {i / 50 + .01}, 0 {i / 50 + .01}, 0 {i / 50}))"
                     for i in range(4000))
    hurt("comb.wkt", f"GEOMETRYCOLLECTION ({comb})", 2, "too many places")
    hurt("long.wkt", "POLYGON ((" + ", ".join(f"{i} {i % 3}" for i in range(MANY)) + "))", 2)
    hurt("brackets.wkt", "(" * 20 + ")" * 20 + " POINT (1 1)" * 300_000, 2)
    hurt("deep.scenario", "[" * MANY, 2, "nested too deeply")
    shape = {"shape": {"type": "RECTANGLE", "x": 1, "y": 1, "width": 2, "height": 2}}
    frame = {"attributes": {"bounds": {"x": 0, "y": 0, "width": 14, "height": 8}, "boundingBoxWidth": 0.5}}
    hurt("obstacles.scenario", json.dumps({"scenario": {"topography": frame | {"obstacles": [shape] * 200_000}}}), 2, "more than")
    people = [{"type": "PEDESTRIAN", "position": {"x": 3, "y": 3}, "targetIds": [1]}] * 100_000
    hurt("people.scenario", json.dumps({"scenario": {"topography": frame | {"dynamicElements": people}}}), 2, "more than 2000 people")


for part in (check_each_kind, check_options, check_files, check_export, check_hostile):
    part()
place.cleanup()
end()
