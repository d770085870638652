#include "window/keys.h"

#include <string.h>

#include "laboratory/laboratories.h"
#include "platform/sdl_window.h"

const char *const keys_menus[MENUS] = {
    [MENU_FILE] = "File", [MENU_EDIT] = "Edit",   [MENU_TOOLS] = "Tools", [MENU_VIEW] = "View",
    [MENU_RUN] = "Run",   [MENU_LEARN] = "Learn", [MENU_HELP] = "Help"};

static const KeyRow table[] = {
    {ACTION_NEW, KEY_ANYWHERE, "Ctrl+N", MENU_FILE, "New house", "Begin a new house with an empty plan", NULL},
    {ACTION_OPEN, KEY_ANYWHERE, "Ctrl+O", MENU_FILE, "Open or import ...",
     "Open a house, a beam, a crank or a lesson, or import a plan (DXF, WKT, SH3D, Vadere)", NULL},
    {ACTION_GALLERY, KEY_ANYWHERE, "F4", MENU_FILE, "Gallery",
     "Show the shipped houses, beams and cranks with pictures", "gallery"},
    {ACTION_SAVE, KEY_ANYWHERE, "Ctrl+S", MENU_FILE, "Save",
     "Save to the file, or ask for a name if it cannot be overwritten", NULL},
    {ACTION_SAVE_COPY, KEY_ANYWHERE, "Ctrl+Shift+S", MENU_FILE, "Save as ...",
     "Save with the changed numbers to another file", NULL},
    {ACTION_PICTURE, KEY_ANYWHERE, "F9", MENU_FILE, "Picture", "Write the view or the focused plot as PNG and SVG",
     NULL},
    {ACTION_FRAMES, KEY_ANYWHERE, "Shift+F9", MENU_FILE, "Frames", "Write 30 pictures per simulated second", NULL},
    {ACTION_EXPORT, KEY_ANYWHERE, "Ctrl+E", MENU_FILE, "Export ...", "Write pictures, plots, data, a film or a report",
     NULL},
    {ACTION_COPY_COMMAND, KEY_ANYWHERE, "Ctrl+C", MENU_FILE, "Copy command",
     "Copy the command line that reproduces this run, if nothing is selected", NULL},
    {ACTION_QUIT, KEY_ANYWHERE, "Ctrl+Q", MENU_FILE, "Quit", "Close the window", NULL},

    {ACTION_EDIT_PLAN, KEY_ANYWHERE, "Ctrl+J", MENU_EDIT, "Edit plan",
     "Show the tools that draw walls, doors and rooms, or put them away", NULL},
    {ACTION_UNDO, KEY_ANYWHERE, "Ctrl+Z", MENU_EDIT, "Undo", "Undo the last edit", "undo"},
    {ACTION_REDO, KEY_ANYWHERE, "Ctrl+Shift+Z", MENU_EDIT, "Redo", "Redo the last undone edit", NULL},
    {ACTION_REDO, KEY_ANYWHERE, "Ctrl+Y", MENU_NONE, NULL, NULL, NULL},
    {ACTION_HISTORY, KEY_ANYWHERE, "Ctrl+Shift+H", MENU_EDIT, "Undo history ...",
     "List the last edits, and go back to just after one of them", NULL},
    {ACTION_CUT, KEY_PLAN, "Ctrl+X", MENU_EDIT, "Cut", "Copy the selection and remove it", NULL},
    {ACTION_COPY, KEY_PLAN, "Ctrl+C", MENU_EDIT, "Copy", "Copy the selection", NULL},
    {ACTION_PASTE, KEY_PLAN, "Ctrl+V", MENU_EDIT, "Paste", "Paste at the pointer", NULL},
    {ACTION_DUPLICATE, KEY_PLAN, "Ctrl+D", MENU_EDIT, "Duplicate", "Duplicate the selection", NULL},
    {ACTION_DELETE, KEY_PLAN, "Delete", MENU_EDIT, "Delete", "Remove the selection", NULL},
    {ACTION_DELETE, KEY_PLAN, "Backspace", MENU_NONE, NULL, NULL, NULL},
    {ACTION_SELECT_ALL, KEY_PLAN, "Ctrl+A", MENU_EDIT, "Select all", "Select everything that can be moved", NULL},
    {ACTION_UNDO_ALL, KEY_ANYWHERE, "Alt+R", MENU_EDIT, "Reset scene", "Reset everything to the values in the file",
     NULL},
    {ACTION_EDIT_NUMBERS, KEY_VIEW, "Return", MENU_EDIT, "Numbers", "Edit the numbers of the selection", NULL},
    {ACTION_USE_CURSOR, KEY_PLOT, "Return", MENU_NONE, "Set corner", "Set a corner of the zoom box", NULL},
    {ACTION_NEXT_THING, KEY_VIEW, "Tab", MENU_EDIT, "Next object",
     "Select the next person, tight place, door, piece of furniture, wall or exit", "objects"},
    {ACTION_PREVIOUS_THING, KEY_VIEW, "Shift+Tab", MENU_EDIT, "Previous object", "Select the previous object", NULL},
    {ACTION_KEEP, KEY_CANVAS, "K", MENU_EDIT, "Save for comparison",
     "Save this run and show it behind the following ones", "compare"},
    {ACTION_GHOST, KEY_CANVAS, "G", MENU_EDIT, "Compare with", "Compare with the saved run or the other driving model",
     "before"},
    {ACTION_CLEAR, KEY_CANVAS, "X", MENU_EDIT, "Clear", "Clear the trace and the points so far", NULL},

    {ACTION_TOOL_SELECT, KEY_PLAN, "S", MENU_TOOLS, "Select", "Select and move objects and their handles", NULL},
    {ACTION_TOOL_WALL, KEY_PLAN, "W", MENU_TOOLS, "Wall", "Draw walls from corner to corner; type digits for a length",
     "wall"},
    {ACTION_TOOL_DOOR, KEY_PLAN, "D", MENU_TOOLS, "Door", "Place a door or an opening in a wall", "door"},
    {ACTION_TOOL_FURNITURE, KEY_PLAN, "O", MENU_TOOLS, "Furniture", "Place furniture from the catalogue or of any size",
     "furniture"},
    {ACTION_TOOL_PERSON, KEY_PLAN, "P", MENU_TOOLS, "Person", "Place a person in a wheelchair or on foot", NULL},
    {ACTION_TOOL_EXIT, KEY_PLAN, "X", MENU_TOOLS, "Exit", "Draw the line that people cross to leave the house", NULL},
    {ACTION_TOOL_MEASURE, KEY_PLAN, "M", MENU_TOOLS, "Measure", "Measure the distance between two points or faces",
     "measure"},
    {ACTION_TOOL_AREA, KEY_PLAN, "A", MENU_TOOLS, "Room", "Name a room", NULL},
    {ACTION_TOOL_ROUTE, KEY_PLAN, "Y", MENU_TOOLS, "Route", "Draw the route of a person", NULL},
    {ACTION_TOOL_IMAGE, KEY_PLAN, "B", MENU_TOOLS, "Picture to trace", "Place a picture below the plan to trace over",
     NULL},
    {ACTION_TOPPLE, KEY_PLAN, "T", MENU_TOOLS, "Topple", "Topple the selected furniture, or stand it up", "topple"},
    {ACTION_SHAKE, KEY_PLAN, "Shift+T", MENU_TOOLS, "Shake",
     "Simulate an earthquake; each further one uses the next seed", NULL},
    {ACTION_SPLIT, KEY_PLAN, "Shift+W", MENU_TOOLS, "Split wall", "Split the selected wall", NULL},
    {ACTION_SNAP, KEY_PLAN, "N", MENU_TOOLS, "Snapping", "Switch snapping to corners, faces and angles on or off",
     NULL},
    {ACTION_HANDLE, KEY_PLAN, "J", MENU_TOOLS, "Next handle",
     "Go to the next corner or end of the selection, to be moved by arrow keys", NULL},
    {ACTION_HANDLE_BACK, KEY_PLAN, "Shift+J", MENU_TOOLS, "Previous handle",
     "Go to the previous corner or end of the selection", NULL},
    {ACTION_NUDGE_LEFT, KEY_PLAN, "Left", MENU_NONE, "Nudge left",
     "Move the selection by 1 cm (Shift: 10 cm, Ctrl: 1 mm), or the view if nothing is selected", NULL},
    {ACTION_NUDGE_LEFT, KEY_PLAN, "Shift+Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_LEFT, KEY_PLAN, "Ctrl+Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_RIGHT, KEY_PLAN, "Right", MENU_NONE, "Nudge right", "Move the selection or the view to the right",
     NULL},
    {ACTION_NUDGE_RIGHT, KEY_PLAN, "Shift+Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_RIGHT, KEY_PLAN, "Ctrl+Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_UP, KEY_PLAN, "Up", MENU_NONE, "Nudge up", "Move the selection or the view up", NULL},
    {ACTION_NUDGE_UP, KEY_PLAN, "Shift+Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_UP, KEY_PLAN, "Ctrl+Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_DOWN, KEY_PLAN, "Down", MENU_NONE, "Nudge down", "Move the selection or the view down", NULL},
    {ACTION_NUDGE_DOWN, KEY_PLAN, "Shift+Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NUDGE_DOWN, KEY_PLAN, "Ctrl+Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_TURN_LITTLE_LEFT, KEY_PLAN, "Shift+Q", MENU_NONE, "Turn left a little",
     "Turn the selection by 1 degree to the left", NULL},
    {ACTION_TURN_LITTLE_RIGHT, KEY_PLAN, "Shift+E", MENU_NONE, "Turn right a little",
     "Turn the selection by 1 degree to the right", NULL},

    {ACTION_FIT, KEY_CANVAS, "Home", MENU_VIEW, "Fit", "Show everything", NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "=", MENU_VIEW, "Zoom in", "Zoom in on the middle", NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "+", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "Shift+=", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_IN, KEY_CANVAS, "Keypad +", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_OUT, KEY_CANVAS, "-", MENU_VIEW, "Zoom out", "Zoom out", NULL},
    {ACTION_ZOOM_OUT, KEY_CANVAS, "Keypad -", MENU_NONE, NULL, NULL, NULL},
    {ACTION_BOX, KEY_PLOT, "Z", MENU_NONE, "Zoom to a box",
     "Zoom to a box: move its corner by arrow keys and set it by Return, twice", NULL},
    {ACTION_BOX_BACK, KEY_PLOT, "Backspace", MENU_NONE, "View before", "Return to the previous axes", NULL},
    {ACTION_CURSOR_LEFT, KEY_PLOT, "Left", MENU_NONE, "Cursor left",
     "Move the cursor and its number (Shift: ten steps)", NULL},
    {ACTION_CURSOR_LEFT, KEY_PLOT, "Shift+Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_CURSOR_RIGHT, KEY_PLOT, "Right", MENU_NONE, "Cursor right",
     "Move the cursor and its number (Shift: ten steps)", NULL},
    {ACTION_CURSOR_RIGHT, KEY_PLOT, "Shift+Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_ZOOM_SELECTION, KEY_VIEW, "Z", MENU_VIEW, "Zoom to selection", "Zoom to the selection", NULL},
    {ACTION_PAN_LEFT, KEY_VIEW, "Left", MENU_NONE, "Look left", "Move the view", NULL},
    {ACTION_PAN_RIGHT, KEY_VIEW, "Right", MENU_NONE, "Look right", "Move the view", NULL},
    {ACTION_PAN_UP, KEY_VIEW, "Up", MENU_NONE, "Look up", "Move the view", NULL},
    {ACTION_PAN_DOWN, KEY_VIEW, "Down", MENU_NONE, "Look down", "Move the view", NULL},
    {ACTION_PAN_UP, KEY_PLOT, "Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_PAN_UP, KEY_PLOT, "Shift+Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_PAN_DOWN, KEY_PLOT, "Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_PAN_DOWN, KEY_PLOT, "Shift+Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_RAISED, KEY_CANVAS, "V", MENU_VIEW, "Plan or raised", "Switch between plan and raised view", "raised"},
    {ACTION_TURN_LEFT, KEY_VIEW, "Q", MENU_VIEW, "Turn left",
     "Turn the selection or the raised view by 15 degrees to the left", NULL},
    {ACTION_TURN_RIGHT, KEY_VIEW, "E", MENU_VIEW, "Turn right",
     "Turn the selection or the raised view by 15 degrees to the right", NULL},
    {ACTION_DRIVERS, KEY_CANVAS, "Shift+D", MENU_VIEW, "Many drivers",
     "Show or hide 100 drivers: the band of their paths, and where they touch something", NULL},
    {ACTION_FOLLOW, KEY_VIEW, "F", MENU_VIEW, "Follow", "Keep the selected person in the middle of the view", NULL},
    {ACTION_LAYER, KEY_CANVAS, "1", MENU_NONE, "Layers", "Show or hide a layer; the panel lists their numbers", NULL},
    {ACTION_LAYER, KEY_CANVAS, "2", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "3", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "4", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "5", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "6", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "7", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "8", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LAYER, KEY_CANVAS, "9", MENU_NONE, NULL, NULL, NULL},
    {ACTION_PANEL, KEY_CANVAS, "H", MENU_VIEW, "Panel", "Show or hide the panel", NULL},
    {ACTION_PLOTS, KEY_CANVAS, "Shift+P", MENU_VIEW, "Plots", "Show or hide the plots", "plots"},
    {ACTION_PRESENT, KEY_ANYWHERE, "F5", MENU_VIEW, "Present", "Presentation mode: view and result only, larger text",
     NULL},
    {ACTION_FULLSCREEN, KEY_ANYWHERE, "F11", MENU_VIEW, "Full screen", "Fill the screen, or return to a window", NULL},
    {ACTION_THEME, KEY_ANYWHERE, "Ctrl+T", MENU_VIEW, "Light or dark", "Switch between light and dark colours", NULL},
    {ACTION_LARGER, KEY_ANYWHERE, "Ctrl+=", MENU_VIEW, "Increase text size", "Increase the text size (up to 300 %)",
     NULL},
    {ACTION_LARGER, KEY_ANYWHERE, "Ctrl++", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LARGER, KEY_ANYWHERE, "Ctrl+Shift+=", MENU_NONE, NULL, NULL, NULL},
    {ACTION_SMALLER, KEY_ANYWHERE, "Ctrl+-", MENU_VIEW, "Decrease text size", "Decrease the text size (down to 75 %)",
     NULL},
    {ACTION_NORMAL_SIZE, KEY_ANYWHERE, "Ctrl+0", MENU_VIEW, "Reset text size", "Reset the text size to 100 %", NULL},

    {ACTION_PLAY, KEY_CANVAS, "Space", MENU_RUN, "Play or pause", "Start or pause playback", "play, pause"},
    {ACTION_PLAY, KEY_TIMELINE, "Space", MENU_NONE, NULL, NULL, NULL},
    {ACTION_PLAY, KEY_ANYWHERE, "Alt+K", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP, KEY_CANVAS, ".", MENU_RUN, "Step", "Go one frame forward and pause (Shift: ten frames)", "step"},
    {ACTION_STEP, KEY_TIMELINE, "Right", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP_BACK, KEY_CANVAS, ",", MENU_RUN, "Step back", "Go one frame back and pause (Shift: ten frames)", NULL},
    {ACTION_STEP_BACK, KEY_TIMELINE, "Left", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP_TEN, KEY_CANVAS, "Shift+.", MENU_NONE, "Ten steps", "Go ten frames forward and pause", NULL},
    {ACTION_STEP_TEN, KEY_CANVAS, "Shift+>", MENU_NONE, NULL, NULL, NULL},
    {ACTION_STEP_BACK_TEN, KEY_CANVAS, "Shift+,", MENU_NONE, "Ten steps back", "Go ten frames back and pause", NULL},
    {ACTION_STEP_BACK_TEN, KEY_CANVAS, "Shift+<", MENU_NONE, NULL, NULL, NULL},
    {ACTION_SECOND, KEY_TIMELINE, "Shift+Right", MENU_NONE, "One second forward",
     "Go one second of playback at speed 1 forward", NULL},
    {ACTION_SECOND_BACK, KEY_TIMELINE, "Shift+Left", MENU_NONE, "One second back",
     "Go one second of playback at speed 1 back", NULL},
    {ACTION_SLOWER, KEY_CANVAS, "[", MENU_RUN, "Slower", "Halve the speed", "speed"},
    {ACTION_SLOWER, KEY_TIMELINE, "Down", MENU_NONE, NULL, NULL, NULL},
    {ACTION_FASTER, KEY_CANVAS, "]", MENU_RUN, "Faster", "Double the speed", NULL},
    {ACTION_FASTER, KEY_TIMELINE, "Up", MENU_NONE, NULL, NULL, NULL},
    {ACTION_NORMAL_SPEED, KEY_CANVAS, "\\", MENU_RUN, "Speed 1", "Reset the speed to 1", NULL},
    {ACTION_AGAIN, KEY_CANVAS, "R", MENU_RUN, "Run again", "Restart from the beginning with the same numbers", "again"},
    {ACTION_START, KEY_TIMELINE, "Home", MENU_RUN, "Start", "Go to the beginning of the record", NULL},
    {ACTION_NOW, KEY_TIMELINE, "End", MENU_RUN, "Now", "Go to the end of the record and continue", NULL},
    {ACTION_NOW, KEY_CANVAS, "End", MENU_NONE, NULL, NULL, NULL},
    {ACTION_LOOP, KEY_CANVAS, "L", MENU_RUN, "Loop", "Repeat the marked stretch or the whole record", NULL},
    {ACTION_LOOP, KEY_TIMELINE, "L", MENU_NONE, NULL, NULL, NULL},
    {ACTION_MARK_IN, KEY_TIMELINE, "I", MENU_RUN, "Mark in", "Begin the loop here", NULL},
    {ACTION_MARK_OUT, KEY_TIMELINE, "O", MENU_RUN, "Mark out", "End the loop here", NULL},
    {ACTION_SWEEP, KEY_CANVAS, "U", MENU_RUN, "Sweep",
     "Choose how all rhythms (orbit diagram) are swept: from rest, upwards or downwards", NULL},
    {ACTION_FOLLOW_ORBIT, KEY_CANVAS, "Shift+U", MENU_RUN, "Follow this orbit",
     "Follow the running motion through all rhythms (orbit diagram), stable or not, or remove it", NULL},
    {ACTION_SOUND, KEY_ANYWHERE, "Ctrl+M", MENU_RUN, "Sound", "Switch the sound of the beam's tip on or off", NULL},

    {ACTION_LESSONS, KEY_ANYWHERE, "Ctrl+L", MENU_LEARN, "Lessons ...", "Choose a lesson for a class or for yourself",
     "lessons"},
    {ACTION_LESSON_NEXT, KEY_ANYWHERE, "PageDown", MENU_LEARN, "Next step",
     "Go on in the lesson, as a presenter's remote does; first shows a model answer", NULL},
    {ACTION_LESSON_BACK, KEY_ANYWHERE, "PageUp", MENU_LEARN, "Step back",
     "Go back in the lesson; the house or machine is again as that step was left", NULL},
    {ACTION_LESSON_HINT, KEY_VIEW, "?", MENU_LEARN, "Hint", "Show the next of a step's three hints", NULL},
    {ACTION_LESSON_VOTE, KEY_VIEW, "0", MENU_LEARN, "Vote again",
     "Let the class vote once more; keys 1 to 9 count the raised hands, Backspace takes one back", NULL},
    {ACTION_LESSON_RESTART, KEY_ANYWHERE, "Ctrl+R", MENU_LEARN, "Start this step again",
     "Put the house or machine back as the step began, and play its run once more; guesses and hints stay", NULL},
    {ACTION_LESSON_FREE, KEY_ANYWHERE, "Ctrl+U", MENU_LEARN, "Unlock the plan or numbers",
     "Let the class change the things and numbers that the lesson locks", NULL},
    {ACTION_LESSON_FOLD, KEY_CANVAS, "C", MENU_LEARN, "Fold the card",
     "Fold the card to one line, or unfold it; guesses and hints stay", NULL},
    {ACTION_LESSON_LEAVE, KEY_ANYWHERE, "Ctrl+F4", MENU_LEARN, "Leave the lesson",
     "End the lesson; what is open stays open", NULL},

    {ACTION_HELP, KEY_ANYWHERE, "F1", MENU_HELP, "Keys", "Show this card", "all keys"},
    {ACTION_EXPLAIN, KEY_ANYWHERE, "Shift+F1", MENU_HELP, "Explain", "Explain the focused control", NULL},
    {ACTION_MESSAGES, KEY_ANYWHERE, "F7", MENU_HELP, "Messages", "Show all messages and errors", NULL},
    {ACTION_TRY, KEY_ANYWHERE, "Ctrl+F1", MENU_HELP, "Try this", "Show three first things to try", NULL},
    {ACTION_ABOUT, KEY_ANYWHERE, "Ctrl+I", MENU_HELP, "About", "Show version and sources of the program", NULL},
    {ACTION_MENU, KEY_ANYWHERE, "F10", MENU_NONE, "Menu", "Open the menus", NULL},
    {ACTION_ESCAPE, KEY_ANYWHERE, "Escape", MENU_NONE, "Back", "Close a dialog or clear the selection; it never quits",
     NULL},
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

bool keys_begins_group(Action action) {
    static const Action first[] = {ACTION_SAVE,         ACTION_PICTURE,    ACTION_QUIT,   ACTION_UNDO,  ACTION_CUT,
                                   ACTION_EDIT_NUMBERS, ACTION_KEEP,       ACTION_TOPPLE, ACTION_SNAP,  ACTION_RAISED,
                                   ACTION_PANEL,        ACTION_THEME,      ACTION_SLOWER, ACTION_AGAIN, ACTION_SWEEP,
                                   ACTION_TRY,          ACTION_FULLSCREEN, ACTION_LOOP,   ACTION_ABOUT};
    for (size_t i = 0; i < sizeof first / sizeof *first; i++)
        if (first[i] == action)
            return true;
    return false;
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

Action keys_find_tool(int32_t key, int mods) {
    Action tool = keys_find(key, mods, KEY_PLAN, true);
    return tool >= ACTION_TOOL_SELECT && tool <= ACTION_TOOL_IMAGE ? tool : ACTION_NONE;
}

const char *keys_help(Arena *arena, Action action) {
    KeyRow row = keys_row(action);
    return text_in_arena(arena, "%s (%s): %s", row.name, row.key, row.help);
}
