"""A hand on a plan: places in metres, by a real mouse and real keys."""

import time

from stage import Screen


class Plan(Screen):
    """The window with a house that can be edited."""

    def point(self, x, y, state=None):
        """Pixels of a place on the floor."""
        origin, right, up = (state or self.state())["floor"]
        return tuple(origin[i] + x * (right[i] - origin[i]) + y * (up[i] - origin[i]) for i in (0, 1))

    def move(self, x, y):
        px, py = self.point(x, y)
        self.tool("mousemove", round(px), round(py))
        time.sleep(0.1)

    def put(self, x, y, *held):
        """A click there, with keys held."""
        self.move(x, y)
        for key in held:
            self.tool("keydown", key)
        self.tool("click", 1)
        for key in held:
            self.tool("keyup", key)
        time.sleep(0.15)

    def drag(self, x, y, to_x, to_y, release=True):
        self.move(x, y)
        self.tool("mousedown", 1)
        time.sleep(0.1)
        for part in (0.25, 0.5, 0.75, 1):
            px, py = self.point(x + part * (to_x - x), y + part * (to_y - y))
            self.tool("mousemove", round(px), round(py))
            time.sleep(0.08)
        if release:
            self.tool("mouseup", 1)
            time.sleep(0.15)

    def undo_all(self):
        for _ in range(200):
            if not self.state()["undo_name"]:
                return
            self.keys("ctrl+z")

    def redo_all(self):
        for _ in range(200):
            if not self.state()["redo_name"]:
                return
            self.keys("ctrl+y")

    def save_as(self, path):
        self.keys("ctrl+shift+s")
        self.until(lambda s: s["sheet"] == "save", 10)
        self.keys("ctrl+a")
        self.type(str(path))
        self.keys("Return")
        self.until(lambda s: s["sheet"] == "none", 10)


