/* The table of actions with their keys, menus and texts. The dispatcher, the card of keys, the menus, the tooltips and
 * the strip all read this one table, so that they cannot differ. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/text.h"

typedef enum Action {
    ACTION_NONE,
    ACTION_NEW,
    ACTION_OPEN,
    ACTION_SAVE,
    ACTION_SAVE_COPY,
    ACTION_GALLERY,
    ACTION_PICTURE,
    ACTION_FRAMES,
    ACTION_EXPORT,
    ACTION_COPY_COMMAND,
    ACTION_QUIT,
    ACTION_TOOL_SELECT, /* the tools in the order of EditTool */
    ACTION_TOOL_WALL,
    ACTION_TOOL_DOOR,
    ACTION_TOOL_FURNITURE,
    ACTION_TOOL_PERSON,
    ACTION_TOOL_EXIT,
    ACTION_TOOL_MEASURE,
    ACTION_TOOL_AREA,
    ACTION_TOOL_ROUTE,
    ACTION_TOOL_IMAGE,
    ACTION_UNDO,
    ACTION_REDO,
    ACTION_HISTORY,
    ACTION_CUT,
    ACTION_COPY,
    ACTION_PASTE,
    ACTION_DUPLICATE,
    ACTION_DELETE,
    ACTION_SELECT_ALL,
    ACTION_SPLIT,
    ACTION_TOPPLE,
    ACTION_SHAKE,
    ACTION_SNAP,
    ACTION_HANDLE,
    ACTION_HANDLE_BACK,
    ACTION_NUDGE_LEFT,
    ACTION_NUDGE_RIGHT,
    ACTION_NUDGE_UP,
    ACTION_NUDGE_DOWN,
    ACTION_TURN_LITTLE_LEFT,
    ACTION_TURN_LITTLE_RIGHT,
    ACTION_UNDO_ALL,
    ACTION_KEEP,
    ACTION_GHOST,
    ACTION_CLEAR,
    ACTION_SWEEP,
    ACTION_FOLLOW_ORBIT,
    ACTION_FIT,
    ACTION_ZOOM_IN,
    ACTION_ZOOM_OUT,
    ACTION_ZOOM_SELECTION,
    ACTION_RAISED,
    ACTION_DRIVERS,
    ACTION_FOLLOW,
    ACTION_TURN_LEFT,
    ACTION_TURN_RIGHT,
    ACTION_PAN_LEFT,
    ACTION_PAN_RIGHT,
    ACTION_PAN_UP,
    ACTION_PAN_DOWN,
    ACTION_PANEL,
    ACTION_EDIT_PLAN,
    ACTION_PLOTS,
    ACTION_PRESENT,
    ACTION_FULLSCREEN,
    ACTION_THEME,
    ACTION_LARGER,
    ACTION_SMALLER,
    ACTION_NORMAL_SIZE,
    ACTION_LAYER, /* 1 to 9: the key selects the layer */
    ACTION_PLAY,
    ACTION_STEP,
    ACTION_STEP_BACK,
    ACTION_STEP_TEN,
    ACTION_STEP_BACK_TEN,
    ACTION_SECOND,
    ACTION_SECOND_BACK,
    ACTION_SLOWER,
    ACTION_FASTER,
    ACTION_NORMAL_SPEED,
    ACTION_AGAIN,
    ACTION_START,
    ACTION_NOW,
    ACTION_LOOP,
    ACTION_MARK_IN,
    ACTION_MARK_OUT,
    ACTION_SOUND,
    ACTION_NEXT_THING,
    ACTION_PREVIOUS_THING,
    ACTION_EDIT_NUMBERS,
    ACTION_CURSOR_LEFT,
    ACTION_CURSOR_RIGHT,
    ACTION_USE_CURSOR,
    ACTION_BOX,
    ACTION_BOX_BACK,
    ACTION_MENU,
    ACTION_MESSAGES,
    ACTION_HELP,
    ACTION_EXPLAIN,
    ACTION_ABOUT,
    ACTION_TRY,
    ACTION_LESSONS,
    ACTION_LESSON_NEXT,
    ACTION_LESSON_BACK,
    ACTION_LESSON_HINT,
    ACTION_LESSON_VOTE,
    ACTION_LESSON_RESTART,
    ACTION_LESSON_FREE,
    ACTION_LESSON_FOLD,
    ACTION_LESSON_LEAVE,
    ACTION_ESCAPE,
    ACTION_LABORATORY, /* the first of `laboratories`; the others follow */
    ACTIONS,
} Action;

/* The places where a key has a meaning. */
typedef enum KeyPlace {
    KEY_ANYWHERE,
    KEY_CANVAS,   /* the plan, the beam or a plot has the focus */
    KEY_VIEW,     /* the plan or the beam */
    KEY_PLOT,     /* a plot */
    KEY_PLAN,     /* the view, if its contents can be edited */
    KEY_TIMELINE, /* the timeline, too */
} KeyPlace;

typedef enum KeyMenu {
    MENU_NONE,
    MENU_FILE,
    MENU_EDIT,
    MENU_TOOLS,
    MENU_VIEW,
    MENU_RUN,
    MENU_LEARN,
    MENU_HELP,
    MENUS
} KeyMenu;

typedef struct KeyRow {
    Action action;
    KeyPlace place;
    const char *key;   /* "Ctrl+O", "Space", "[" */
    KeyMenu menu;      /* the menu that lists it */
    const char *name;  /* "Open"; NULL: another key of the row above */
    const char *help;  /* a sentence */
    const char *strip; /* a word for the strip, or NULL */
} KeyRow;

/* Return the number of rows and each of them, those of the laboratories last. */
size_t keys_count(void);
KeyRow keys_at(size_t i);

extern const char *const keys_menus[MENUS];

/* True if a line divides the action from those above it in its menu. */
bool keys_begins_group(Action action);

/* Returns the row of an action that has its name; the name is NULL if there is none. */
KeyRow keys_row(Action action);

/* Returns the meaning of a key while a place of this kind has the focus, the most specific one if there are several;
 * ACTION_NONE: it has none. Single letters count only if `single_keys`; `mods` as in sdl_window.h. */
Action keys_find(int32_t key, int mods, KeyPlace place, bool single_keys);

/* Returns the tool that a key takes up in the view; ACTION_NONE: none. */
Action keys_find_tool(int32_t key, int mods);

/* Parses a key's name into its code and mods. */
void keys_read(const char *text, int32_t *key, int *mods);

/* Returns the tooltip of an action: "Open (Ctrl+O): ..." */
const char *keys_help(Arena *arena, Action action);
