"""Interrupts every verb at the n-th poll of the stop, and fails its n-th allocation and its n-th write.

    inject.py PROGRAM LIBRARY [--full] [--only WORD]

PROGRAM is tests/clearance-interrupting of a build folder, LIBRARY its tests/failing.so. An interrupted verb says so with
exit code 1, or gives the complete answer to the bit; it never says a no that the complete answer does not say. A verb
that lacks memory or room on the disk says so with exit code 2 or 3, or gives the complete answer; under its final name no
file is damaged. Without --full the points are the first and the last ones, and others at a stride, and the paper's page,
which takes minutes, is left out."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zlib

program, library = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
full = "--full" in sys.argv
only = sys.argv[sys.argv.index("--only") + 1] if "--only" in sys.argv else ""
source = pathlib.Path(os.environ.get("CLEARANCE_SOURCE", ".")).resolve()
scratch = pathlib.Path(tempfile.mkdtemp())
failures = []


def house(name):
    return str(source / "houses" / f"{name}.json")


def written(name, text):
    path = scratch / name
    path.write_text(text)
    return str(path)


def two_rooms(door, extra=""):
    """Two rooms of 3 m, a door between them, and a chair in the first one."""
    return ('{"format": "clearance-house", "version": 1, "name": "two rooms", "walls": ['
            '{"id": "w1", "points": [[0,0],[6,0],[6,3],[0,3],[0,0]], "thickness": 0.1},'
            '{"id": "w2", "points": [[3,0],[3,3]], "thickness": 0.1}],'
            f'"doors": [{{"id": "d1", "wall": "w2", "at": 1.5, "width": {door}}},'
            '{"id": "d2", "wall": "w1", "segment": 1, "at": 1.5, "width": 1}],'
            '"exits": [{"id": "e1", "from": [6,1], "to": [6,2]}],'
            f'"people": [{{"id": "p1", "profile": "manual-chair", "at": [1,1.5]}}]{extra}}}')


def small_rooms(door, profile="manual-chair"):
    """Two rooms hardly larger than a chair, so that a search ends soon."""
    return ('{"format": "clearance-house", "version": 1, "name": "two small rooms", "walls": ['
            '{"id": "w1", "points": [[0,0],[3.6,0],[3.6,1.4],[0,1.4],[0,0]], "thickness": 0.1},'
            '{"id": "w2", "points": [[1.8,0],[1.8,1.4]], "thickness": 0.1}],'
            f'"doors": [{{"id": "d1", "wall": "w2", "at": 0.7, "width": {door}}},'
            '{"id": "d2", "wall": "w1", "segment": 1, "at": 0.7, "width": 1}],'
            '"exits": [{"id": "e1", "from": [3.6,0.2], "to": [3.6,1.2]}],'
            f'"people": [{{"id": "p1", "profile": "{profile}", "at": [0.6,0.7]}}], "run": {{"reversals": 0}}}}')


wide = written("wide.json", two_rooms(0.9))
tight = written("tight.json", small_rooms(0.55))
snug = written("snug.json", small_rooms(0.8))
walker = written("walker.json", small_rooms(0.9, "adult"))
walkers = written("walkers.json", small_rooms(0.3, "adult"))
crowd = written("crowd.json", two_rooms(0.9, ', "crowds": [{"id": "c1", "profile": "adult", "count": 3,'
                                             '"area": [[0.5,0.4],[2.5,0.4],[2.5,1],[0.5,1]]}]'))
many = written("many.json", two_rooms(0.9, ', "crowds": [{"id": "c1", "profile": "adult", "count": 40,'
                                           '"area": [[0.5,0.4],[5.5,0.4],[5.5,2.6],[0.5,2.6]]}]'))
shelf = written("shelf.json", two_rooms(0.9, ', "furniture": [{"id": "shelf", "centre": [1.8,0.2], "size": [0.8,0.3],'
                                             '"angle": 0, "height": 1.6, "topples": "front", "probability": 0.5}]'))
case = written("case.json", json.dumps({
    "format": "clearance-case", "version": 1, "id": "out", "suite": "own", "title": "the chair leaves", "note": "",
    "house": "wide.json", "checks": [{"measure": "out", "low": 1, "unit": "1"}, {"measure": "time", "low": 100, "unit": "s"}]}))
oscillator = str(source / "assets/beams/ibs.json")
short = ["--set", "run.transient_cycles=20", "--set", "run.cycles=20", "--set", "beam.modes=2"]

quiet = [*short, "--set", "drive.frequency=250", "--set", "drive.force=30"]  # a motion without contact
peaks = written("peaks.csv", "drive.frequency [Hz],peak_max [N]\n190,570\n230,700\n290,1030\n")
unconfirmed = [*short, "--lanes", "0"]  # whether chaos lasts takes thousands of cycles to see
crank = str(source / "assets/cranks/ssc.json")
stiff = ["--set", "coupler.modes=0", "--set", "coupler.axial=0", "--set", "drive.frequency=8", "--set",
         "joint.clearance=0.00002", "--set", "run.transient_cycles=2", "--set", "run.cycles=4"]  # a rod that does not bend

# name: the words of a command line; OUT is a new folder, PIC a new file in it; "images": pictures, so few points
verbs = {
    "check, yes": ["check", wide],
    "check, yes, json": ["check", wide, "--json"],
    "check, no": ["check", tight],
    "check, no, json": ["check", tight, "--json"],
    "check, corner": ["check", house("corner-0.85-0.85"), "--set", "run.reversals=0", "--json"],
    "check, flat": ["check", house("ube-techno-house"), "--json"],
    "check, walkers": ["check", walkers, "--json"],
    "check, grades": ["check", snug, "--grades"],
    "check, grades of nobody": ["check", walker, "--grades"],
    "check, suggest": ["check", tight, "--suggest"],
    "check, suggest, json": ["check", tight, "--suggest", "--json"],
    "run": ["run", crowd],
    "run, many": ["run", many],
    "run, json": ["run", crowd, "--json"],
    "run, no": ["run", tight, "--json"],
    "run, earthquake": ["run", house("bedroom-after-earthquake"), "--json"],
    "run, files": ["run", wide, "--json", "--out", "OUT"],
    "run, report": ["run", wide, "--json", "--out", "OUT", "--report"],
    "run, frames": ["run", wide, "--json", "--out", "OUT", "--frames", "2", "--size", "320x200"],
    "run, movie": ["run", wide, "--json", "--movie", "PIC.mp4", "--size", "320x200"],
    "compare": ["compare", wide, crowd],
    "compare, json": ["compare", wide, tight, "--json"],
    "compare, report": ["compare", wide, crowd, "--json", "--out", "OUT", "--report"],
    "rules": ["rules", wide],
    "rules, json": ["rules", house("corner-0.78-0.78"), "--json"],
    "loci": ["loci", house("corner-1.20-1.20"), "--json"],
    "study of a house": ["study", walker, "--vary", "door.d1.width=0.6:0.9:2", "--json"],
    "study of a house, graded": ["study", snug, "--vary", "door.d1.width=0.78:0.8:2", "--json"],
    "study of a house, files": ["study", wide, "--runs", "3", "--json", "--out", "OUT"],
    "study of a beam": ["study", oscillator, *short, "--vary", "drive.frequency=290:300:3", "--json"],
    "study of a beam, swept": ["study", oscillator, *short, "--vary", "drive.frequency=290:300:3", "--sweep", "up,down"],
    "study of a beam, thorough": ["study", oscillator, *short, "--vary", "drive.frequency=190:290:2", "--thorough", "--lanes",
                                  "0", "--json"],
    "study of a beam, basins": ["study", oscillator, *short, "--vary", "drive.frequency=290:300:2", "--runs", "3", "--json"],
    "follow": ["study", oscillator, *quiet, "--follow", "drive.force=20:40"],
    "follow, json": ["study", oscillator, *quiet, "--follow", "drive.force=20:40", "--json"],
    "follow, curves": ["study", oscillator, *short, "--set", "drive.frequency=280", "--follow", "drive.frequency=275:285",
                       "--vary", "joint.clearance=0.000126:0.000128:2", "--json"],
    "follow, touching": ["study", oscillator, *short, "--set", "drive.frequency=110", "--follow", "drive.frequency=109:111",
                         "--json"],
    "fit of a beam": ["fit", oscillator, *short, "--measured", peaks, "--fit", "shaker.moving_mass", "--json"],
    "types of a house": ["study", walker, "--types", "door.d1.width", "--json"],
    "types of a beam": ["study", oscillator, *short, "--types", "drive.frequency", "--json"],
    "shakes": ["study", shelf, "--shake", "3"],
    "shakes, json": ["study", shelf, "--shake", "3", "--json"],
    "cases": ["cases", case],
    "cases, json": ["cases", case, "--json"],
    "run of a beam": ["run", oscillator, *unconfirmed],
    "run of a beam, json": ["run", oscillator, *unconfirmed, "--json"],
    "run of a beam, files": ["run", oscillator, *unconfirmed, "--json", "--out", "OUT"],
    "run of a crank, json": ["run", crank, *stiff, "--json"],
    "paper": ["study", oscillator, *short, "--paper", "--json"],
    "export": ["export", wide, "--to", "svg", "--out", "PIC.svg"],
    "export, text": ["export", wide, "--to", "wkt"],
    "import": ["import", "WKT", "PIC.json"],
    "schema": ["schema", "house"],
}
pictures = {"run, files", "run, report", "run, frames", "run, movie", "compare, report", "study of a house, files",
            "run of a beam, files", "export"}
computes_nothing = {"export", "export, text", "import", "schema"}  # no poll
slow = {"check, suggest", "check, suggest, json", "types of a beam", "types of a house", "run of a beam",
        "run of a beam, json", "run of a beam, files", "run of a crank, json", "paper"}

# A line with one of these words says no; the complete answer must hold the same line.
NO = re.compile(r"cannot pass|cannot leave|needs at least|blocked|no exit|has no exit|not periodic|not out|no change was|"
                r"Type I|not passed|none within|Chaotic|Periodic|without a shake not|does not|nothing needs", re.I)
SAID = re.compile(r"interrupted", re.I)
DRAWS = re.compile(r"lib(cairo|pixman|harfbuzz|pango|pangocairo|pangoft2|freetype|fontconfig|glib)[-.]")


class Run:
    """What one run of the program printed and wrote."""

    def __init__(self, words, **environment):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=scratch))
        put = [w.replace("OUT", str(self.folder)).replace("PIC", str(self.folder / "made")).replace("WKT", plan)
               if w in ("OUT", "WKT") or w.startswith("PIC") else w for w in words]
        clean = {**os.environ, "LP_NUM_THREADS": "0", "G_SLICE": "always-malloc", **environment}
        try:
            one_thread = [] if put[0] in ("export", "import", "schema") else ["--jobs", "1"]
            done = subprocess.run([program, *put, *one_thread], capture_output=True, timeout=300, env=clean)
            self.code, self.hung = done.returncode, False
            self.out, self.err = (self.plain(b) for b in (done.stdout, done.stderr))
            self.failed_in = "".join(re.findall(r"^allocation failed in (.*)\n", self.err, re.M))
            self.err = re.sub(r"^allocation failed in .*\n", "", self.err, flags=re.M)
        except subprocess.TimeoutExpired:
            self.code, self.hung, self.out, self.err, self.failed_in = None, True, "", "", ""
        self.files = {str(p.relative_to(self.folder)): hashlib.sha256(self.content(p)).hexdigest()
                      for p in sorted(self.folder.rglob("*")) if p.is_file()}
        self.bytes = {f: (self.folder / f).read_bytes() for f in self.files
                      if f.endswith((".csv", ".html", ".json", ".mp4", ".pdf", ".png", ".svg"))}
        self.summary = self.bytes.get("summary.json")
        shutil.rmtree(self.folder)

    def plain(self, text):
        return text.decode(errors="replace").replace(str(self.folder), "OUT")

    def content(self, path):
        """A file without what differs from run to run: the folder's name, and when a report was made."""
        content = path.read_bytes().replace(str(self.folder).encode(), b"OUT")
        if path.suffix in (".html", ".pdf") and path.name.startswith("report"):
            cut_off = path.suffix == ".pdf" or b"interrupted" in content
            return b"report" if cut_off else re.sub(rb"\d{4}-\d\d-\d\d[ T][\d:]+", b"", content)
        return b"sqlite" if path.suffix == ".sqlite" else content

    def json(self):
        try:
            return json.loads(self.out)
        except ValueError:
            return None

    def same(self, whole):
        return (self.code, self.out, self.files) == (whole.code, whole.out, whole.files)


def fail(name, point, why, run=None):
    tail = f": {run.err.strip()[-200:]} | {run.out.strip()[:300]}" if run else ""
    failures.append(name)
    print(f"FAIL {name}, {point}: {why}{tail}", flush=True)


def plain_lines(text):
    return {" ".join(re.sub(r"[\s|-]+", " ", line).split()) for line in text.splitlines()}


def told(part, whole, path=""):
    """Yields the values of an interrupted JSON answer that differ from those of the complete one. Amounts of work done,
    and what is measured over a time, are smaller when less of it was seen, and stand beside "interrupted". A type or a
    verdict may be "interrupted", a state of its own, and never "unresolved" where the complete one is not."""
    work = {"runs", "thorough", "neighbour_runs", "stopped", "interrupted", "reason", "done", "cycles", "digest", "steps",
            "time", "suggestions_complete", "advice", "suggestion_notes"}
    if part is None or part == "interrupted" or path.rsplit(".", 1)[-1] in work:
        return
    if isinstance(part, dict) and isinstance(whole, dict):
        if part.get("reason") == "interrupted" and "trace_person" in part:
            if part["completed"] or "blocked_at" in part:
                yield path
            return
        for key, value in part.items():
            if key in work:
                continue
            if key not in whole:
                yield f"{path}.{key}"
            else:
                yield from told(value, whole[key], f"{path}.{key}")
    elif isinstance(part, list) and isinstance(whole, list):
        if path.endswith("suggestions"):
            yield from (f"{path}: {s['words']}" for s in part if s not in whole)
            return
        if path.endswith("grades"):  # those of the points that are done
            yield from (f"{path}: {grade}" for grade in part if grade not in whole)
            return
        for i, value in enumerate(part):
            yield from told(value, whole[i], f"{path}[{i}]") if i < len(whole) else [f"{path}[{i}]"]
    elif part != whole:
        yield f"{path}: {part!r} instead of {whole!r}"


def misplaced(part, whole):
    """Yields the points of interrupted branches and curves that are not on the complete ones; an end is that of the part."""
    for a, b in zip([part, *part.get("begun", [])], [whole, *whole.get("begun", [])]):
        yield from (point for point in a.get("points", []) if point["point"] != "end" and point not in b["points"])
    on_curves = [point for curve in whole.get("curves", []) for point in curve["points"]]
    yield from (point for curve in part.get("curves", []) for point in curve["points"] if point not in on_curves)


def false_in_json(part, whole):
    """The false values of an interrupted answer of any kind."""
    kind = part.get("kind")
    partial = {"house": {"hazards", "hindrances", "crowds", "routes"}, "follow": {"points", "begun", "curves", "above", "below", "left_out"},
               "fit": {"headline"}, "rules": {"headline"},
               "beam": {"peaks", "switches", "contact_share", "grazes"},
               "crank": {"peaks", "switches", "contact_share", "touches"},
               "study": {"regular", "not_regular", "cannot_be_told", "verdicts", "ranges", "best", "worst", "distribution",
                         "first_fault"},
               "shake": {"everybody_out", "time", "people", "furniture", "worst", "blocked_elsewhere", "caught"}}
    share = part.get("contact_share") if kind in ("beam", "crank") else None
    if share is not None and not 0 <= share <= 1 + 1e-12:
        return [f"contact_share: {share}"]
    if kind == "follow" and (wrong := list(misplaced(part, whole))):
        return wrong
    part = {k: v for k, v in part.items() if k not in partial.get(kind, ())}
    if kind == "compare":
        for run in "ab":
            part[run] = {k: v for k, v in part[run].items() if k not in partial["house"]}
    if kind == "cases":
        for one in part["cases"]:
            for row in [one, *one.get("checks", [])]:
                row.pop("passed") if row.get("passed") == "not run" else None
        part = {k: v for k, v in part.items() if k not in ("passed", "failed", "not_run", "summary")}
    return list(told(part, whole))


def lines_of_page(page):
    """The texts between the tags of a report."""
    text = re.sub(r"<style.*?</style>|<script.*?</script>|<svg.*?</svg>", "\n", page.decode(), flags=re.S)
    return plain_lines(re.sub(r"<[^>]*>", "\n", text))


def new_no(lines, known):
    """A line of a no that the complete answer does not say; None: there is none."""
    return next((line for line in sorted(lines - known) if NO.search(line) and not SAID.search(line)), None)


def png_ends_well(data):
    at, kind = 8, b""
    while data[:8] == b"\x89PNG\r\n\x1a\n" and at + 12 <= len(data):
        size, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        if int.from_bytes(data[at + 8 + size:at + 12 + size], "big") != zlib.crc32(data[at + 4:at + 8 + size]):
            return False
        at += 12 + size
    return kind == b"IEND" and at == len(data)


def film_ends_well(data):
    """True of boxes one after the other to the end of the file, the description of the film among them."""
    at, kinds = 0, []
    while at + 8 <= len(data):
        size = int.from_bytes(data[at:at + 4], "big")
        kinds.append(data[at + 4:at + 8])
        if size < 8:
            return False
        at += size
    return at == len(data) and b"moov" in kinds and b"mdat" in kinds


def pdf_ends_well(data):
    found = re.search(rb"startxref\s+(\d+)\s+%%EOF\s*$", data)
    return data.startswith(b"%PDF-") and found is not None and re.match(rb"xref|\d+ \d+ obj", data[int(found[1]):]) is not None


def rows_differ(part, whole):
    """True unless the rows are the first ones of the complete file; each person's last one is that of the interruption."""
    part, whole = part.decode().splitlines(), whole.decode().splitlines()
    people = len({row.split(",")[1] for row in whole[1:]}) if "person" in whole[0] else 0
    same = next((i for i, row in enumerate(part) if i >= len(whole) or row != whole[i]), len(part))
    return len(part) - same > people


def error_of_file(file, run, whole):
    """Says what is wrong with a file of an interrupted run that differs from the complete one; None: nothing."""
    data, complete = run.bytes.get(file), whole.bytes.get(file)
    if file == "made.mp4" or file.endswith(".sqlite"):
        return None  # a film ends early, and a study goes on from its file
    if data is None or complete is None:
        return "is not as in the complete answer"
    try:
        if file == "summary.json":
            wrong = false_in_json(json.loads(data), json.loads(complete))
            return f"is false: {wrong[:3]}" if wrong else None
        if file.endswith(".json"):
            json.loads(data)
        if file.endswith(".svg"):
            xml.etree.ElementTree.fromstring(data)
    except (ValueError, xml.etree.ElementTree.ParseError) as error:
        return f"is not well formed: {error}"
    if file == "trace.csv" and rows_differ(data, complete):
        return "does not begin as the complete one"
    if file.endswith(".html"):
        no = new_no(lines_of_page(data), lines_of_page(complete))
        return f"says {no!r}" if no else None
    if file.endswith(".png") and not png_ends_well(data) or file.endswith(".pdf") and not pdf_ends_well(data):
        return "is cut off"
    return None


def ends_early(file):
    """A film; or a report, which says in the place of a part that the interruption left it out."""
    return file in ("made.mp4", "report.html")


def is_temporary(file):
    """True of what a program leaves that had to end at once; SQLite reads its journal back."""
    return file.endswith((".part", "-journal")) or pathlib.Path(file).name.startswith(".")


def judge_interrupted(name, n, run, whole):
    point = f"poll {n}"
    if run.hung or run.code is None or run.code < 0:
        return fail(name, point, "hangs" if run.hung else f"ends by signal {-run.code}", run)
    if any(".part" in f for f in run.files):
        fail(name, point, f"leaves {list(run.files)}")
    if run.same(whole) and not SAID.search(run.err):
        return
    if run.code != 1 or not SAID.search(run.out + run.err):
        return fail(name, point, f"exit code {run.code}, neither complete nor interrupted", run)
    part, complete = run.json(), whole.json()
    if complete is not None:
        if part is None:
            return fail(name, point, "is no JSON", run)
        answer_is_whole = run.out == whole.out
        if not answer_is_whole and part.get("interrupted") is not True:
            return fail(name, point, "JSON differs and does not say interrupted", run)
        wrong = false_in_json(part, complete)
        if wrong:
            return fail(name, point, f"false: {wrong[:3]}", run)
    else:
        no = new_no(plain_lines(run.out), plain_lines(whole.out))
        if no:
            return fail(name, point, f"says {no!r}", run)
    partial = run.summary and json.loads(run.summary).get("interrupted")
    for file, digest in run.files.items():
        if digest == whole.files.get(file):
            continue
        if not partial and not ends_early(file) and file not in whole.partial_files:
            fail(name, point, f"{file} is not as in the complete answer", run)
        elif error := error_of_file(file, run, whole):
            fail(name, point, f"{file} {error}", run)


def judge_failed(name, point, run, whole):
    if run.hung:
        return fail(name, point, "hangs")
    if run.code is not None and run.code < 0 and name not in pictures and not re.search(r"GLib|memory", run.err):
        return fail(name, point, f"ends by signal {-run.code}", run)  # fontconfig and Mesa do not survive it either
    if run.code is not None and run.code not in (0, 1, 2, 3) and run.code >= 0:
        return fail(name, point, f"unexpected exit code {run.code}", run)
    if run.code in (0, 1) and {f for f in run.files if not is_temporary(f)} != set(whole.files):
        fail(name, point, f"exit code {run.code} with the files {sorted(run.files)} instead of {sorted(whole.files)}", run)
    if run.code in (0, 1) and (run.code != whole.code or run.out != whole.out):
        return fail(name, point, f"exit code {run.code} with another answer", run)
    if run.code in (2, 3) and not run.err.strip():
        return fail(name, point, f"exit code {run.code} without a word", run)
    for file, digest in run.files.items():
        if digest == whole.files.get(file) or is_temporary(file) or file in whole.partial_files:
            continue
        if not draws_less(file, run):
            fail(name, point, f"damages {file}", run)


def draws_less(file, run):
    """True of a whole picture drawn by a library that lacked memory: some of them leave something out without a word."""
    data = run.bytes.get(file, b"")
    return DRAWS.match(run.failed_in) and (file.endswith(".png") and png_ends_well(data) or
                                           file.endswith(".pdf") and pdf_ends_well(data) or
                                           file.endswith(".mp4") and film_ends_well(data) or
                                           file.endswith((".svg", ".html")) and data.rstrip().endswith((b"</svg>", b"</html>")))


def points(name, count, ends, between):
    """All points up to `count`, or the first and last `ends` and `between` others at a stride; and the stride."""
    if full:
        ends, between = 40 * ends, 40 * between
    if count <= 2 * ends + between:
        return list(range(1, count + 1)), 1
    stride = max(1, (count - 2 * ends) // (between + 1))
    chosen = {*range(1, ends + 1), *range(count - ends + 1, count + 1),
              *list(range(ends + stride, count - ends, stride))[:between]}
    return sorted(chosen), stride


plan = written("plan.wkt", "POLYGON ((0 0, 6 0, 6 3, 0 3, 0 0))")
preload = {"LD_PRELOAD": str(library)}
KINDS = {
    "poll": ("CLEARANCE_INJECT", "poll", {}, judge_interrupted),
    "allocation": ("CLEARANCE_FAIL", "allocation", preload, judge_failed),
    "write": ("CLEARANCE_FAIL", "write", preload, judge_failed),
}


def budget(kind, name):
    """The points at either end, and between."""
    if kind == "write":
        return (2, 3) if name in pictures else (6, 6)
    few = name in pictures or name in slow
    if kind == "allocation":
        return (1, 1) if few else (2, 3)
    return (1, 2) if few else (3, 5)


def try_verb(name):
    """Returns how many points of each kind were tried."""
    words, counted, tried = verbs[name], {}, {}
    for kind, (variable, word, more, _) in KINDS.items():
        counted[kind] = Run(words, **more, **{variable: f"{word}:count"})
    again = counted["poll"]  # counting changes nothing, but for what is said of the counts
    whole = Run(words)
    if whole.code not in (0, 1) or whole.out != again.out:
        fail(name, "twice", f"exit code {whole.code}, or another answer the second time", whole)
    whole.partial_files = {f for f in whole.files if whole.files[f] != again.files.get(f)}
    said = []
    for kind in counted:
        variable, word, more, judge = KINDS[kind]
        found = re.search(rf"{kind}s: (\d+)", counted[kind].err)
        if not found:
            fail(name, kind, "is not counted", counted[kind])
            continue
        count = int(found[1])
        if not count and (kind != "poll" or name not in computes_nothing):
            fail(name, kind, "has no point", counted[kind])
        chosen, stride = points(name, count, *budget(kind, name))
        for n in chosen:
            judge(name, n if kind == "poll" else f"{kind} {n}", Run(words, **more, **{variable: f"{word}:{n}"}), whole)
        tried[kind] = len(chosen)
        said.append(f"{len(chosen)} of {count} {kind}s, stride {stride}")
    print(f"{name}: {'; '.join(said)}", flush=True)
    return tried


def main():
    chosen = [name for name in verbs if only in name and (full or name != "paper")]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        tried = list(pool.map(try_verb, chosen))
    shutil.rmtree(scratch)
    print(f"{len(chosen)} verbs: " + ", ".join(f"{sum(t.get(kind, 0) for t in tried)} {kind}s" for kind in KINDS) +
          f" in {sum(os.times()[:4]):.0f} CPU seconds")
    print(f"{len(failures)} failures")
    sys.exit(bool(failures))


main()
