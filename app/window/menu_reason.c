#include "window/menu_reason.h"

#include <string.h>

#include "window/lesson.h"

static bool is_selected(const Tab *tab) {
    return tab->laboratory->selected(tab->session).kind != 0;
}

/* Returns the chosen word's place among the choices with a name; false: the laboratory has no such choice. */
static bool has_choice(const Tab *tab, const char *name) {
    size_t count;
    const PanelChoice *choices = tab->laboratory->choices(tab->session, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(choices[i].name, name) == 0)
            return choices[i].count > 1;
    return false;
}

/* True for actions on the numbers and runs of an open file. */
static bool needs_file(Action action) {
    return action != ACTION_NEW && action != ACTION_OPEN && action != ACTION_GALLERY && action != ACTION_QUIT &&
           action < ACTION_PANEL;
}

/* Returns why an edit of the plan cannot be done. */
static const char *why_no_edit(const Tab *tab, Editor *editor, Action action) {
    switch (action) {
    case ACTION_UNDO:
        return editor_undo_name(editor) ? NULL : "Nothing has been edited";
    case ACTION_REDO:
        return editor_redo_name(editor) ? NULL : "Nothing has been undone";
    case ACTION_HISTORY:
        return editor_undo_name(editor) || editor_redo_name(editor) ? NULL : "Nothing has been edited";
    case ACTION_CUT:
    case ACTION_DUPLICATE:
    case ACTION_DELETE:
        return is_selected(tab) ? NULL : "Nothing is selected: click a thing, or press Tab";
    case ACTION_TOPPLE:
        return editor_can_topple(editor) ? NULL : "Select a piece of furniture that falls to a side first";
    case ACTION_SPLIT:
        return is_selected(tab) ? NULL : "Select a wall first";
    default:
        return NULL;
    }
}

/* True for actions that show another time, or go there by themselves. */
static bool moves_time(Action action) {
    return (action >= ACTION_PLAY && action <= ACTION_SECOND_BACK) || action == ACTION_AGAIN || action == ACTION_NOW;
}

const char *menu_reason_to_guess(Window *window, Action action) {
    if (lesson_hides(window) && moves_time(action))
        return "The class guesses first: nothing moves until you go on with PgDn";
    bool edits = action > ACTION_TOOL_SELECT && action <= ACTION_UNDO_ALL && action != ACTION_COPY;
    bool nudges =
        action >= ACTION_NUDGE_LEFT && action <= ACTION_NUDGE_DOWN; /* which pan the view without a selection */
    if (!lesson_hides(window) || !edits || (nudges && !is_selected(window_tab(window))))
        return NULL;
    return "The class guesses first: nothing changes until you go on with PgDn";
}

const char *menu_reason_of(Window *window, Action action) {
    const Tab *tab = window_tab(window);
    const char *guess = menu_reason_to_guess(window, action);
    if (action >= ACTION_LESSON_NEXT && action <= ACTION_LESSON_LEAVE)
        return lesson_reason(window, action);
    if (guess)
        return guess;
    if (!tab->session)
        return needs_file(action) ? "No file is open" : NULL;
    Editor *editor = tab_editor(tab);
    bool edits = action >= ACTION_TOOL_SELECT && action <= ACTION_TURN_LITTLE_RIGHT && action != ACTION_COPY;
    if ((edits || action == ACTION_EDIT_PLAN) && !editor)
        return "Only the plan of a house can be edited";
    if (moves_time(action) && !tab_can_play(tab))
        return "There is nothing to play yet";
    switch (action) {
    case ACTION_ZOOM_SELECTION:
    case ACTION_EDIT_NUMBERS:
        return is_selected(tab) ? NULL : "Nothing is selected: click a thing, or press Tab";
    case ACTION_FOLLOW:
        return tab->follows || is_selected(tab) ? NULL : "Select a person first";
    case ACTION_DRIVERS:
        return tab_layer(tab, "drivers") < tab->laboratory->layer_count ? NULL : "Only a house has drivers";
    case ACTION_RAISED:
        return tab->laboratory->raised ? NULL : "This machine has one view";
    case ACTION_TURN_LEFT:
    case ACTION_TURN_RIGHT:
        return is_selected(tab) || tab->camera.kind == VIEW_RAISED ? NULL : "Select a thing first, or show it raised";
    case ACTION_SWEEP:
        return has_choice(tab, "Sweep") ? NULL : "Only a beam or a crank has rhythms (an orbit diagram) to sweep";
    case ACTION_FOLLOW_ORBIT:
        return tab->laboratory->follow ? NULL : "Only the orbit of a beam can be followed";
    case ACTION_GHOST:
        return has_choice(tab, "Compare with") ? NULL : "There is nothing to compare with";
    case ACTION_SOUND:
        return editor ? "Only a beam can be heard" : NULL;
    default:
        return editor ? why_no_edit(tab, editor, action) : NULL;
    }
}
