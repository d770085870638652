#!/usr/bin/env python3
"""Runs the window under random input, and one study of very many runs, for some minutes, and checks that memory stays flat.

soak.py CLEARANCE MINUTES [SEED]

Prints a sample every ten seconds. The study and the window's script must not end before the time; a window that the random mouse quits, with exit code 0, is followed by another one. Memory is flat if the last third of the time needs hardly more than the third before.
"""

import random
import statistics
import subprocess
import sys
import time

import stage
from chance import anything
from stage import check

MINUTES = float(sys.argv[2])
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 1
SCRIPT_LARGEST = 1 << 20  # bytes, as script.c allows
PAUSE = 1  # s between two samples
GROWTH_MOST = 0.05  # of the memory before
LAST = 60  # s, within which the script of the window must have gone on at the end
GROWTH_KB = 8192  # kB, of caches that still fill
HOUSES = ["corner-0.90-0.90", "closed-door", "two-chairs-corridor", "flat-0.910-module"]
BEAMS = ["ibs", "ibs-r"]


def block(chance):
    """Returns lines of random input to one house or beam, which begin from its file."""
    name = stage.beam(chance.choice(BEAMS)) if chance.random() < 0.3 else stage.house(chance.choice(HOUSES))
    return ["key Escape", "key Escape", f'open "{name}"', "wait 5", "key Escape",
            *(anything(chance) for _ in range(40)), "wait 3"]


def begin_window(place, seed):
    """Starts the window with as much input as a script holds; after its end the window stays open."""
    chance = random.Random(seed)
    script = ""
    while len(script) < SCRIPT_LARGEST - 10000:
        script += "\n".join([*block(chance), f'state "{place / "state"}"']) + "\n"
    (place / "script").write_text(script)
    return subprocess.Popen([stage.program, "open", "--script", str(place / "script")], cwd=place, stdout=subprocess.DEVNULL,
                            stderr=open(place / "errors", "w"),
                            env=stage.environment(place / "home", SDL_VIDEODRIVER="offscreen"))


def memory_of(process):
    """Returns the data and resident memory of a process in kB, or None once it has ended."""
    try:
        with open(f"/proc/{process.pid}/status", encoding="utf-8") as file:
            rows = dict(line.split(":", 1) for line in file)
        return int(rows["VmData"].split()[0]), int(rows["VmRSS"].split()[0])
    except (OSError, KeyError):
        return None


def begin_study(place):
    """Starts a study that takes hours."""
    return subprocess.Popen([stage.program, "study", stage.house("corner-1.20-1.20"), "--runs", "100000", "--seed", str(SEED),
                             "--vary", "profile.manual-chair.width=0.60:0.62:4",
                             "--spread", "profile.manual-chair.free_speed=0.1", "--jobs", "1", "--out", str(place)],
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def check_flat(what, samples):
    """Compares the median of the last third of the samples with that of the third before."""
    third = len(samples) // 3
    if third == 0:
        check(False, f"{what}: too few samples", samples)
        return
    before, after = (statistics.median(part) for part in (samples[third:2 * third], samples[2 * third:]))
    check(after <= before * (1 + GROWTH_MOST) + GROWTH_KB, f"{what}: {before:.0f} kB, then {after:.0f} kB", "it is not flat")


def main():
    place = stage.folder / "soak"
    results = stage.folder / "soak-study"
    place.mkdir()
    results.mkdir()
    study = begin_study(results)
    window, begun, said, quits = begin_window(place, SEED), time.monotonic(), 0, 0
    samples = {"window": [], "study": []}
    while window.poll() in (None, 0) and study.poll() is None and time.monotonic() - begun < 60 * MINUTES:
        if window.poll() == 0:
            quits += 1
            print(f"{time.monotonic() - begun:6.0f} s: the input quits the window, which begins again", flush=True)
            window = begin_window(place, SEED + quits)
            samples["window"].clear()
        for name, process in (("window", window), ("study", study)):
            found = memory_of(process)
            if found:
                samples[name].append(found)
        if all(samples.values()) and time.monotonic() - said > 10:
            said = time.monotonic()
            print(f"{said - begun:6.0f} s: " + "; ".join(f"the {name} has {rows[-1][0]} kB of data, {rows[-1][1]} kB resident"
                                                         for name, rows in samples.items()), flush=True)
        time.sleep(PAUSE)
    check(study.poll() is None, "the study goes on to the end of the time", study.poll())
    study.kill()
    study.wait()
    state = place / "state"
    alive = window.poll() is None
    check(alive, "the window lives to the end of the time", (window.poll(), (place / "errors").read_text()[-2000:]))
    check(state.exists() and time.time() - state.stat().st_mtime < LAST, "the script goes on at the end",
          (place / "errors").read_text()[-2000:])
    if alive:
        window.terminate()
        window.wait(timeout=120)
    for name, rows in samples.items():
        check_flat(f"data of the {name}", [row[0] for row in rows])
        check_flat(f"resident memory of the {name}", [row[1] for row in rows])


main()
stage.end()
