"""Random input for the window, as lines of a script."""

import re

import stage

table = (stage.source / "app" / "window" / "keys.c").read_text()
keys = [key.replace("\\\\", "\\") for key in re.findall(r'\{ACTION_\w+,\s*KEY_\w+,\s*"((?:[^"\\]|\\.)+)"', table)]
keys = [key for key in keys if key not in ("Ctrl+Q", "Shift+F9", "F9")] + ["Return", "Delete", "PageUp", "PageDown", "F6"]
files = [stage.house("corner-0.90-0.90"), stage.house("closed-door"), stage.beam("ibs-r"), stage.house("there-is-none"),
         str(stage.source / "README.md")]
sizes = ["800 600", "1280 720", "1024 600", "1920 1080"]


def quoted(words):
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"'


def anything(chance):
    """Returns a line: a key, a click, a drag, a turn of the wheel, a text, a time, a file or a size."""
    x, y, other, down = (chance.randrange(limit) for limit in (1280, 720, 1280, 720))
    return chance.choice(
        [f"key {quoted(chance.choice(keys))}"] * 8 +
        [f"click {x} {y}", f"click {x} {y} double", f"click {x} {y} right", f"drag {x} {y} {other} {down}",
         f"wheel {chance.choice([-3, -1, 1, 2])}", f'type {quoted(chance.choice(["1.25", "abc", "1e400", "-", "0,9"]))}',
         "wait 3", f"seek {chance.uniform(0, 30):.2f}"] +
        ([f'open "{chance.choice(files)}"', f"resize {chance.choice(sizes)}"] if chance.random() < 0.2 else []))
