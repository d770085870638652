#!/usr/bin/env python3
"""Tests that shipped houses, profiles, beams, cranks, rules and lessons fit assets/schema, and invalid ones do not if a schema can detect it.

tests/data/bad/beyond-schema.txt lists the invalid files that fit the schema: the meaning of their numbers is wrong.
"""

import json
import os
import pathlib
import sys

import jsonschema

source = pathlib.Path(os.environ.get("CLEARANCE_SOURCE", ".")).resolve()


def no_duplicates(pairs):
    if len({key for key, _ in pairs}) != len(pairs):
        raise ValueError("a key is given twice")
    return dict(pairs)


def finite(text):
    number = float(text)
    if number in (float("inf"), float("-inf")):
        raise ValueError(f"{text} is too large")
    return number


def no_constant(text):
    raise ValueError(f"{text} is not JSON")


def read(path):
    return json.loads(
        path.read_text(encoding="utf-8"),
        object_pairs_hook=no_duplicates,
        parse_float=finite,
        parse_constant=no_constant,
    )


def problem(validator, path):
    """Returns the reason why the file cannot be read or does not fit the schema, or None."""
    try:
        error = jsonschema.exceptions.best_match(validator.iter_errors(read(path)))
        return error and error.message
    except (ValueError, RecursionError) as error:
        return str(error)


failures = 0
checked = 0
beyond = set((source / "tests/data/bad/beyond-schema.txt").read_text().split())
for kind, shipped in (("house", "houses"), ("profile", "assets/profiles"), ("beam", "assets/beams"), ("crank", "assets/cranks"),
                      ("rules", "assets/rules"), ("lesson", "assets/lessons")):
    schema = read(source / f"assets/schema/{kind}.schema.json")
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    for path in sorted((source / shipped).glob("*.json")):
        found = problem(validator, path)
        checked += 1
        if found:
            print(f"{path}: is shipped, but {found}")
            failures += 1
    folder = kind if kind == "rules" else f"{kind}s"
    for path in sorted((source / "tests/data/bad" / folder).glob("*.json")):
        found = problem(validator, path)
        name = f"{folder}/{path.name}"
        checked += 1
        if found and name in beyond:
            print(f"{name}: is beyond the schema, but it says: {found}")
            failures += 1
        elif not found and name not in beyond:
            print(f"{name}: the schema finds nothing")
            failures += 1
        beyond.discard(name)
for name in sorted(beyond):
    print(f"{name}: there is no such file")
    failures += 1
print(f"{checked} files, {failures} failures")
sys.exit(1 if failures or not checked else 0)
