#!/usr/bin/env python3
"""Tests frames, films, plots and oblique views as scripts rely on them: files, sizes, messages, repeated bytes.

frames.py CLEARANCE
"""

import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

from program import BRIEF, beam, check, end, expect, house, program, run


def size_of(png):
    data = png.read_bytes()
    check(data[:8] == b"\x89PNG\r\n\x1a\n" and data[-8:-4] == b"IEND", f"{png} is a whole PNG file")
    return struct.unpack(">II", data[16:24])


def frames_of(out):
    return sorted((out / "frames").glob("*"))


def check_frames(out):
    name = house("straight-corridor")
    expect(0, "run", name, "--frames", "4", "--to", "5", "--size", "320x200", "--out", str(out))
    frames = frames_of(out)
    check([f.name for f in frames] == [f"frame-{i:05d}.png" for i in range(1, 22)], "21 frames of 5 s, 4 a second")
    check(all(size_of(f) == (320, 200) for f in frames), "frames have their size")
    check(len({f.read_bytes() for f in frames}) == 21, "no two frames are alike")
    before = {f.name: f.read_bytes() for f in frames}
    expect(0, "run", name, "--frames", "4", "--from", "3", "--to", "5", "--size", "320x200", "--out", str(out), "--jobs", "1")
    frames = frames_of(out)
    check(len(frames) == 9, "frames of a longer film before are taken away")
    check(all(f.read_bytes() == before[f"frame-{i + 13:05d}.png"] for i, f in enumerate(frames)),
          "a part of a film is that part, whatever the number of threads")


def memory_of(*arguments):
    """Returns the peak memory of a run of the program, MB."""
    code = ("import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL); "
            "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024)")
    done = subprocess.run([sys.executable, "-c", code, program, *arguments], capture_output=True, text=True, timeout=300)
    check(done.returncode == 0, f"{arguments}: memory", done.stderr)
    return int(done.stdout or 0)


def check_memory(out):
    """A thousand threads must not hold two thousand pictures of about 4 MB each."""
    few, many = (memory_of("run", house("straight-corridor"), "--frames", "10", "--jobs", jobs, "--out", str(out))
                 for jobs in ("8", "1024"))
    check(0 < few and many < few + 100, "memory with many threads", f"{few} and {many} MB")


def check_contexts(out):
    pictures = []
    for kind in ("osmesa", "egl"):
        done = run("run", house("closed-door"), "--frames", "1", "--to", "4", "--view", "raised", "--size", "640x360",
                   "--out", str(out / kind), CLEARANCE_GL=kind)
        if done.returncode == 0:
            pictures.append([f.read_bytes() for f in frames_of(out / kind)] + [(out / kind / "raised.png").read_bytes()])
        else:
            check("libosmesa6" in done.stderr or "libegl" in done.stderr, f"{kind}: says what is missing", done.stderr)
    check(pictures and all(p == pictures[0] for p in pictures), "OSMesa and EGL draw the same")


def check_plots(out):
    expect(0, "run", house("corner-1.00-1.00"), "--plots", "speed,phase", "--frames", "1", "--size", "640x360", "--out",
           str(out))
    for name in ("plot-speed", "plot-phase"):
        check(size_of(out / f"{name}.png") == (640, 360), name)
        check((out / f"{name}.svg").read_text().startswith("<?xml"), name)
        check((out / f"{name}.pdf").read_bytes().startswith(b"%PDF"), name)
        check("[" in (out / f"{name}.csv").read_text().splitlines()[0], f"{name}.csv has units")
    check(not (out / "plot-force.png").exists(), "plots that were not asked for")


FFMPEG = """#!/bin/sh
# Stands in for ffmpeg: counts the bytes that come, or fails when the environment asks for it.
for last; do :; done
case $FAILS in broken) echo "no such format" >&2; exit 1 ;; hasty) exit 1 ;; esac
echo "$*" | sed "s|$last||" >"$last"
wc -c >>"$last"
"""


def check_films(out):
    """Tests the program's end of the pipe with a substitute for ffmpeg, and with ffmpeg itself if it is installed."""
    out.mkdir()
    stand_in = out / "bin"
    stand_in.mkdir()
    (stand_in / "ffmpeg").write_text(FFMPEG)
    (stand_in / "ffmpeg").chmod(0o755)
    path = f"{stand_in}:{os.environ['PATH']}"
    corridor, film = house("straight-corridor"), out / "film.mp4"
    expect(2, "run", corridor, "--movie", str(film), says="apt-get install ffmpeg", PATH="/nonexistent")
    check(not film.exists(), "no film without ffmpeg")
    expect(0, "run", corridor, "--movie", str(film), "--frames", "5", "--to", "4", "--size", "321x201", "--out", str(out),
           PATH=path)
    words, size = film.read_text().splitlines()
    check(int(size) == 21 * 321 * 201 * 4, "ffmpeg is given every picture", size)
    check("-s 321x201 -r 5 " in words, "and how large and how many", words)
    film.write_text("old")
    for kind in ("broken", "hasty"):
        name = f"{kind}.mp4"
        expect(2, "run", corridor, "--movie", str(out / name), "--to", "2", says=f"{name} cannot be written", PATH=path,
               FAILS=kind)
        check(not (out / name).exists(), f"{name}: nothing is left of it")
    check(film.read_text() == "old" and not list(out.glob(".*")), "nothing lies beside the films")
    check(shutil.which("ffmpeg"), "ffmpeg is not installed")
    expect(0, "run", corridor, "--movie", str(film), "--to", "2", "--size", "321x201")
    expect(0, "run", str(pathlib.Path(corridor).resolve()), "--movie", "11:45.mp4", "--to", "1", "--size", "320x200", cwd=out)
    expect(2, "run", corridor, "--movie", str(out / "full.mp4"), "--to", "4", "--size", "640x360", says="cannot be written",
           limit=20000)
    check(not (out / "full.mp4").exists(), "half a film is none")
    check((out / "11:45.mp4").exists() and not list(out.glob(".*")), "a film whose name looks like a protocol")
    check(b"ftyp" in film.read_bytes()[:16], "a film by the real one")


def check_comparison(out):
    expect(0, "compare", house("corner-1.00-1.00"), house("corner-1.20-1.20"), "--frames", "1", "--size", "640x360", "--out",
           str(out))
    check(len(frames_of(out)) > 5 and size_of(out / "plan.png") == (640, 360), "pictures of a comparison")


def check_beam_plots(out):
    beam = str(pathlib.Path(os.environ["CLEARANCE_SOURCE"]) / "assets/beams/ibs.json")
    points = out / "points.csv"
    expect(0, "run", beam, *BRIEF, "--size", "640x360", "--out", str(out / "usual"))
    names = sorted(f.stem for f in (out / "usual").glob("plot-*.png"))
    check(names == ["plot-force", "plot-phase", "plot-poincare"], f"plots of a beam where nothing is said: {names}")
    check(size_of(out / "usual/plot-phase.png") == (640, 360), "size of a beam's plot")
    points.write_text("deflection [mm],velocity [m/s]\n0.1,-0.5\n")
    arguments = ("run", beam, *BRIEF, "--plots", "phase,spectrum", "--theme", "board", "--measured", str(points))
    for name in ("first", "second"):
        expect(0, *arguments, "--out", str(out / name))
    for ending in ("png", "svg", "pdf", "csv"):
        check((out / "first" / f"plot-phase.{ending}").read_bytes() == (out / "second" / f"plot-phase.{ending}").read_bytes(),
              f"the same beam gives the same {ending}")
    check("measured deflection [mm]" in (out / "first/plot-phase.csv").read_text(), "measured points are in the table")
    expect(2, "run", beam, "--plots", "speed", "--out", str(out), says="plots are phase, poincare")
    expect(2, "run", beam, "--plots", "phase", says="--plots needs --out")
    expect(2, "run", beam, "--measured", str(points), says="--measured needs --out")
    points.write_text("deflection [s],velocity [m/s]\n0.1,-0.5\n")
    expect(2, *arguments, "--out", str(out), says=f"{points}:1:1: deflection is in s, must be in m")
    expect(2, "run", house("straight-corridor"), "--plots", "poincare", "--out", str(out), says="plots are speed")
    expect(2, "run", house("straight-corridor"), "--measured", str(points), "--out", str(out), says="--measured is for beams")


def check_beam(out):
    """A film of a beam: the frames per second of film, and the slow-motion factor."""
    rig = beam("ibs")
    done = expect(0, "run", rig, *BRIEF, "--frames", "10", "--slow", "400", "--to", "0.01", "--size",
                  "640x360", "--out", str(out), "--json")
    check(json.loads(done.stdout)["kind"] == "beam", "the answer, and nothing else, on standard output")
    frames = frames_of(out)
    check([f.name for f in frames] == [f"frame-{i:05d}.png" for i in range(1, 42)], "10 ms, 400 times slower, 10 a second")
    check(all(size_of(f) == (640, 360) for f in frames), "frames of a beam have their size")
    check(len({f.read_bytes() for f in frames}) == 41, "no two frames of a beam are alike")
    check(size_of(out / "beam.png") == (640, 360), "beam.png")
    check((out / "beam.svg").read_text().startswith("<?xml"), "beam.svg")
    check((out / "beam.pdf").read_bytes().startswith(b"%PDF"), "beam.pdf")
    before = {f.name: f.read_bytes() for f in [*frames, out / "beam.png", out / "beam.svg", out / "beam.pdf"]}
    again = out / "again"
    expect(0, "run", rig, *BRIEF, "--frames", "10", "--slow", "400", "--to", "0.01", "--size", "640x360",
           "--out", str(again), "--jobs", "1")
    check({f.name: f.read_bytes() for f in [*frames_of(again), again / "beam.png", again / "beam.svg", again / "beam.pdf"]}
          == before, "the same bytes twice, whatever the number of threads")
    expect(0, "run", rig, "--lanes", "0", "--frames", "2", "--out", str(again))
    check(24 <= len(frames_of(again)) <= 30, "8 cycles take some 13 seconds", len(frames_of(again)))
    expect(0, "run", rig, "--lanes", "0", "--frames", "1", "--from", "0.33", "--to", "9", "--size", "320x200", "--out", str(again))
    check(len(frames_of(again)) == 3, "as far as the record goes", len(frames_of(again)))
    expect(0, "run", rig, "--lanes", "0", "--frames", "1", "--from", "9", "--size", "320x200", "--out", str(again),
           says="after the end of the record at 0.333333 s")
    undamped = ("run", rig, *BRIEF, "--set", "beam.damping_ratio=0", "--quiet")
    resonance = json.loads(expect(0, *undamped, "--json").stdout)["natural_frequencies"][1]
    expect(1, *undamped, "--set", f"drive.frequency={resonance!r}", "--out", str(again),
           says="not one whole cycle was recorded")


def check_wrong_use(out):
    rig = beam("ibs")
    for option, value in (("--slow", "0"), ("--slow", "-5"), ("--slow", "nan"), ("--slow", "lots"), ("--frames", "0")):
        expect(2, "run", rig, option, value, "--out", str(out), says=option)
    expect(2, "run", rig, "--frames", "10", says="--frames needs --out")
    expect(2, "run", rig, "--movie", str(out / "film.gif"), says="must end in .mp4")
    expect(2, "run", rig, "--view", "raised", "--out", str(out), says="--view raised is for houses")
    expect(2, "run", rig, "--show", "circles", "--out", str(out), says="--show is for houses")
    expect(2, "run", rig, *BRIEF, "--frames", "1000", "--slow", "1e6", "--out", str(out), says="at most 1000000")
    expect(2, "run", rig, *BRIEF, "--frames", "2", "--out", str(out), says="osmesa or egl", CLEARANCE_GL="nonsense")
    expect(2, "run", house("straight-corridor"), "--slow", "10", "--frames", "2", "--out", str(out), says="--slow is for beams")
    corridor = house("straight-corridor")
    expect(2, "run", corridor, "--frames", "10", says="--frames needs --out")
    expect(2, "run", corridor, "--movie", str(out / "film.gif"), says="must end in .mp4")
    expect(0, "run", corridor, "--frames", "1", "--from", "900", "--out", str(out), says="after the end of the run")
    expect(2, "run", corridor, "--plots", "speed", says="--plots needs --out")
    expect(2, "run", corridor, "--from", "9", "--to", "3", "--frames", "2", "--out", str(out), says="--from 9 is after --to 3")
    for option, value in (("--frames", "0"), ("--frames", "-1"), ("--frames", "nan"), ("--frames", "many"), ("--view", "side"),
                          ("--camera", "10"), ("--camera", "10,2"), ("--camera", "10,91"), ("--camera", "10,50,0"),
                          ("--camera", "10,50,1,7"), ("--camera", "nan,50"), ("--show", "everything"), ("--plots", "colour"),
                          ("--plots", ""), ("--from", "-1"), ("--to", "soon"), ("--movie", "")):
        expect(2, "run", corridor, option, value, "--out", str(out), says=option)
    expect(2, "run", corridor, "--frames", "1000", "--set", "exit.e1.opens=9000", "--until", "5000", "--out", str(out),
           says="at most 1000000")
    expect(2, "run", corridor, "--frames", "2", "--out", str(out), says="osmesa or egl", CLEARANCE_GL="nonsense")
    done = expect(2, "run", corridor, "--frames", "2", "--out", str(out), says="the file would be larger than the system allows", limit=1000)
    check(len(done.stderr.splitlines()) == 1, "a file that is too large is told of in one line", done.stderr)
    expect(0, "run", corridor, "--view", "raised", CLEARANCE_GL="nonsense")  # without output nothing is drawn


def check_drivers(out):
    """The band of many drivers is in every picture, and again with the same bytes."""
    shot = ("--frames", "1", "--from", "5", "--to", "5", "--size", "640x400", "--out", str(out))
    pictures = []
    for drivers in ((), ("--drivers", "12"), ("--drivers", "12", "--jobs", "1")):
        expect(0, "run", house("straight-corridor"), *drivers, *shot)
        pictures.append(frames_of(out)[0].read_bytes())
    check(pictures[0] != pictures[1], "drivers are in the frames")
    check(pictures[1] == pictures[2], "drivers are the same on one thread")


def check_interrupt(out):
    interrupt(out / "house", house("straight-corridor"))
    interrupt(out / "beam", beam("ibs"), *BRIEF)


def interrupt(out, *words):
    process = subprocess.Popen([program, "run", *words, "--frames", "1000", "--out", str(out)], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    while process.poll() is None and len(frames_of(out)) < 5:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, error = process.communicate(timeout=60)
    frames = frames_of(out)
    check(process.returncode == 1 and len(frames) >= 5, f"interrupted: {process.returncode}, {len(frames)} frames")
    check("interrupted" in error and len(error.splitlines()) == 1, "interrupted: says so", error)
    check(all(size_of(f) == (1280, 720) for f in frames), "interrupted: every frame is whole")


with tempfile.TemporaryDirectory() as directory:
    for part in (check_frames, check_beam, check_memory, check_contexts, check_plots, check_beam_plots, check_films, check_comparison, check_drivers, check_wrong_use, check_interrupt):
        part(pathlib.Path(directory) / part.__name__)
end()
