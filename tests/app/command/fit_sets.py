#!/usr/bin/env python3
"""Fits many synthetic sets of measurements of the ube house, whose chair is known: how near the fitted values come to the
true ones, and how often the 90 % intervals hold them. A set is five runs of each of the four routes: the program's own
times with a free speed and a steering time drawn about those of the profile, each with a normal error of 0.5 s.

    fit_sets.py PROGRAM [SETS]"""

import csv
import json
import math
import pathlib
import random
import sys
import tempfile

from program import check, end, expect, house, run

SETS, RUNS, DEVIATION = 50, 5, 0.5
SPREAD = 0.25  # of the logarithms of the true values, half of the prior's
PROFILE = "profile.manual-chair."
PRIOR = {"free_speed": 0.69, "steering_time": 0.4}
WITHIN = {"free_speed": 0.06, "steering_time": 0.15}


def true_times(truth):
    settings = [word for name, value in truth.items() for word in ("--set", f"{PROFILE}{name}={value!r}")]
    answer = json.loads(expect(0, "run", house("ube-techno-house"), "--json", *settings).stdout)
    return {person["id"][-1].upper(): person["time"] for person in answer["people"]}


def fit_set(seed, folder):
    """Returns the truth, and what the fit says of each parameter."""
    chance = random.Random(seed)
    truth = {name: prior * math.exp(SPREAD * chance.gauss(0, 1)) for name, prior in PRIOR.items()}
    table = pathlib.Path(folder, f"{seed}.csv")
    with table.open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["route", "time [s]", "deviation [s]"])
        for route, time in sorted(true_times(truth).items()):
            rows.writerows([route, round(time + DEVIATION * chance.gauss(0, 1), 2), DEVIATION] for _ in range(RUNS))
    answer = json.loads(run("fit", house("ube-techno-house"), "--observed", str(table), "--json", patience=3600).stdout)
    return truth, {found["name"].removeprefix(PROFILE): found for found in answer["parameters"]}


def main():
    sets = int(sys.argv[2]) if len(sys.argv) > 2 else SETS
    errors, held, told = ({name: [] for name in PRIOR} for _ in range(3))
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, sets + 1):
            truth, found = fit_set(seed, folder)
            for name, true in truth.items():
                errors[name].append(found[name]["best"] / true - 1)
                held[name].append(found[name]["low"] <= true <= found[name]["high"])
                told[name].append(found[name]["told"])
                print(f"set {seed} {name}: true {true:.4f}, best {found[name]['best']:.4f}, 90 % {found[name]['low']:.4f} to "
                      f"{found[name]['high']:.4f}, error {100 * errors[name][-1]:+.1f} %", flush=True)
    for name, limit in WITHIN.items():
        error = math.sqrt(sum(error * error for error in errors[name]) / sets)
        bias = sum(errors[name]) / sets
        within, cover = sum(abs(error) <= limit for error in errors[name]) / sets, sum(held[name]) / sets
        print(f"{name}: {sets} sets, root mean square error {100 * error:.1f} %, mean {100 * bias:+.1f} %, "
              f"{100 * within:.0f} % of the sets within {100 * limit:.0f} %, 90 % intervals hold {100 * cover:.0f} %")
        check(error <= limit, f"{name} is found within {100 * limit:.0f} %", f"{100 * error:.1f} %")
        check(all(told[name]), f"the data tell {name}", f"in {sum(told[name])} of {sets} sets")
        if sets == SETS:
            check(0.80 <= cover <= 0.97, f"90 % intervals of {name} hold 80 to 97 % of the true values", f"{100 * cover:.0f} %")


main()
end()
