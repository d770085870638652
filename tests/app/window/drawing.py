"""Draws on a plan with a real mouse and real keys; places are in metres."""

from stage import Screen


class Plan(Screen):
    """A window with a house that can be edited."""

    def point(self, x, y, state=None):
        """Returns the pixel of a place on the floor."""
        origin, right, up = (state or self.state())["floor"]
        return tuple(origin[i] + x * (right[i] - origin[i]) + y * (up[i] - origin[i]) for i in (0, 1))

    def move(self, x, y):
        self.point_to(*self.point(x, y))

    def put(self, x, y):
        """Clicks on a place on the floor."""
        self.click(*self.point(x, y))

    def drag(self, x, y, to_x, to_y, release=True):
        state = self.state()
        places = [self.point(x + part * (to_x - x), y + part * (to_y - y), state) for part in (0, 0.25, 0.5, 0.75, 1)]
        self.point_to(*places[0])
        self.press()
        for place in places[1:]:
            self.point_to(*place)
        if release:
            self.release()

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
        self.until(lambda s: s["sheet"] == "save")
        self.keys("ctrl+a")
        self.type(str(path))
        self.keys("Return")
        self.until(lambda s: s["sheet"] == "none")


