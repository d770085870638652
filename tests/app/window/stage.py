"""Helpers of the window tests: an empty home folder, pictures, and the window itself, with a script under SDL's
offscreen driver or with a real mouse and keyboard under Xvfb."""

import atexit
import inspect
import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

source = pathlib.Path(os.environ.get("CLEARANCE_SOURCE", ".")).resolve()
program = pathlib.Path(sys.argv[1]).resolve()
folder = pathlib.Path(tempfile.mkdtemp(prefix="clearance-window-"))
atexit.register(shutil.rmtree, folder, ignore_errors=True)
failed = []
PATIENCE = 300  # s, longest wait for a state, even on a busy machine
SCRIPT_LARGEST = 1 << 20  # bytes, as script.c allows
TEXTS = "texts"  # the file of a window that also writes its texts
SCREEN = tuple(int(n) for n in os.environ.get("CLEARANCE_SCREEN", "1280x720").split("x"))  # of windows with real input


def house(name):
    return str(source / "houses" / f"{name}.json")


def beam(name):
    return str(source / "assets" / "beams" / f"{name}.json")


CRANK = str(source / "assets" / "cranks" / "ssc.json")
PERIODIC = ("--set", "drive.frequency=10", "--set", "run.transient_cycles=10", "--set", "run.cycles=16", "--set",
            "coupler.modes=1", "--set", "coupler.axial=0")
"""With these settings the crank's verdict is quick; the default one is watched for 6,400 revolutions."""


def check(good, what, detail=""):
    print(("ok   " if good else "FAIL ") + what + ("" if good else f": {str(detail)[:500]}"), flush=True)
    if not good:
        failed.append(what)


def end():
    print(f"{len(failed)} failures")
    sys.exit(len(failed) != 0)


def environment(home, **more):
    """Returns the environment of a new user. Leak detection is off: SDL unloads the graphics driver, whose leaks
    then cannot be distinguished from the program's."""
    home.mkdir(exist_ok=True)
    kept = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "SDL_", "DISPLAY", "WAYLAND_"))}
    return {**kept, "HOME": str(home), "SDL_AUDIODRIVER": "dummy", "LP_NUM_THREADS": "0",
            "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0", **more}


def states(path):
    """Returns the complete lines of a state file."""
    lines = path.read_text().split("\n")[:-1] if path.exists() else []
    return [json.loads(line) for line in lines]


def act(name, *lines, arguments=(), code=0, **more):
    """Runs a script without a display; `STATE` is a file, `FOLDER` a folder; `more` goes to the environment. Returns the
    states it wrote."""
    place = folder / name
    place.mkdir(exist_ok=True)
    words = re.sub(r"(?m)^until (\w+)$", rf"until \1 {PATIENCE}", "\n".join(lines))
    words = words.replace("STATE", str(place / "states")).replace("FOLDER", str(place))
    (place / "script").write_text(words + "\nquit\n")
    done = subprocess.run([program, "open", *arguments, "--script", str(place / "script")], cwd=place,
                          timeout=10 * PATIENCE, capture_output=True, text=True,
                          env=environment(place / "home", SDL_VIDEODRIVER="offscreen", **more))
    check(done.returncode == code, f"{name}: the script runs to its end", f"exit code {done.returncode}: {done.stderr}")
    return states(place / "states")


def is_settled(state):
    """True if the picture and the answer hold all that is worked out in the background, the grade as well."""
    answer = state["answer"]
    return state["complete"] and not (answer["stale"] or answer["doing"] or answer["grading"])


def magick(*arguments):
    return subprocess.run(arguments, capture_output=True, text=True, timeout=600)


def crop(box):
    """Converts a box of the state to ImageMagick's format."""
    x, y, right, bottom = (round(v) for v in box)
    return f"{right - x}x{bottom - y}+{x}+{y}"


def differing(a, b, box=None, fuzz="3%"):
    """Returns how many pixels differ between two pictures, or parts of them."""
    part = ["-crop", crop(box), "+repage"] if box else []
    done = magick("compare", "-metric", "AE", "-fuzz", fuzz, *part, str(a), str(b), "null:")
    return float(done.stderr.split()[0])


def colours(path, box):
    """Returns the colours of a part, most frequent first: (count, (red, green, blue))."""
    done = magick("convert", str(path), "-crop", crop(box), "+repage", "-depth", "8", "-format", "%c", "histogram:info:-")
    found = []
    for line in done.stdout.splitlines():
        if ":" in line and "#" in line:
            code = line.split("#")[1][:6]
            found.append((int(line.split(":")[0]), tuple(int(code[i:i + 2], 16) for i in (0, 2, 4))))
    return sorted(found, reverse=True)


def contrast(a, b):
    def luminance(colour):
        parts = [c / 255 / 12.92 if c / 255 <= 0.04045 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in colour]
        return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


SHIFTED = '~!@#$%^&*()_+{}|:"<>?'  # characters typed with Shift, apart from capitals; their keys follow
UNSHIFTED = str.maketrans(SHIFTED, "`1234567890-=[]\\;',./")


def is_shifted(letter):
    return letter.isupper() or letter in SHIFTED


class Screen:
    """The program on its own display, operated by xdotool through real input events. A script that repeatedly writes
    the state reports on the program. The state counts the presses and releases that the program has handled, and
    contains the position of the mouse: each input is followed by a wait for its effect, never for a fixed time. The window
    is as large as the display, or, if it is not `whole`, as the program chooses. With `texts` its texts are written, too."""

    def __init__(self, name, *arguments, width=SCREEN[0], height=SCREEN[1], minutes=5, whole=True, texts=False):
        self.place = folder / name
        self.place.mkdir(exist_ok=True)
        self.display = self.start_display(width, height)
        self.log = self.place / "states"
        self.log_read, self.log_count, self.last = 0, 0, {}  # bytes and lines read so far, last state
        self.sent = 0  # number of presses and releases sent
        script = self.place / "script"
        script.write_text(self.script_of(minutes, texts))
        self.env = environment(self.place / "home", DISPLAY=self.display, SDL_MOUSE_DOUBLE_CLICK_TIME="0")
        if (width, height) != (1280, 720) and whole:
            arguments = ("--size", f"{width}x{height}", *arguments)
        self.errors = open(self.place / "errors", "w")
        self.program = subprocess.Popen([program, "open", *arguments, "--script", str(script)], cwd=self.place,
                                        env=self.env, stdout=self.errors, stderr=self.errors)
        self.until(lambda s: True, may_end=True)
        if self.program.poll() is not None:
            sys.exit(f"the window does not open: {(self.place / 'errors').read_text()}")
        self.window = self.tool("search", "--sync", "--onlyvisible", "--name", "clearance").stdout.split()[0]
        self.tool("windowfocus", "--sync", self.window)

    def script_of(self, minutes, texts):
        """Returns a script that writes the state for a time, as often as one script can hold."""
        for frames in itertools.count(1):
            step = f"wait {frames}\nstate {self.log.name}\n" + (f"texts {TEXTS}\n" if texts else "")
            script = step * int(minutes * 60 * 60 / frames) + "quit\n"
            if len(script) <= SCRIPT_LARGEST:
                return script

    def start_display(self, width, height):
        """Starts a display without key repeat, since releases may come late."""
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-r",
                                        "-nolisten", "tcp"], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        return ":" + os.read(read, 20).decode().strip()

    def tool(self, *words):
        return subprocess.run(["xdotool", *[str(w) for w in words]], env=self.env, capture_output=True, text=True,
                              timeout=600)

    def input(self, count, *words):
        """Sends `count` presses and releases, and waits until they are handled."""
        self.tool(*words)
        self.sent += count
        self.handled(lambda s: s["inputs"] >= self.sent, words)

    def handled(self, what, words):
        """Waits for the effect of an input."""
        now = self.until(what)
        if not what(now):
            check(False, "what was done is handled", (words, self.sent, now.get("inputs"), now.get("mouse")))
            self.program.kill()
            self.server.kill()
            end()

    def look(self):
        """Reads the new states; returns the last one."""
        if self.log.exists():
            with open(self.log, "rb") as log:
                log.seek(self.log_read)
                whole, end, _ = log.read().rpartition(b"\n")
            lines = whole.split(b"\n")
            if end:
                self.log_read += len(whole) + 1
                self.log_count += len(lines)
                self.last = json.loads(lines[-1])
        return self.last

    def state(self):
        """Returns the present state: the second line written after the call, since the first may be older."""
        self.look()
        count = self.log_count + 2
        return self.until(lambda s: self.log_count >= count)

    def texts(self):
        """Returns the present texts of the window, but for the labels of its view, which are in the state."""
        self.state()
        return states(self.place / TEXTS)[-1]

    def until(self, what, patience=PATIENCE, may_end=False):
        """Waits for a state; returns the last state read. It is a failure that it does not come, unless the program may
        end instead."""
        begun = time.monotonic()
        while time.monotonic() - begun < patience and self.program.poll() is None:
            now = self.look()
            if now and what(now):
                return now
            time.sleep(0.01)
        now = self.look()
        ended = may_end and self.program.poll() is not None
        check(ended or now and what(now), "the state that is waited for comes", inspect.stack()[1].lineno)
        return now

    def keys(self, *names):
        """Presses and releases keys like ctrl+z, one after another. A repeated key is sent after the previous one was
        handled: on a busy machine both may have the same time stamp and would be taken for an automatic repeat."""
        waiting = []
        for name in names:
            if set(name.split("+")) & {key for other in waiting for key in other.split("+")}:
                self.press_keys(waiting)
                waiting = []
            waiting.append(name)
        self.press_keys(waiting)
        self.state()

    def press_keys(self, names):
        self.input(sum(2 * len(name.split("+")) for name in names), "key", "--delay", 0, *names)

    def type(self, words):
        """Types characters, in pieces that need no key twice."""
        waiting, used = "", set()
        for letter in words:
            needed = {letter.lower().translate(UNSHIFTED)} | ({"shift"} if is_shifted(letter) else set())
            if needed & used:
                self.type_piece(waiting)
                waiting, used = "", set()
            waiting, used = waiting + letter, used | needed
        self.type_piece(waiting)
        self.state()

    def type_piece(self, words):
        self.input(sum(4 if is_shifted(letter) else 2 for letter in words), "type", "--delay", 0, "--", words)

    def hold(self, key):
        self.input(1, "keydown", key)

    def let_go(self, key):
        self.input(1, "keyup", key)

    def press(self):
        self.input(1, "mousedown", 1)

    def release(self):
        self.input(1, "mouseup", 1)
        self.state()

    def point_to(self, x, y):
        x, y = round(x), round(y)
        self.tool("mousemove", x, y)
        self.handled(lambda s: s["mouse"] == [x, y], ("mousemove", x, y))
        self.state()

    def click(self, x, y):
        self.point_to(x, y)
        self.input(2, "click", 1)
        self.state()

    def shot(self, name):
        """Takes a picture of the display after the next state was written."""
        self.state()
        path = self.place / f"{name}.png"
        subprocess.run(["import", "-window", "root", str(path)], env=self.env, timeout=600)
        return path

    def crash(self):
        """Kills the program once it has kept what is not saved; another one with this name finds that."""
        kept = self.place / "home" / ".local" / "state" / "clearance" / "recovery"
        self.until(lambda s: list(kept.glob("*.about")))
        self.program.kill()
        self.program.wait()
        self.server.terminate()
        self.server.wait()
        self.log.unlink()

    def end(self):
        self.tool("key", "ctrl+q")
        self.sent += 4
        if self.until(lambda s: s["sheet"] in ("leave", "lesson"), may_end=True).get("sheet") in ("leave", "lesson"):
            self.keys("Tab")
            self.tool("key", "Return")
        try:
            code = self.program.wait(60)
        except subprocess.TimeoutExpired:
            self.program.kill()
            code = "none"
        self.server.terminate()
        self.server.wait()
        check(code == 0, "the window closes", f"exit code {code}: {(self.place / 'errors').read_text()[-2000:]}")
