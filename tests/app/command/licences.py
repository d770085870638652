#!/usr/bin/env python3
"""Tests that `--version --licences` lists every library of the program, and that none puts it under the GPL.

licences.py CLEARANCE
"""

import json
import os
import pathlib
import re
import subprocess

from program import check, end, expect, program

SANITIZERS = ("libasan", "libubsan", "libtsan", "libclang_rt")
LINKS = {"shared", "static", "loaded"}
# For packages whose file of copyrights has no lines for a machine: licence, words of that file, packages.
GRANTED, SELL = "Permission is hereby granted, free of charge", "Permission to use, copy, modify, distribute, and sell"
UNREADABLE = [
    ("LGPL-2.1-or-later", "Lesser General Public", {"libc6", "libgcrypt20"}),
    ("LGPL-2.1-only OR MPL-1.1", "Mozilla Public License", {"libcairo2"}),
    ("GPL-3.0-or-later WITH GCC-exception-3.1", "Runtime Library Exception",
     {"libgcc-s1", "libgfortran5", "libquadmath0", "libstdc++6"}),
    ("MIT", GRANTED, {"libdrm2", "libpixman-1-0", "libx11-6", "libx11-xcb1", "libxcb-render0", "libxcb-shm0", "libxcb1", "libxext6",
                      "libxfixes3", "libxi6", "libxkbcommon0", "libxss1"}),
    ("HPND-sell-variant", SELL, {"libfontconfig1", "libxau6", "libxcursor1", "libxdmcp6", "libxrandr2", "libxrender1"}),
    ("public domain", "ublic domain", {"libselinux1"}),
    ("BSD-3-Clause", "Redistribution and use in source and binary", {"libzip4"}),
]


def needed():
    """Returns the shared libraries that the program names itself."""
    entries = subprocess.run(["readelf", "-d", program], check=True, stdout=subprocess.PIPE, text=True).stdout
    found = set(re.findall(r"\(NEEDED\).*\[(.*)\]", entries))
    return {name for name in found if not name.startswith(SANITIZERS) and not name.startswith("ld-linux")}


def all_files():
    """Returns the files of all libraries that the program loads when it starts, directly or not."""
    lines = subprocess.run(["ldd", program], check=True, stdout=subprocess.PIPE, text=True).stdout
    return {os.path.realpath(path) for path in re.findall(r"=> (/\S+)", lines)}


def packages(files):
    """Returns the packages of Debian that hold these files."""
    names = sorted(files | {file[4:] for file in files if file.startswith("/usr/")} | {"/usr" + file for file in files})
    found = subprocess.run(["dpkg", "-S", *names], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    return set(re.findall(r"^([^:\s]+)(?::\S+)?: ", found, re.MULTILINE))


def main_licence(package):
    """Returns the licence of a library's files, or else of all files of its source, or '' if no machine can read it."""
    path = pathlib.Path("/usr/share/doc") / package / "copyright"
    text = path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""
    for files in (re.escape(package.rstrip("0123456789.-")) + r"/\*", r"\*"):
        for part in text.split("\n\n"):
            licence = re.search(r"^License: *(.*)", part, re.MULTILINE)
            if licence and re.search(r"^Files:(\s|\S+\s)*?" + files + r"\s", part):
                return licence.group(1).strip()
    return ""


def read_licence(package):
    """Returns the licence of a package: from its lines for a machine, or from the table if its words are there; ''."""
    licence = main_licence(package)
    path = pathlib.Path("/usr/share/doc") / package / "copyright"
    words = " ".join(path.read_text(encoding="utf-8", errors="replace").split()) if path.exists() else ""
    return licence or next((name for name, part, known in UNREADABLE if package in known and part in words), "")


def puts_under_gpl(licence):
    """True if one of the parts of a licence has only alternatives under the GPL, without an exception."""
    return any(all(re.search(r"(?<!L)GPL", choice) and not re.search(r"\bwith\b|exception", choice, re.I)
                   for choice in re.split(r" or ", part, flags=re.I))
               for part in re.split(r",? and |, ", licence, flags=re.I))


def static_files():
    """Returns the static libraries of other projects on the line that links the program."""
    rules = (program.parent.parent / "build.ninja").read_text()
    rule = re.search(r"^build app/clearance: .*\n(?: .*\n)*", rules, re.MULTILINE)[0]
    words = re.search(r"^ LINK_ARGS = (.*)", rule, re.MULTILINE)[1].split()
    return {os.path.basename(word) for word in words if word.startswith("/") and word.endswith(".a")}


def check_list():
    answer = json.loads(expect(0, "--version", "--licences", "--json").stdout)
    rows = answer["libraries"]
    check(answer["licence"] == "MIT" and answer["program"] == "clearance", "--version --licences: the program")
    check({row["link"] for row in rows} == LINKS, "--version --licences: kinds of libraries")
    shared = {row["file"] for row in rows if row["link"] == "shared"}
    check(needed() <= shared, f"linked, but not in the list of app/command/licences.c: {sorted(needed() - shared)}")
    check(shared <= needed(), f"in the list of app/command/licences.c, but not linked: {sorted(shared - needed())}")
    static = {row["file"] for row in rows if row["link"] == "static"}
    check(static == static_files(), f"static libraries in the list: {sorted(static)}, linked: {sorted(static_files())}")
    told = {row["name"]: row["version"] for row in rows}
    check(re.fullmatch(r"3\.\d+\.\d+", told["SQLite"] or ""), f"the version of SQLite: {told['SQLite']}")
    check(all(re.match(r"\d+\.\d+", version) for version in told.values() if version), f"versions: {told}")
    for row in rows:
        check(os.path.exists(row["text"]), f"{row['name']}: {row['text']} is not there")
        check(not puts_under_gpl(row["licence"]), f"{row['name']}: {row['licence']}")
    text = expect(0, "--version", "--licences").stdout
    check(all(row["name"] in text and row["licence"] in text for row in rows), "the list as text", text)


def check_options():
    check(expect(0, "--version").stdout.startswith("clearance "), "--version")
    check("libraries" not in json.loads(expect(0, "--version", "--json").stdout), "--version --json")
    expect(2, "--version", "--licenses", says="did you mean --licences?")


def check_all_loaded():
    """No library on the way is under the GPL alone: its terms would hold for the program, too."""
    loaded = packages(all_files())
    check(len(loaded) > 40, f"the packages of the loaded libraries: {sorted(loaded)}")
    for package in sorted(loaded):
        licence = read_licence(package)
        check(licence, f"the licence of {package} is unknown: add it to the table after reading its file of copyrights")
        check(not puts_under_gpl(licence), f"{package} is under {licence}")


def check_words():
    for licence in ("GPL-2", "GPL-2.0-only", "GPL-3.0-or-later", "GPL-2+ and MIT", "MIT and GPL-2+", "AGPL-3", "GPL-2 or GPL-3",
                    "BSD-3-clause, GPL-2+"):
        check(puts_under_gpl(licence), f"{licence} is not rejected")
    for licence in ("LGPL-2.1+", "LGPL-2+ and LGPL-2.1+", "BSD-3-clause or GPL-2", "GPL-2+ or AFL-2.1, and Expat", "MIT",
                    "GPL-3.0-or-later WITH GCC-exception-3.1", "LGPL-2.1-only OR MPL-1.1"):
        check(not puts_under_gpl(licence), f"{licence} is rejected")


for part in (check_list, check_options, check_all_loaded, check_words):
    part()
end()
