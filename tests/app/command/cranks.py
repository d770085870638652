#!/usr/bin/env python3
"""Tests what the command line says about slider cranks.

cranks.py CLEARANCE
"""

import json
import pathlib
import tempfile

from program import check, end, expect, source

crank = str(source / "assets/cranks/ssc.json")
calm = ("--set", "drive.frequency=10", "--set", "joint.clearance=1e-4", "--set", "run.transient_cycles=20")


def check_run():
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "out")
        text = expect(0, "run", crank, *calm, "--out", str(out), "--plots", "phase,across,spectrum",
                      "--frames", "5", "--to", "0.02", "--report").stdout
        check(text.startswith("Periodic, period 1: at 600 rpm the largest force in the joint is 51.16 N, 1.5 times the "
                              "34.52 N of a joint without clearance\n"), f"run of a crank: {text}")
        check("The pin never leaves its socket\n" in text, f"contact of a crank: {text}")
        check("Its numbers are all assumed." in text, f"provenance of a crank: {text}")
        check("friction calms such a mechanism" in text, f"friction of a crank: {text}")
        check("The 13th multiple of the speed, 130 Hz, meets the support's frequency along the guide" in text, f"multiples: {text}")
        summary = json.loads((out / "summary.json").read_text())
        check((summary["kind"], summary["verdict"], summary["period"]) == ("crank", "periodic", 1), f"summary: {summary}")
        check(abs(summary["multiplier"] - 0.349387) < 1e-4, f"multiplier of a crank: {summary}")
        check(all(why.startswith("assumed") for why in summary["provenance"].values()), f"provenance: {summary}")
        header = (out / "trace.csv").read_text().splitlines()[0]
        check(header.startswith("time [s],angle [deg],along [m],"), f"trace of a crank: {header}")
        for name in ("phase", "across", "spectrum"):
            for ending in ("png", "svg", "pdf", "csv"):
                check((out / f"plot-{name}.{ending}").stat().st_size > 1000, f"plot-{name}.{ending}")
        for ending in ("png", "svg", "pdf"):
            check((out / f"crank.{ending}").stat().st_size > 3000, f"crank.{ending}")
        page = (out / "report.html").read_text()
        check("Periodic, period 1: at 600 rpm" in page and "All numbers and their sources" in page, "report of a crank")
        check((out / "report.pdf").stat().st_size > 20000, "report.pdf of a crank")
        frames = sorted(path.name for path in (out / "frames").iterdir())
        check(len(frames) == 7 and frames[0] == "frame-00001.png", f"a film of a crank, 60 times slower: {frames}")
        again = expect(0, "run", crank, *calm, "--json").stdout
        check(json.loads(again)["digest"] == summary["digest"], "a crank's run repeats")


def check_study():
    alike = [expect(0, "study", crank, "--vary", "drive.frequency=9:11:3", *calm, "--set", "run.cycles=8", "--jobs", jobs,
                    "--json").stdout for jobs in ("1", "2")]
    check(alike[0] == alike[1], "a study of a crank is the same with one job and with two")
    words = expect(0, "study", crank, "--vary", "drive.frequency=9:11:3", *calm, "--set", "run.cycles=8").stdout
    check("drive.frequency from 540 to 660 rpm (9 to 11 Hz) in 3 steps" in words and "drive.frequency rpm" in words,
          f"speeds are read in rpm: {words}")

    with tempfile.TemporaryDirectory() as folder:
        measured = pathlib.Path(folder, "measured.csv")
        measured.write_text("drive.frequency [Hz],peak [N]\n9.5,45\n10,52\n11,66\n")
        expect(0, "study", crank, "--vary", "drive.frequency=9:11:3", *calm, "--set", "run.cycles=8", "--report",
               "--measured", str(measured), "--out", folder)
        check("measured" in pathlib.Path(folder, "plot-peaks.svg").read_text() or
              "measured" in pathlib.Path(folder, "plot-peaks.csv").read_text(), "measured peaks of a crank")
        page = pathlib.Path(folder, "report.html").read_text()
        check("Study of a crank" in page and "Orbit diagram over speed" in page and "coupler.length" in page,
              "report of a study of a crank")


def check_bits():
    """The same bits with any number of jobs, and when the C library takes the processor for one that has less."""
    less = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-FMA_Usable,-AVX2_Usable,-FMA4_Usable"
    least = less + ",-AVX,-AVX_Usable,-AVX512F,-AVX512F_Usable,-SSE4_1,-SSE4_2,-SSSE3"
    answers = []
    for jobs, tunables in (("1", ""), ("2", less), ("4", least)):
        settings = {"GLIBC_TUNABLES": tunables} if tunables else {}
        one = json.loads(expect(0, "run", crank, *calm, "--jobs", jobs, "--json", **settings).stdout)
        several = json.loads(expect(0, "study", crank, "--vary", "joint.clearance=5e-5:2.5e-4:3", "--set",
                                    "run.transient_cycles=5", "--set", "run.cycles=10", "--jobs", jobs, "--json",
                                    **settings).stdout)
        answers.append((one["digest"], one["multiplier"], one["peaks"], several["digest"]))
    check(answers[0] == answers[1] == answers[2], f"the same bits with 1, 2 and 4 jobs on lesser processors: {answers}")


def check_confirmation():
    quick = json.loads(expect(0, "run", crank, "--lanes", "0", "--json").stdout)
    check((quick["verdict"], quick["quick"]) == ("chaotic", True) and "survival" not in quick, f"quick verdict: {quick}")
    words = expect(0, "run", crank, "--lanes", "1").stdout
    check("It lasted for 1 x 400 revolutions: none of 1 motions that were started on it settled" in words,
          f"a confirmed verdict: {words}")
    check("The pin leaves its socket 16 times a revolution, 7.4 % of the time" in words, f"contact lost: {words}")


def check_too_fast():
    """At a speed at which the coupler buckles there is no motion to tell of."""
    words = expect(1, "run", crank, "--set", "drive.frequency=1000", "--lanes", "0").stdout
    check(words.startswith("The numbers diverged after 0 revolutions: at 60000 rpm with a clearance of 0.25 mm\n"
                           "The coupler bends further than its equations describe"), f"60,000 rpm: {words}")


def check_faults():
    expect(2, "run", str(source / "tests/data/bad/cranks/does-not-close.json"), says="the mechanism does not close")
    refused = expect(2, "fit", crank, "--fit", "joint.clearance", says="clearance: fit is for houses and beams, ")
    check(refused.stderr.count("\n") == 1 and not refused.stdout, f"fit of a crank says one line: {refused}")
    expect(2, "run", crank, "--report", says="--report needs --out DIR")
    expect(2, "run", crank, "--plots", "displacement", "--out", "/nowhere", says="displacement")
    expect(2, "run", crank, "--plots", "phase", says="--plots needs --out DIR")
    expect(2, "run", crank, "--set", "joint.clearence=1", says='did you mean "joint.clearance"')
    expect(2, "study", crank, "--vary", "drive.frequency=5:25:3", "--route", "A", says="is a crank")
    expect(2, "study", crank, "--paper", "--vary", "drive.frequency=5:6:2", says="--vary has no effect with --paper")


check_run()
check_study()
check_bits()
check_confirmation()
check_too_fast()
check_faults()
end()
