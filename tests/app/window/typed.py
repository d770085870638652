#!/usr/bin/env python3
"""Tests by a real pointer and real keys that the corners of walls and rooms, the ends of exits, the time at which an exit
closes and the height of a wall are typed on the panel, and the kind of a door is chosen there, each as one undo step."""

import json

import stage
from drawing import Plan
from stage import check

HOUSE = {
    "format": "clearance-house", "version": 1, "name": "a room", "note": "",
    "walls": [{"id": "w1", "points": [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]}],
    "doors": [{"id": "d1", "wall": "w1", "segment": 1, "at": 1.5, "width": 1.0, "kind": "opening"}],
    "rooms": [{"id": "r1", "name": "hall", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}],
    "exits": [{"id": "e1", "from": [4.8, 1.0], "to": [4.8, 2.0]}],
    "people": [{"id": "p1", "profile": "manual-chair", "at": [0.9, 1.5]}],
    "routes": [{"id": "A", "people": ["p1"], "via": [], "exit": "e1"}]}


def field(label):
    """Returns the box of the text in the field below a label of the panel, and that text."""
    panel = window.state()["frame"]["panel"]
    texts = [text for text in window.texts() if text["box"][0] >= panel[0] - 1]
    words = next((text["box"] for text in texts if text["string"] == label), None)
    if not words:
        return None, [text["string"] for text in texts]
    below = [text for text in texts if words[3] - 1 <= text["box"][1] < words[3] + 30]
    return (below[0]["box"], below[0]["string"]) if below else (None, "")


def change(label, value, step):
    """Types a value in a field, and checks that this is one step; `step` None: it is refused."""
    box, before = field(label)
    edits = window.state()["edits"]
    check(box, f"there is a field for {label}", before)
    if not box:
        return
    window.click(box[0] + 8, (box[1] + box[3]) / 2)
    window.keys("ctrl+a", "BackSpace")
    if value:
        window.type(value)
    window.keys("Return")
    if not step:
        return
    done = window.until(lambda s: s["edits"] == edits + 1 and s["complete"] and not s["answer"]["stale"])
    check(done["undo_name"] == step and done["edits"] == edits + 1, f"{label}: typed as one step", (done["undo_name"], done["edits"]))


house = stage.folder / "room.json"
house.write_text(json.dumps(HOUSE))
window = Plan("typed", house, height=1000, minutes=9, texts=True)
window.until(stage.is_settled)
window.keys("space", "w", "Escape")

window.put(4.8, 1.3)
check(field("ends, m")[1] == "4.8 1; 4.8 2" and field("closes at")[1] == "never", "an exit tells its ends and its time",
      (field("ends, m"), field("closes at")))
window.shot("exit")
change("ends, m", "4.9 0.9; 490cm 2.1", "Change the ends of exit e1")
change("closes at", "2 min", "Change the closing time of exit e1")
change("closes at", "", "Change the closing time of exit e1")
check(field("closes at")[1] == "never", "an empty time is none", field("closes at"))
change("closes at", "120", "Change the closing time of exit e1")

# a refused text stays to be corrected, and the message says what would be right here
edits = window.state()["edits"]
change("ends, m", "4.9 0.9; 4.9 2.1; 5 3", None)
said = window.until(lambda s: "3 ends" in s["message"])["message"]
check("0 1; 0 2" in said, "the fault gives an example of two ends", said)
window.until(lambda s: field("ends, m \u00b7 not applied")[0])
check(field("ends, m \u00b7 not applied")[1] == "4.9 0.9; 4.9 2.1; 5 3" and window.state()["edits"] == edits,
      "the refused ends stay in their field", field("ends, m \u00b7 not applied"))
window.shot("refused")
window.put(1, 0)
window.put(4.9, 1.3)
check(field("ends, m")[1] == "4.9 0.9; 4.9 2.1", "and are gone once another thing was selected", field("ends, m"))

window.put(1, 0)
check(field("corners, m")[1] == "0 0; 4 0; 4 3; 0 3; 0 0", "a wall tells its corners", field("corners, m"))
window.shot("wall")
change("corners, m", "0 0; 4.5 0; 4.5 3; 0 3; 0 0", "Change the corners of wall")

# a door's kind, its hinge and the side to which it opens; values without an effect on the kind are not shown
def panel_word(word):
    panel = window.state()["frame"]["panel"]
    return next((t["box"] for t in window.texts() if t["string"] == word and t["box"][0] >= panel[0] - 1), None)


window.put(4.5, 1.15)
check(window.state()["selected"] == "door d1" and not panel_word("hinge at the wall's"), "an opening has no hinge",
      window.state()["selected"])
for word, step in (("hinged", "kind"), ("end", "hinge"), ("right", "opens to")):
    box, edits = panel_word(word), window.state()["edits"]
    check(box, f"a door can be {word}")
    window.click((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
    window.until(lambda s: s["edits"] == edits + 1 and s["complete"] and not s["answer"]["stale"])
window.shot("door")

window.keys("ctrl+s")
window.until(lambda s: not s["unsaved"])
saved = json.loads(house.read_text())
check(saved["exits"][0] == {"id": "e1", "from": [4.9, 0.9], "to": [4.9, 2.1], "closes": 120}, "saved: the exit", saved["exits"])
door = {member: saved["doors"][0].get(member) for member in ("kind", "hinge", "swing")}
check(door == {"kind": "hinged", "hinge": "end", "swing": "right"}, "saved: the door", door)
check(saved["walls"][0]["points"][1:3] == [[4.5, 0], [4.5, 3]], "saved: the wall", saved["walls"])

window.keys(*8 * ["ctrl+z"], "ctrl+s")
window.until(lambda s: not s["unsaved"])
back = json.loads(house.read_text())
check({part: back[part] for part in ("walls", "exits")} == {part: HOUSE[part] for part in ("walls", "exits")}, "undone: as before",
      back)
window.end()
stage.end()
