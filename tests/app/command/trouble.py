#!/usr/bin/env python3
"""Tests trouble with files: pipes that nobody writes, full disks, long names, processes that are killed.

trouble.py CLEARANCE
"""

import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time

from program import check, end, program, source

corridor = source / "houses/straight-corridor.json"
SECONDS = 60  # for a process that must end by itself


def run(*arguments, **options):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, timeout=SECONDS, text=True, **options)


def waits(pid):
    """True if the process handles SIGTERM and sleeps, as it does in open or read."""
    try:
        lines = dict(line.split(":", 1) for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines())
    except FileNotFoundError:
        return False
    return int(lines["SigCgt"], 16) >> (signal.SIGTERM - 1) & 1 and lines["State"].split()[0] == "S"


def interrupt(words, number, standard_input, out):
    """Starts a process, sends it a signal once it waits for its file, and returns its exit code, answer and errors."""
    process = subprocess.Popen([program, *map(str, words)], stdin=standard_input, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, cwd=out)
    while not waits(process.pid) and process.poll() is None:
        time.sleep(0.01)
    process.send_signal(number)
    try:
        output, error = process.communicate(timeout=SECONDS)
        return process.returncode, output, error
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return None, "", "survives the signal"


def check_pipes(out):
    """A file that is read when the signal comes is not bad input: the answer is interrupted."""
    pipe = out / "pipe.json"
    os.mkfifo(pipe)
    for suffix in ("wkt", "dxf"):
        os.mkfifo(out / f"plan.{suffix}")
    reading, writing = os.pipe()  # a standard input that stays open
    plans = [["import", out / f"plan.{suffix}", out / "new.json"] for suffix in ("wkt", "dxf")]
    verbs = [["check", pipe], ["check", corridor, "--drivers", "2", "--population", pipe], ["run", pipe], ["study", pipe],
             ["study", pipe, "--vary", "door.d1.width=0.8:0.9:2"], ["study", pipe, "--follow", "drive.frequency=1:2"],
             ["study", pipe, "--types", "drive.frequency"], ["study", pipe, "--paper"], ["study", pipe, "--shake", "2"],
             ["compare", corridor, pipe], ["loci", pipe], ["ablate", pipe], ["fit", pipe, "--measured", pipe],
             ["rules", pipe], ["rules", corridor, "--rules", pipe], ["cases", pipe], ["check", "/dev/stdin"], *plans]
    for number in (signal.SIGTERM, signal.SIGINT):
        for words in [*verbs, *([*words, "--json"] for words in verbs), ["export", pipe, "--out", out / "new.svg"],
                      ["lesson", "check", pipe]]:
            code, output, error = interrupt(words, number, reading, out)
            said = "--json" not in words or \
                output.startswith("{") and json.loads(output).get("interrupted") is True and "faults" not in output
            check(code == 1 and "interrupted" in error and said, f"{words} at signal {number}: interrupted",
                  f"{code} {output} {error}")
    os.close(reading)
    os.close(writing)
    done = run("check", "/dev/stdin", input=corridor.read_text())
    check(done.returncode == 0, "a house from a pipe", done.stderr)


def check_names(out):
    """Names of the most bytes that the system allows, and what a killed process leaves."""
    for letter in ("x", "\u00e9", "\u20ac"):
        name = letter * ((255 - len(".json")) // len(letter.encode()))
        house = out / f"{name}.json"
        house.write_text(corridor.read_text())
        exported = out / f"{name}.wkt"[-255:]
        for words in (["check", house], ["run", house, "--to", "1", "--out", out / name[:120]],
                      ["export", house, "--out", exported], ["import", exported, out / f"{name[1:]}.json"]):
            done = run(*words)
            check(done.returncode == 0, f"{words[0]} with a name of {len(house.name.encode())} bytes",
                  f"{done.returncode} {done.stderr[:300]}")
        check(not [path for path in out.glob(".*")], "nothing is left")
    folder = out / "killed"
    folder.mkdir()
    left = folder / ".clearance-1-1.part"
    left.write_text("left by a killed process")
    check(run("run", corridor, "--to", "1", "--out", folder).returncode == 0 and not left.exists(), "what is left is swept")


def check_full(out):
    """Standard output and the files of --out on a full disk, which a limit and a device stand in for."""
    with open("/dev/full", "w") as full:
        done = subprocess.run([program, "check", corridor], stdout=full, stderr=subprocess.PIPE, text=True)
    check(done.returncode == 3 and "the answer cannot be written: the disk is full" in done.stderr, "a full disk",
          f"{done.returncode} {done.stderr}")
    written = out / "corridor.wkt"
    with written.open("w") as file:
        done = subprocess.run([program, "export", corridor, "--out", "/dev/stdout"], stdout=file, stderr=subprocess.PIPE,
                              text=True, timeout=SECONDS)
    check(done.returncode == 0 and written.read_text() == run("export", corridor).stdout, "an export to /dev/stdout in a file",
          f"{done.returncode} {done.stderr}")
    done = run("export", corridor, "--out", "/dev/full")
    check(done.returncode == 2 and "/dev/full cannot be written: the disk is full" in done.stderr, "a full device",
          f"{done.returncode} {done.stderr}")


def check_fonts(out):
    """Without fonts there is one warning, before pictures are written or the window opens."""
    fonts = out / "fonts.conf"
    fonts.write_text('<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd"><fontconfig></fontconfig>')
    (out / "script").write_text("quit\n")
    for words in (["run", corridor, "--to", "1", "--out", out / "plan"],
                  ["export", corridor, "--to", "svg", "--out", out / "plan.svg"],
                  ["open", corridor, "--script", out / "script"]):
        done = run(*words, env=os.environ | {"FONTCONFIG_FILE": str(fonts), "SDL_VIDEODRIVER": "offscreen", "HOME": str(out)})
        check(done.returncode == 0 and done.stderr.count("no font is installed") == 1, f"a warning of {words[0]}", done.stderr)


def check_sheets(out):
    """A lesson's sheet that cannot be written is one line, and nothing that was there is lost."""
    lesson = out / "short.json"
    lesson.write_text(json.dumps({"format": "clearance-lesson", "version": 1, "title": "short", "laboratory": "house",
                                  "level": "all", "file": str(corridor), "script": "none",
                                  "steps": [{"kind": "read", "text": "One line."}],
                                  "teacher": {"before": [], "questions": [], "mistakes": []}}))
    places = {name: out / name for name in ("file", "full", "over", "closed")}
    places["file"].write_text("kept")
    for name in ("full", "over", "closed"):
        places[name].mkdir()
        places[name].chmod(0o777)
    (places["full"] / "short.pdf").symlink_to("/dev/full")
    (places["over"] / "short.pdf").mkdir()
    (places["closed"] / "short.pdf").write_text("kept")
    (places["closed"] / "short.pdf").chmod(0o444)
    places["closed"].chmod(0o555)
    out.chmod(0o755)
    somebody = {"user": "nobody"} if os.geteuid() == 0 else {}  # root may write everywhere
    for place, says in ((places["file"], "file cannot be written: a file stands where a folder has to be"),
                        (places["full"], "full/short.pdf cannot be written: the disk is full"),
                        (places["over"], "over/short.pdf cannot be written: a folder has this name"),
                        (places["closed"], "closed cannot be written: Permission denied"),
                        (pathlib.Path("/dev/full"), "/dev/full cannot be written: a file stands where a folder has to be")):
        done = run("lesson", "sheet", lesson, "--out", place, **somebody)
        check(done.returncode == 2 and done.stderr.count("\n") == 1 and says in done.stderr and not done.stdout,
              f"a sheet into {place}", f"{done.returncode} {done.stderr}")
    check(places["file"].read_text() == "kept" and (places["closed"] / "short.pdf").read_text() == "kept" and
          (places["over"] / "short.pdf").is_dir(), "what was there is kept")
    done = run("lesson", "sheet", lesson, "--out", out / "new" / "folder")
    check(done.returncode == 0 and (out / "new" / "folder" / "short.pdf").stat().st_size > 1000, "a sheet", done.stderr)


for part in (check_fonts, check_pipes, check_names, check_full, check_sheets):
    with tempfile.TemporaryDirectory() as folder:
        part(pathlib.Path(folder))
end()
