"""Helpers of the command line tests: they run the program and compare its results with the expected ones."""

import os
import pathlib
import resource
import subprocess
import sys

source = pathlib.Path(os.environ.get("CLEARANCE_SOURCE", ".")).resolve()
program = pathlib.Path(sys.argv[1]).resolve()
failed = []
BRIEF = ("--set", "drive.frequency=190", "--set", "run.transient_cycles=20", "--set", "run.cycles=20", "--set", "beam.modes=2")
"""A beam with a quick verdict, for tests of something else: the default one lives through 20,000 cycles 64 times."""



def house(name):
    return str(source / "houses" / f"{name}.json")


def beam(name):
    return str(source / "assets" / "beams" / f"{name}.json")


def run(*arguments, cwd=None, limit=None, patience=300, **environment):
    """Runs the program for at most `patience` s; `limit` is the largest size of a file in bytes."""
    size = limit and (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=patience, cwd=cwd, preexec_fn=size,
                          env={**os.environ, **environment})


def check(good, what, detail=""):
    if not good:
        failed.append(what)
        print(f"FAIL {what} {detail}")


def expect(code, *arguments, says="", **environment):
    done = run(*arguments, **environment)
    check(done.returncode == code, f"{arguments}: exit code {done.returncode}, expected {code}", done.stderr)
    check(says in done.stderr, f"{arguments}: standard error lacks {says!r}", done.stderr)
    return done


def end():
    print(f"{len(failed)} failures")
    sys.exit(len(failed) != 0)
