#!/usr/bin/env python3
"""Completion as it is offered by bash, zsh and fish at a terminal. The completed line is not run: Ctrl-A and a command
that prints its words go before it."""

import fcntl
import os
import pathlib
import pty
import re
import select
import shutil
import signal
import struct
import tempfile
import termios
import time

from program import check, end, expect, house, program

PATIENCE = 60  # s, until a shell is taken for stuck
PROMPT = "READY> "
# with {} the folder that has the completion, and the program as "clearance"
START = {
    "bash": (["bash", "--norc", "-i"], "complete -r 2>/dev/null; . {}/clearance.bash; bind 'set show-all-if-ambiguous on' "
             "'set bell-style none' 'set enable-bracketed-paste off'; bind 'set show-all-if-ambiguous on'; "
             "bind 'set enable-bracketed-paste off'; PS1='READY''> '"),
    "zsh": (["zsh", "-f", "-i"], "fpath=({} $fpath); autoload -Uz compinit; compinit -u -d {}/dump; bindkey -e; "
            "unsetopt prompt_sp zle_bracketed_paste 2>/dev/null; unset zle_bracketed_paste; PS1='READY''> '"),
    "fish": (["fish", "--no-config", "-i"], "source {}/clearance.fish; function fish_prompt; echo -n READY; echo -n '> '; "
             "end; set -g fish_autosuggestion_enabled 0"),
}
# what is typed before the tabulator: the last word of the completed line
WORDS = {
    "clearance stu": "study",
    "clearance study --print-s": "--print-shards",
    "clearance run flat.h": "flat.house.json",
    "clearance run flat.house.json --set door.d3.wi": "door.d3.width=",
    "clearance study flat.house.json --vary door.d3.wi": "door.d3.width=",
    "clearance run a\\ flat.house.json --set door.d3.wi": "door.d3.width=",
    "clearance run flat.house.json --driving m": "miura",
    "clearance run flat.house.json --out fol": "folder/",
    "clearance import dr": "drawing.dxf",
    "clearance schema comp": "completion",
}
# what is listed where several words fit
OFFERS = {
    "clearance study --sha": ("--shake", "--shard"),
    "clearance run flat.house.json --set door.d3.": ("door.d3.width", "door.d3.at"),
    "clearance import ": ("drawing.dxf", "flat.house.json"),
    "clearance ": ("study", "compare", "lesson"),
}


class Shell:
    def __init__(self, kind, folder):
        self.seen = ""
        words, start = START[kind]
        environment = {"PATH": f"{folder}:{os.environ['PATH']}", "HOME": str(folder), "TERM": "xterm", "LC_ALL": "C.UTF-8",
                       "CLEARANCE_ASSETS": os.environ.get("CLEARANCE_ASSETS", "")}
        self.process, self.terminal = pty.fork()
        if not self.process:
            os.chdir(folder)
            os.execvpe(words[0], words, environment)
        fcntl.ioctl(self.terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 60, 200, 0, 0))
        self.type(start.replace("{}", f"'{folder}'") + "\r")
        self.wait(lambda seen: PROMPT in seen)

    def type(self, text):
        os.write(self.terminal, text.encode())

    def wait(self, fits):
        """Reads what the shell shows until it fits. Returns whether it did."""
        until = time.monotonic() + PATIENCE
        while not fits(self.seen) and time.monotonic() < until:
            if not select.select([self.terminal], [], [], 1)[0]:
                continue
            try:
                more = os.read(self.terminal, 65536).decode(errors="replace")
            except OSError:
                break
            self.seen += re.sub(r"\x1b(\[[0-9;?>=]*[a-zA-Z]|\][^\x07]*\x07|[()][A-Z0-9]|[=>])", "", more)
        return fits(self.seen)

    def words(self, line):
        """Returns the words of the line as it is completed."""
        self.seen = ""
        self.type(line + "\t\x01words \r")
        self.wait(lambda seen: "<end>" in seen)
        return re.findall(r"<([^<>\r\n]*)>", self.seen)[:-1]

    def lists(self, line, wanted):
        """True if these words are offered for the line; the shell is of no more use."""
        self.seen = ""
        self.type(line + "\t")
        return self.wait(lambda seen: all(word in seen for word in wanted))

    def close(self):
        os.kill(self.process, signal.SIGKILL)
        os.waitpid(self.process, 0)
        os.close(self.terminal)


def prepare(folder):
    (folder / "clearance").symlink_to(program)
    (folder / "words").write_text("#!/bin/sh\nfor word; do printf '<%s>\\n' \"$word\"; done\necho '<'end'>'\n")
    (folder / "words").chmod(0o755)
    for shell, name in (("bash", "clearance.bash"), ("zsh", "_clearance"), ("fish", "clearance.fish")):
        (folder / name).write_text(expect(0, "schema", "completion", shell).stdout)
    for name in ("flat.house.json", "a flat.house.json"):
        shutil.copy(house("flat-0.910-module"), folder / name)
    (folder / "drawing.dxf").write_text("")
    (folder / "notes.txt").write_text("")
    (folder / "folder").mkdir()


with tempfile.TemporaryDirectory(prefix="clearance shells ") as directory:
    folder = pathlib.Path(directory)
    prepare(folder)
    for kind in START:
        if not shutil.which(kind):
            print(f"{kind} is not installed")
            raise SystemExit(77)
        shell = Shell(kind, folder)
        for line, word in WORDS.items():
            words = shell.words(line)
            found = [word, word.rstrip("/")] if kind == "zsh" else [word]  # zsh takes its slash back at the next key
            check(words and words[-1] in found, f"{kind}: {line}", shell.seen)
        shell.close()
        for line, wanted in OFFERS.items():
            shell = Shell(kind, folder)
            check(shell.lists(line, wanted), f"{kind} lists {wanted} for: {line}", shell.seen)
            shell.close()
end()
