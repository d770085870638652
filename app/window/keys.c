#include "window/keys.h"

#include <string.h>

#include "laboratory/laboratories.h"
#include "platform/sdl_window.h"

const char *const keys_menus[MENUS] = {[MENU_FILE] = "File", [MENU_EDIT] = "Edit", [MENU_TOOLS] = "Tools",
                                       [MENU_VIEW] = "View", [MENU_RUN] = "Run",   [MENU_HELP] = "Help"};

static const KeyRow table[] = {
    {ACTION_NEW, KEY_ANYWHERE, "Ctrl+N", MENU_FILE, "New house", "begins with an empty plan", NULL},
    {ACTION_OPEN, KEY_ANYWHERE, "Ctrl+O", MENU_FILE, "Open ...", "opens a house or a beam from a file", NULL},
    {ACTION_GALLERY, KEY_ANYWHERE, "F4", MENU_FILE, "Gallery", "shows the houses and beams there are, with pictures",
     "gallery"},
    {ACTION_SAVE, KEY_ANYWHERE, "Ctrl+S", MENU_FILE, "Save",
     "writes what is shown to its file; asks for a name when there is none of your own", NULL},
    {ACTION_SAVE_COPY, KEY_ANYWHERE, "Ctrl+Shift+S", MENU_FILE, "Save as ...",
     "writes what is shown, with its changed numbers, as another file", NULL},
    {ACTION_PICTURE, KEY_ANYWHERE, "F9", MENU_FILE, "Picture",
     "writes the view, or the plot with the focus, as PNG and SVG", NULL},
    {ACTION_FRAMES, KEY_ANYWHERE, "Shift+F9", MENU_FILE, "Frames",
     "writes a picture for every thirtieth of a simulated second", NULL},
    {ACTION_EXPORT, KEY_ANYWHERE, "Ctrl+E", MENU_FILE, "Export ...", "writes pictures, plots, data, a film or a report",
     NULL},
    {ACTION_COPY_COMMAND, KEY_ANYWHERE, "Ctrl+C", MENU_FILE, "Copy command",
     "copies the command line that makes what is shown", NULL},
    {ACTION_QUIT, KEY_ANYWHERE, "Ctrl+Q", MENU_FILE, "Quit", "closes the window", NULL},

    {ACTION_UNDO, KEY_ANYWHERE, "Ctrl+Z", MENU_EDIT, "Undo", "takes the last edit back", NULL},
    {ACTION_REDO, KEY_ANYWHERE, "Ctrl+Shift+Z", MENU_EDIT, "Redo", "does again what was undone", NULL},
    {ACTION_REDO, KEY_ANYWHERE, "Ctrl+Y", MENU_NONE, NULL, NULL, NULL},
    {ACTION_CUT, KEY_PLAN, "Ctrl+X", MENU_EDIT, "Cut", "copies what is selected, and removes it", NULL},
    {ACTION_COPY, KEY_PLAN, "Ctrl+C", MENU_EDIT, "Copy",
     "copies what is selected; with nothing selected, the command line", NULL},
    {ACTION_PASTE, KEY_PLAN, "Ctrl+V", MENU_EDIT, "Paste", "puts what was copied where the pointer is", NULL},
    {ACTION_DUPLICATE, KEY_PLAN, "Ctrl+D", MENU_EDIT, "Duplicate", "puts a copy beside what is selected", NULL},
    {ACTION_DELETE, KEY_PLAN, "Delete", MENU_EDIT, "Delete", "removes what is selected", NULL},
    {ACTION_DELETE, KEY_PLAN, "Backspace", MENU_NONE, NULL, NULL, NULL},
    {ACTION_SELECT_ALL, KEY_PLAN, "Ctrl+A", MENU_EDIT, "Select all", "selects everything that can be moved", NULL},
    {ACTION_UNDO_ALL, KEY_ANYWHERE, "Alt+R", MENU_EDIT, "Reset scene", "puts everything as it is in the file", NULL},
    {ACTION_EDIT_NUMBERS, KEY_VIEW, "Return", MENU_EDIT, "Numbers", "goes to the numbers of what is selected", NULL},
    {ACTION_USE_CURSOR, KEY_PLOT, "Return", MENU_NONE, "Use value", "sets the number to where the cursor stands", NULL},
    {ACTION_NEXT_THING, KEY_VIEW, "Tab", MENU_EDIT, "Next object",
     "selects the next person, place of danger, door, piece of furniture, wall, exit", "objects"},
    {ACTION_PREVIOUS_THING, KEY_VIEW, "Shift+Tab", MENU_EDIT, "Previous object", "selects the one before", NULL},
    {ACTION_KEEP, KEY_CANVAS, "K", MENU_EDIT, "Keep as before", "keeps what is shown, to be seen behind what follows",
     "keep"},
    {ACTION_GHOST, KEY_CANVAS, "G", MENU_EDIT, "Next ghost", "shows what was before, or the other way of driving",
     "ghost"},
    {ACTION_CLEAR, KEY_CANVAS, "X", MENU_EDIT, "Clear", "forgets the trace and the points so far", NULL},

    {ACTION_TOOL_SELECT, KEY_PLAN, "S", MENU_TOOLS, "Select", "picks things, moves them, takes up their handles", NULL},
    {ACTION_TOOL_WALL, KEY_PLAN, "W", MENU_TOOLS, "Wall", "draws walls from corner to corner; digits are a length",
     "wall"},
    {ACTION_TOOL_DOOR, KEY_PLAN, "D", MENU_TOOLS, "Door", "puts a door or an opening into a wall", "door"},
    {ACTION_TOOL_FURNITURE, KEY_PLAN, "O", MENU_TOOLS, "Furniture", "places furniture, of a catalogue or free",
     "furniture"},
    {ACTION_TOOL_PERSON, KEY_PLAN, "P", MENU_TOOLS, "Person", "places somebody, in a wheelchair or on foot", NULL},
    {ACTION_TOOL_EXIT, KEY_PLAN, "X", MENU_TOOLS, "Exit", "draws the line behind which people are out", NULL},
    {ACTION_TOOL_MEASURE, KEY_PLAN, "M", MENU_TOOLS, "Measure", "tells how wide it is between two points or faces",
     "measure"},
    {ACTION_TOOL_AREA, KEY_PLAN, "A", MENU_TOOLS, "Room", "names a room", NULL},
    {ACTION_TOOL_ROUTE, KEY_PLAN, "Y", MENU_TOOLS, "Route", "draws the way that somebody takes", NULL},
    {ACTION_TOOL_IMAGE, KEY_PLAN, "B", MENU_TOOLS, "Picture to trace", "puts a picture below the plan, to trace over",
     NULL},
    {ACTION_TOPPLE, KEY_PLAN, "T", MENU_TOOLS, "Topple", "topples the selected furniture, or stands it up", "topple"},
    {ACTION_SHAKE, KEY_PLAN, "Shift+T", MENU_TOOLS, "Shake",
     "makes an earthquake, in which furniture falls by its chances; again: another one, by the next seed", NULL},
    {ACTION_SPLIT, KEY_PLAN, "Shift+W", MENU_TOOLS, "Split wall", "makes a corner in the middle of the selected wall",
     NULL},
    {ACTION_SNAP, KEY_PLAN, "N", MENU_TOOLS, "Snapping", "lets the hand catch corners, faces and angles, or not", NULL},
    {ACTION_HANDLE, KEY_PLAN, "J", MENU_TOOLS, "Next handle",
     "goes round the corners and ends of what is selected, for the arrows to move", NULL},
    {ACTION_HANDLE_BACK, KEY_PLAN, "Shift+J", MENU_TOOLS, "Previous handle", "goes round the other way", NULL},
    {ACTION_NUDGE_LEFT, KEY_PLAN, "Left", MENU_NONE, "Nudge left",
     "moves what is selected by 1 cm, Shift 10 cm, Ctrl 1 mm; with nothing selected, the view", NULL},
    {ACTION_NUDGE_LEFT, KEY_PLAN, "Shift+Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_LEFT, KEY_PLAN, "Ctrl+Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_RIGHT, KEY_PLAN, "Right", MENU_NONE, "Nudge right", "the same, to the right", NULL},
    {ACTION_NUDGE_RIGHT, KEY_PLAN, "Shift+Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_RIGHT, KEY_PLAN, "Ctrl+Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_UP, KEY_PLAN, "Up", MENU_NONE, "Nudge up", "the same, upwards", NULL},
    {ACTION_NUDGE_UP, KEY_PLAN, "Shift+Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_UP, KEY_PLAN, "Ctrl+Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_DOWN, KEY_PLAN, "Down", MENU_NONE, "Nudge down", "the same, downwards", NULL},
    {ACTION_NUDGE_DOWN, KEY_PLAN, "Shift+Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_DOWN, KEY_PLAN, "Ctrl+Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_TURN_LITTLE_LEFT, KEY_PLAN, "Shift+Q", MENU_NONE, "Turn left a little",
     "turns what is selected by 1 degree", NULL},
    {ACTION_TURN_LITTLE_RIGHT, KEY_PLAN, "Shift+E", MENU_NONE, "Turn right a little", "the other way", NULL},

    {ACTION_FIT, KEY_CANVAS, "Home", MENU_VIEW, "Fit", "shows all of it", NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "=", MENU_VIEW, "Zoom in", "enlarges about the middle", NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "+", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "Shift+=", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "Keypad +", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_OUT, KEY_CANVAS, "-", MENU_VIEW, "Zoom out", "makes it smaller", NULL},
    {ACTION_ZOOM_OUT, KEY_CANVAS, "Keypad -", MENU_NONE, NULL, NULL, NULL},
    {ACTION_BOX, KEY_PLOT, "Z", MENU_NONE, "Zoom to a box",
     "arrows move a corner, Return sets it, arrows move the other, Return zooms", NULL},
    {ACTION_BOX_BACK, KEY_PLOT, "Backspace", MENU_NONE, "View before", "goes back to the axes before", NULL},
    {ACTION_CURSOR_LEFT, KEY_PLOT, "Left", MENU_NONE, "Cursor left", "moves the cursor; Shift: tenfold", NULL},
    {ACTION_CURSOR_LEFT, KEY_PLOT, "Shift+Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_CURSOR_RIGHT, KEY_PLOT, "Right", MENU_NONE, "Cursor right", "moves the cursor; Shift: tenfold", NULL},
    {ACTION_CURSOR_RIGHT, KEY_PLOT, "Shift+Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_SELECTION, KEY_VIEW, "Z", MENU_VIEW, "Zoom to selection", "shows what is selected from near", NULL},
    {ACTION_PAN_LEFT, KEY_VIEW, "Left", MENU_NONE, "Look left", "moves the view", NULL},
    {ACTION_PAN_RIGHT, KEY_VIEW, "Right", MENU_NONE, "Look right", "moves the view", NULL},
    {ACTION_PAN_UP, KEY_VIEW, "Up", MENU_NONE, "Look up", "moves the view", NULL},
    {ACTION_PAN_DOWN, KEY_VIEW, "Down", MENU_NONE, "Look down", "moves the view", NULL},
    {ACTION_RAISED, KEY_CANVAS, "V", MENU_VIEW, "Plan or raised", "looks from above, or from the side", "raised"},
    {ACTION_TURN_LEFT, KEY_VIEW, "Q", MENU_VIEW, "Turn left",
     "turns what is selected by 15 degrees, or the raised view", NULL},
    {ACTION_TURN_RIGHT, KEY_VIEW, "E", MENU_VIEW, "Turn right", "turns it the other way", NULL},
    {ACTION_FOLLOW, KEY_VIEW, "F", MENU_VIEW, "Follow", "keeps the selected person, or the first, in the middle", NULL},
    {ACTION_LAYER, KEY_CANVAS, "1", MENU_NONE, "Layers", "1 to 9 show or hide a layer: the panel names them", NULL},
    {ACTION_LAYER, KEY_CANVAS, "2", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "3", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "4", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "5", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "6", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "7", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "8", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "9", MENU_NONE, NULL, NULL, NULL},
    {ACTION_PANEL, KEY_CANVAS, "H", MENU_VIEW, "Panel", "shows or hides the panel", NULL},
    {ACTION_PLOTS, KEY_CANVAS, "Shift+P", MENU_VIEW, "Plots", "shows or hides the plots", "plots"},
    {ACTION_PRESENT, KEY_ANYWHERE, "F5", MENU_VIEW, "Present", "hides all but picture and answer, letters larger",
     NULL},
    {ACTION_FULLSCREEN, KEY_ANYWHERE, "F11", MENU_VIEW, "Full screen", "fills the screen, or not", NULL},
    {ACTION_THEME, KEY_ANYWHERE, "Ctrl+T", MENU_VIEW, "Light or dark", "paper for bright rooms, board for dark ones",
     NULL},
    {ACTION_LARGER, KEY_ANYWHERE, "Ctrl+=", MENU_VIEW, "Larger letters", "up to three times", NULL},
    {ACTION_LARGER, KEY_ANYWHERE, "Ctrl++", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LARGER, KEY_ANYWHERE, "Ctrl+Shift+=", MENU_NONE, NULL, NULL, NULL},
    {ACTION_SMALLER, KEY_ANYWHERE, "Ctrl+-", MENU_VIEW, "Smaller letters", "down to their own size", NULL},
    {ACTION_NORMAL_SIZE, KEY_ANYWHERE, "Ctrl+0", MENU_VIEW, "Normal letters", "their own size", NULL},

    {ACTION_PLAY, KEY_CANVAS, "Space", MENU_RUN, "Play or pause", "goes on, or holds", "play, pause"},
    {ACTION_PLAY, KEY_TIMELINE, "Space", MENU_NONE, NULL, NULL, NULL},
    {ACTION_PLAY, KEY_ANYWHERE, "Alt+K", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP, KEY_CANVAS, ".", MENU_RUN, "Step", "one picture on, and pauses; Shift: ten", "step"},
    {ACTION_STEP, KEY_TIMELINE, "Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP_BACK, KEY_CANVAS, ",", MENU_RUN, "Step back", "one picture back, and pauses; Shift: ten", NULL},
    {ACTION_STEP_BACK, KEY_TIMELINE, "Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP_TEN, KEY_CANVAS, "Shift+.", MENU_NONE, "Ten steps", "ten pictures on", NULL},
    {ACTION_STEP_TEN, KEY_CANVAS, "Shift+>", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP_BACK_TEN, KEY_CANVAS, "Shift+,", MENU_NONE, "Ten steps back", "ten pictures back", NULL},
    {ACTION_STEP_BACK_TEN, KEY_CANVAS, "Shift+<", MENU_NONE, NULL, NULL, NULL},
    {ACTION_SECOND, KEY_TIMELINE, "Shift+Right", MENU_NONE, "A second on", "at speed 1", NULL},
    {ACTION_SECOND_BACK, KEY_TIMELINE, "Shift+Left", MENU_NONE, "A second back", "at speed 1", NULL},
    {ACTION_SLOWER, KEY_CANVAS, "[", MENU_RUN, "Slower", "half the speed", "speed"},
    {ACTION_SLOWER, KEY_TIMELINE, "Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_FASTER, KEY_CANVAS, "]", MENU_RUN, "Faster", "twice the speed", NULL},
    {ACTION_FASTER, KEY_TIMELINE, "Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NORMAL_SPEED, KEY_CANVAS, "\\", MENU_RUN, "Speed 1", "the laboratory's own pace", NULL},
    {ACTION_AGAIN, KEY_CANVAS, "R", MENU_RUN, "Run again", "from the beginning, with the same numbers", "again"},
    {ACTION_START, KEY_TIMELINE, "Home", MENU_RUN, "Start", "to the beginning of the record", NULL},
    {ACTION_NOW, KEY_TIMELINE, "End", MENU_RUN, "Now", "to the end of the record, and on", NULL},
    {ACTION_NOW, KEY_CANVAS, "End", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LOOP, KEY_CANVAS, "L", MENU_RUN, "Loop", "plays the marked stretch, or all, again and again", NULL},
    {ACTION_LOOP, KEY_TIMELINE, "L", MENU_NONE, NULL, NULL, NULL},
    {ACTION_MARK_IN, KEY_TIMELINE, "I", MENU_RUN, "Mark in", "the loop begins here", NULL},
    {ACTION_MARK_OUT, KEY_TIMELINE, "O", MENU_RUN, "Mark out", "the loop ends here", NULL},
    {ACTION_SWEEP, KEY_CANVAS, "U", MENU_RUN, "Sweep", "the orbit diagram from rest, or upwards and downwards", NULL},
    {ACTION_SOUND, KEY_ANYWHERE, "Ctrl+M", MENU_RUN, "Sound", "makes the tip's motion heard, or not", NULL},

    {ACTION_HELP, KEY_ANYWHERE, "F1", MENU_HELP, "Keys", "shows this card", "keys"},
    {ACTION_EXPLAIN, KEY_ANYWHERE, "Shift+F1", MENU_HELP, "Explain", "tells about what has the focus", NULL},
    {ACTION_MESSAGES, KEY_ANYWHERE, "F7", MENU_HELP, "Messages", "shows what was said, and what went wrong", NULL},
    {ACTION_ABOUT, KEY_ANYWHERE, "Ctrl+I", MENU_HELP, "About", "the program, its version, its sources", NULL},
    {ACTION_MENU, KEY_ANYWHERE, "F10", MENU_NONE, "Menu", "opens the menus", NULL},
    {ACTION_ESCAPE, KEY_ANYWHERE, "Escape", MENU_NONE, "One step back",
     "closes what is open, or lets go what is selected; it never quits", NULL},
};
enum { ROWS = sizeof table / sizeof *table };

size_t keys_count(void) {
    return ROWS + laboratories_count;
}

KeyRow keys_at(size_t i) {
    if (i < ROWS)
        return table[i];
    const LaboratoryRow *row = &laboratories[i - ROWS];
    return (KeyRow){.action = ACTION_LABORATORY + (Action)(i - ROWS),
                    .place = KEY_ANYWHERE,
                    .key = row->key,
                    .name = row->laboratory->name,
                    .help = row->help};
}

KeyRow keys_row(Action action) {
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        if (row.action == action && row.name)
            return row;
    }
    return (KeyRow){.action = ACTION_NONE};
}

void keys_read(const char *text, int32_t *key, int *mods) {
    static const struct {
        const char *word;
        int mod;
    } known[] = {
        {"Ctrl+", SDL_WINDOW_EVENT_CONTROL}, {"Shift+", SDL_WINDOW_EVENT_SHIFT}, {"Alt+", SDL_WINDOW_EVENT_ALT}};
    *mods = 0;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        size_t length = strlen(known[i].word);
        if (strncmp(text, known[i].word, length) == 0 && text[length]) {
            *mods |= known[i].mod;
            text += length;
        }
    }
    *key = sdl_window_key(text);
}

/* True for a letter, digit or sign alone, which is easily pressed by mistake. */
static bool is_single(const KeyRow *row) {
    return !row->key[1];
}

/* Returns how specific a row is for a place; 0: it does not apply there. */
static int narrowness(const KeyRow *row, KeyPlace place) {
    bool view = place == KEY_VIEW || place == KEY_PLAN;
    switch (row->place) {
    case KEY_ANYWHERE:
        return 1;
    case KEY_CANVAS:
        return view || place == KEY_PLOT ? 2 : 0;
    case KEY_VIEW:
        return view ? 3 : 0;
    default:
        return row->place == place ? 4 : 0;
    }
}

Action keys_find(int32_t key, int mods, KeyPlace place, bool single_keys) {
    Action found = ACTION_NONE;
    int narrowest = 0;
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        int32_t row_key;
        int row_mods, narrow = narrowness(&row, place);
        keys_read(row.key, &row_key, &row_mods);
        if (row_key == key && row_mods == mods && narrow > narrowest && (single_keys || !is_single(&row))) {
            found = row.action;
            narrowest = narrow;
        }
    }
    return found;
}

const char *keys_help(Arena *arena, Action action) {
    KeyRow row = keys_row(action);
    return text_in_arena(arena, "%s (%s): %s", row.name, row.key, row.help);
}
