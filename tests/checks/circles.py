#!/usr/bin/env python3
"""Prints every circle of modules: modules that need one another to be linked, read from the symbols of their object
files. A module is a .c or .cpp file, named by its whole path, since the same file name stands in several folders.

circles.py BUILD, where BUILD was configured without link-time optimisation and is built; exits 1 if there is a circle.
"""

import collections
import pathlib
import subprocess
import sys

EXPORTED = "TDBRC"  # code, data, zeroed data, constants, common
SHOWN_SYMBOLS = 4  # of one arrow of a circle


def modules(source, build):
    """Returns the object file of each module."""
    objects = {}
    for library in ("engine", "app"):
        for path in sorted((source / library).rglob("*.c*")):
            if path.suffix not in (".c", ".cpp"):
                continue
            inside = path.relative_to(source / library)
            target = "clearance.p" if str(inside) == "main.c" else f"libclearance_{library}.a.p"
            name = str(inside).replace("/", "_") + ".o"
            objects[f"{library}/{inside.with_suffix('')}"] = build / library / target / name
    return objects


def symbols(objects):
    """Returns the module that defines each symbol, and the symbols that each module needs."""
    home, needs = {}, collections.defaultdict(set)
    for module, path in objects.items():
        if not path.exists():
            sys.exit(f"{path} is missing: build first, and list every source in meson.build")
        lines = subprocess.run(["nm", path], capture_output=True, text=True, check=True).stdout.splitlines()
        found = 0
        for fields in map(str.split, lines):
            if len(fields) == 3 and fields[1] in EXPORTED:
                home[fields[2]] = module
                found += 1
            elif len(fields) == 2 and fields[0] == "U":
                needs[module].add(fields[1])
        if not found:
            sys.exit(f"{path} exports nothing: nm cannot read objects of link-time optimisation")
    return home, needs


def arrows(home, needs):
    """Returns arrows: arrows[a][b] lists the symbols that module a takes from module b."""
    graph = collections.defaultdict(lambda: collections.defaultdict(list))
    for module, names in needs.items():
        for name in sorted(names):
            if home.get(name, module) != module:
                graph[module][home[name]].append(name)
    return graph


def circles(nodes, graph):
    """Returns strongly connected components of more than one module (Tarjan 1972), the largest first."""
    number, low, stack, found = {}, {}, [], []

    def visit(node):
        number[node] = low[node] = len(number)
        stack.append(node)
        for other in graph[node]:
            if other not in number:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], number[other])
        if low[node] == number[node]:
            at = stack.index(node)
            if len(stack) - at > 1:
                found.append(sorted(stack[at:]))
            del stack[at:]

    for node in nodes:
        if node not in number:
            visit(node)
    return sorted(found, key=len, reverse=True)


def main():
    sys.setrecursionlimit(10000)
    source = pathlib.Path(__file__).resolve().parent.parent.parent
    objects = modules(source, pathlib.Path(sys.argv[1]))
    graph = arrows(*symbols(objects))
    found = circles(list(objects), graph)
    for circle in found:
        print(f"a circle of {len(circle)} modules:")
        for module in circle:
            for other in sorted(set(graph[module]) & set(circle)):
                names = graph[module][other]
                more = f" and {len(names) - SHOWN_SYMBOLS} more" if len(names) > SHOWN_SYMBOLS else ""
                print(f"    {module} -> {other}: {' '.join(names[:SHOWN_SYMBOLS])}{more}")
    print(f"circles: {len(found)} among {len(objects)} modules and {sum(map(len, graph.values()))} arrows")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
