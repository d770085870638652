#!/usr/bin/env python3
"""Prints the coverage of a summary that gcovr has written: in all, of each folder, and of the ten least covered files.

coverage.py SUMMARY.json
"""

import collections
import json
import pathlib
import sys

LEAST = 10
BRANCHES_LEAST = 20  # a file of few branches says little


def share(covered, total):
    return 100 * covered / total if total else 100.0


def row(name, counts):
    lines, branches = share(counts["line_covered"], counts["line_total"]), share(counts["branch_covered"], counts["branch_total"])
    print(f"{name:44} {lines:6.1f} % of {counts['line_total']:6} lines {branches:6.1f} % of {counts['branch_total']:6} branches")


with open(sys.argv[1], encoding="utf-8") as file:
    files = {entry["filename"]: entry for entry in json.load(file)["files"]}
if not files:
    sys.exit("coverage.py: no file was reached")

total, folders = collections.Counter(), collections.defaultdict(collections.Counter)
for name, entry in files.items():
    counts = {key: entry[key] for key in ("line_covered", "line_total", "branch_covered", "branch_total")}
    total.update(counts)
    folders[str(pathlib.PurePath(name).parent)].update(counts)

for folder in sorted(folders):
    row(folder, folders[folder])
row("all", total)
print(f"the {LEAST} least covered files:")
large = [entry for entry in files.values() if entry["branch_total"] >= BRANCHES_LEAST]
for entry in sorted(large, key=lambda entry: share(entry["line_covered"], entry["line_total"]))[:LEAST]:
    row(entry["filename"], entry)
