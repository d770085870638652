#!/usr/bin/env python3
"""Tests studies over many machines: shards that are lost, damaged, doubled or of another program, merged to the same
bytes as the study of one machine."""

import json
import os
import pathlib
import shutil
import signal
import sqlite3
import struct
import subprocess
import tempfile
import time

import program as of
from program import BRIEF, beam, check, end, expect, house, program

SHORT = ("--set", "run.transient_cycles=20", "--set", "run.cycles=20", "--set", "beam.modes=4")
SWEEP = (beam("ibs"), *SHORT, "--vary", "drive.frequency=285:305:21", "--vary", "joint.clearance=1e-4:2e-4:3",
         "--sweep", "reset,up,down", "--quiet")
STUDIES = {
    "a sweep with carried passes": SWEEP,
    "earthquakes": (house("bedroom-after-earthquake"), "--shake", "7", "--report", "--quiet"),
    "types": (beam("ibs"), *SHORT, "--vary", "drive.frequency=250:300:3", "--types", "drive.frequency", "--quiet"),
    "chance, thoroughly": (beam("ibs"), *BRIEF, "--runs", "9", "--thorough", "--quiet"),
    "a house of four chairs": (house("ube-techno-house"), "--vary", "person.p-a.delay=0:4:3", "--quiet"),
}


def answers(folder):
    """Returns the files of an answer by name: all but the database, and pictures with the time of their making."""
    return {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).iterdir())
            if path.suffix not in (".sqlite", ".pdf", ".html")}


def stores(folder):
    return sorted(pathlib.Path(folder).glob("study-*.sqlite"))


def split(arguments, out, count, skip=()):
    for number in range(1, count + 1):
        if number not in skip:
            done = expect(0, "study", *arguments, "--out", out, "--shard", f"{number}/{count}")
            check(done.stdout.startswith(f"shard {number} of {count}: "), "a shard says one line", done.stdout)


def lose(store, most):
    """Removes the last rows of a shard, as if its machine had died."""
    with sqlite3.connect(store) as database:
        rows = [row[0] for row in database.execute("SELECT trial FROM trial ORDER BY trial")]
        database.executemany("DELETE FROM trial WHERE trial = ?", [(row,) for row in rows[-most:]])
    database.close()
    return len(rows[-most:])


def check_same(name, arguments, folder):
    whole, parts = os.path.join(folder, "whole"), os.path.join(folder, "parts")
    one = of.run("study", *arguments, "--out", whole)
    split(arguments, parts, 3)
    check(len(list(pathlib.Path(parts).iterdir())) == 3, f"{name}: a shard writes one file")
    lose(stores(parts)[0], 2)
    stores(parts)[1].unlink()
    merged = expect(one.returncode, "study", *arguments, "--out", parts, "--merge")
    check(merged.stdout.replace(parts, whole) == one.stdout, f"{name}: the same words", merged.stdout)
    check(answers(parts) == answers(whole) and len(answers(whole)) > 2, f"{name}: the same bytes")
    again = of.run("study", *arguments, "--out", parts, "--merge", "--no-run")
    check(again.stdout == merged.stdout and again.returncode == one.returncode, f"{name}: merged again")


def check_missing(folder):
    out = os.path.join(folder, "missing")
    loud = SWEEP[:-1]
    split(SWEEP, out, 4, skip=(3,))
    sizes = [json.loads(expect(0, "study", *SWEEP, "--out", out, "--shard", f"{number}/4", "--json").stdout)["trials"]
             for number in (1, 2, 4)]
    lost = lose(stores(out)[0], 5)
    done = sum(sizes) - lost
    says = f"{done} of 189 runs are there; missing: of the shards 1 ({lost} runs), 3 ({189 - sum(sizes)} runs) of 4"
    half = expect(1, "study", *loud, "--out", out, "--merge", "--no-run", "--json", says=says)
    check(json.loads(half.stdout)["interrupted"] and json.loads(half.stdout)["done"] == done, "an incomplete answer says so")
    for store in stores(out):
        store.unlink()
    expect(0, "study", *loud, "--out", out, "--merge", says=f"{done} of 189 runs are there\n")
    nothing = os.path.join(folder, "nothing")
    expect(2, "study", *loud, "--out", nothing, "--merge", says="has no file study-I-of-N.sqlite to merge")


def check_bad_files(folder):
    """A file that cannot be used is named and left out; the others are merged."""
    out = pathlib.Path(folder, "bad")
    split(SWEEP, out, 4, skip=(1, 2, 3))
    sound = stores(out)[0].read_bytes()
    other = [word.replace("305", "304") for word in SWEEP]
    split(other, os.path.join(folder, "another"), 1)
    (out / "study-1-of-4.sqlite").write_bytes(sound[:len(sound) // 2])
    (out / "study-2-of-4.sqlite").write_bytes(b"a letter " * 1000)
    (out / "study-3-of-4.sqlite").write_bytes(b"")
    shutil.copy(stores(os.path.join(folder, "another"))[0], out / "study-1-of-1.sqlite")
    (out / "study-1-of-5.sqlite").mkdir()
    (out / "study-2-of-5.sqlite").symlink_to("/nowhere/file")
    with sqlite3.connect(out / "study-1-of-2.sqlite") as database:
        database.execute("CREATE TABLE trial (digest)")
    database.close()
    before = {path: path.read_bytes() for path in stores(out) if path.is_file()}
    done = expect(1, "study", *SWEEP, "--out", str(out), "--merge", "--no-run")
    for number, why in (("1-of-4", "is damaged"), ("2-of-4", "is not a study database"), ("3-of-4", "is empty"),
                        ("1-of-1", "is of another study"), ("1-of-5", "cannot be read: Is a directory"),
                        ("2-of-5", "cannot be read: No such file or directory"), ("1-of-2", "is another program's database")):
        check(f"clearance: not merged: {out}/study-{number}.sqlite {why}" in done.stderr, f"{number} {why}", done.stderr)
    check(done.stderr.count("\n") == 7, "one line a file", done.stderr)
    check({path: path.read_bytes() for path in stores(out) if path.is_file()} == before, "the files stay as they were")
    (out / "study-1-of-5.sqlite").rmdir()
    foreign = pathlib.Path(folder, "clearance")
    foreign.write_bytes(program.read_bytes() + b"\0")
    foreign.chmod(0o755)
    for path in stores(out):
        path.unlink()
    assets = {**os.environ, "CLEARANCE_ASSETS": str(of.source / "assets")}
    done = subprocess.run([foreign, "study", *SWEEP, "--out", out, "--shard", "1/4"], env=assets, capture_output=True)
    check(done.returncode == 0, "another program runs a shard", done.stderr)
    expect(1, "study", *SWEEP, "--out", str(out), "--merge", "--no-run", says="install the same clearance on all machines")


def change_row(store):
    """Gives a trial another result with a true digest, as a machine that computes wrongly would."""
    shift = 1 << 64
    with sqlite3.connect(store) as database:
        trial, observed, series, fault = database.execute("SELECT trial, observed, series, fault FROM trial").fetchone()
        observed = bytes([observed[0] ^ 1]) + observed[1:]
        digest = 0xcbf29ce484222325
        for part in (observed, series, (fault or "").encode() + b"\0"):
            for byte in part:
                digest = (digest ^ byte) * 0x100000001b3 % shift
            digest = (digest ^ len(part)) * 0x9e3779b97f4a7c15 % shift
        digest = (digest ^ struct.unpack("<Q", struct.pack("<d", trial))[0]) * 0x9e3779b97f4a7c15 % shift
        digest ^= digest >> 29
        digest -= shift if digest >= shift // 2 else 0
        database.execute("UPDATE trial SET observed = ?, digest = ? WHERE trial = ?", (observed, digest, trial))
    database.close()
    return trial


def check_conflict(folder):
    out = pathlib.Path(folder, "conflict")
    split(SWEEP, out, 2)
    first, second = stores(out)
    copy = out / "study-1-of-2 (copy).sqlite"
    shutil.copy(first, copy)
    expect(0, "study", *SWEEP, "--out", str(out), "--merge")
    (out / "study.sqlite").unlink()
    before = answers(out)
    trial = change_row(first)
    done = expect(3, "study", *SWEEP, "--out", str(out), "--merge", says=f"run {trial + 1} (pass reset, seed 0, "
                  "drive.frequency 285, joint.clearance 0.0001) has two results: ")
    check(str(copy) in done.stderr and str(first) in done.stderr and not done.stdout, "both files are named", done.stderr)
    check(answers(out) == before, "no answer is written")
    first.unlink()
    expect(0, "study", *SWEEP, "--out", str(out), "--merge")


def check_while_running(folder):
    """A shard is refused to a second writer, but is merged while it runs; killed, it goes on."""
    out = pathlib.Path(folder, "running")
    long = (house("ube-techno-house"), "--shake", "400", "--out", str(out), "--jobs", "1")
    shard = [program, "study", *long, "--shard", "1/1", "--quiet"]
    process = subprocess.Popen(shard, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    store = out / "study-1-of-1.sqlite"
    rows = 0
    while process.poll() is None and not rows:
        time.sleep(0.1)
        if store.exists() and store.stat().st_size > 0:
            with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
                try:
                    rows = database.execute("SELECT count(*) FROM trial").fetchone()[0]
                except sqlite3.OperationalError:  # the tables are not there yet
                    pass
            database.close()
    expect(2, "study", *long, "--shard", "1/1", says="is in use by another program")
    expect(1, "study", *long, "--merge", "--no-run", says="of 400 runs are there; missing: of the shards 1 (")
    check(process.poll() is None, "it is merged while it runs")
    process.kill()
    process.communicate()
    process = subprocess.Popen(shard[:-1], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    words = process.stderr.readline()
    process.send_signal(signal.SIGTERM)
    output, error = process.communicate()
    check("continues in" in words and "of 400 runs are done" in words, "a killed shard goes on", words)
    check(process.returncode == 1 and "interrupted after" in error, "SIGTERM saves", error)
    check(output.startswith("shard 1 of 1: "), "an interrupted shard says how far it is", output)


def check_words(folder):
    out = os.path.join(folder, "words")
    arguments = (*SWEEP[:-1], "--out", out)
    blocked = (house("flat-0.910-module"), "--vary", "door.d3.width=0.6:0.62:2", "--quiet", "--out", out)
    expect(0, "study", *blocked, "--shard", "1/1")
    expect(1, "study", *blocked, "--merge")
    for variables in ({"SLURM_ARRAY_TASK_ID": "2", "SLURM_ARRAY_TASK_COUNT": "3", "SLURM_ARRAY_TASK_MIN": "1"},
                      {"SLURM_ARRAY_TASK_ID": "1", "SLURM_ARRAY_TASK_COUNT": "3", "SLURM_ARRAY_TASK_MIN": "0"},
                      {"SGE_TASK_ID": "2", "SGE_TASK_LAST": "3", "SGE_TASK_FIRST": "1"},
                      {"OMPI_COMM_WORLD_RANK": "1", "OMPI_COMM_WORLD_SIZE": "3"}):
        expect(0, "study", *arguments, "--shard", says=f"shard 2 of 3, from {next(iter(variables))} and ", **variables)
    for variables in ({}, {"SLURM_ARRAY_TASK_ID": "3", "SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "3"},
                      {"SLURM_ARRAY_TASK_ID": "1", "SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "1",
                       "SLURM_ARRAY_TASK_MAX": "17"},  # --array=1,17 repeats two of 17 or more
                      {"SLURM_ARRAY_TASK_ID": "1"}, {"OMPI_COMM_WORLD_RANK": "1"},
                      {"SGE_TASK_ID": "undefined", "SGE_TASK_LAST": "undefined"}):
        expect(2, "study", *arguments, "--shard", says="--shard takes I/N", **variables)
    for word in ("0/4", "5/4", "4", "1/0", "1/4x", "1/100001"):
        expect(2, "study", *arguments, "--shard", word, says="--shard takes I/N")
    wrong = {
        ("--shard", "1/2", "--merge", "--out", out): "are three different steps",
        ("--shard", "1/2"): "--shard needs --out DIR",
        ("--merge",): "--merge needs --out DIR",
        ("--no-run", "--out", out): "--no-run has no effect without --merge",
        ("--print-shards", "0"): "--print-shards takes N from 1 to 100000",
    }
    for words, says in wrong.items():
        expect(2, "study", *SWEEP, *words, says=says)
    expect(2, "study", beam("ibs"), "--paper", "--merge", "--out", out, says="--merge has no effect with --paper")
    expect(2, "study", beam("ibs"), "--types", "drive.frequency", "--shard", "1/2", "--out", out,
           says="--shard has no effect with --types without --vary")


def check_scripts(folder):
    """What --print-shards prints is run by a shell."""
    out = os.path.join(folder, "a folder's name")
    arguments = (house("bedroom-after-earthquake"), "--shake", "8", "--out", out)
    printed = expect(0, "study", *arguments, "--jobs", "3", "--print-shards", "4").stdout
    check(not os.path.exists(out), "nothing is run")
    check("# 8 runs in 4 shards of at most 2." in printed and "+-1 %: 9604 or 3458" in printed, "widths", printed)
    check("#SBATCH --array=1-4\n" in printed and printed.startswith("#!/bin/sh\n"), "a script", printed)
    for number in range(1, 5):
        done = subprocess.run(["sh", "-c", printed], capture_output=True, text=True,
                              env={**os.environ, "SLURM_ARRAY_TASK_ID": str(number), "SLURM_CPUS_PER_TASK": "1"})
        check(done.returncode == 0 and f"shard {number} of 4: 2 of 2" in done.stdout, "the script runs", done)
    merge = next(line for line in printed.splitlines() if line.startswith("# J=")).partition("--wrap ")[2]
    done = subprocess.run(f"eval {merge}", shell=True, capture_output=True, text=True)
    check("8 of 8 runs are there" in done.stderr, "the merge runs", done)


with tempfile.TemporaryDirectory(prefix="clearance shards ä ") as directory:
    for number, (name, arguments) in enumerate(STUDIES.items()):
        own = os.path.join(directory, str(number))
        os.makedirs(own)
        check_same(name, arguments, own)
    for part in (check_missing, check_bad_files, check_conflict, check_while_running, check_words, check_scripts):
        own = os.path.join(directory, part.__name__)
        os.makedirs(own)
        part(own)
end()
