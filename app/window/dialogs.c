#include "window/dialogs.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "window/act.h"
#include "window/dialog_export.h"
#include "window/dialog_gallery.h"
#include "window/dialog_leave.h"
#include "window/dialog_pane.h"
#include "window/files.h"
#include "window/plan_input.h"

/* Design points. */
#define MENU_WIDTH 376.0
#define MENU_ROW 30.0
#define EDGE 24.0
#define SMALL_WIDTH 620.0
#define SMALL_HEIGHT 230.0

/* The menus -------------------------------------------------------------------------------------------------------- */

static double menu_left(Window *window) {
    double left = 2;
    for (KeyMenu menu = MENU_FILE; menu < window->menu && !window->frame.compact; menu++)
        if (menu != MENU_TOOLS || tab_editor(window_tab(window)))
            left += ui_extent(window->ui, UI_BODY, keys_menus[menu]).x + 20;
    return left;
}

/* True if the row belongs to the menu; rows for plans only where a plan can be edited. */
static bool is_there(Window *window, const KeyRow *row, KeyMenu menu) {
    return row->menu == menu && row->name && (row->place != KEY_PLAN || tab_editor(window_tab(window)));
}

/* True if the row's key has this meaning while the view has the focus. */
static bool is_meant(Window *window, const KeyRow *row) {
    int32_t key;
    int mods;
    keys_read(row->key, &key, &mods);
    if (row->place != KEY_CANVAS)
        return true;
    return keys_find(key, mods, tab_editor(window_tab(window)) ? KEY_PLAN : KEY_VIEW, true) == row->action;
}

/* Shows a row of a menu; true if it was chosen, which closes the menu. */
static bool show_menu_row(Window *window, const KeyRow *row) {
    Tab *tab = window_tab(window);
    Editor *editor = tab_editor(tab);
    bool undoes = row->action == ACTION_UNDO, steps = undoes || row->action == ACTION_REDO;
    bool can = !steps || (editor && (undoes ? editor_undo_name(editor) : editor_redo_name(editor)));
    UiRow shown = {.id = row->name,
                   .shape = ROW_PLAIN,
                   .cells = {steps ? plan_input_step_label(window, row->action) : row->name,
                             is_meant(window, row) ? row->key : NULL},
                   .usable = can};
    if (!ui_list_row(window->ui, &shown))
        return false;
    dialog_pane_close(window);
    act_do(window, row->action, 0, 0);
    return true;
}

static bool show_recent(Window *window) {
    const char *paths[SETTINGS_RECENT_MOST];
    size_t count = settings_recent(&window->settings, paths);
    if (window->menu != MENU_FILE || !count)
        return false;
    ui_heading(window->ui, "Recent");
    for (size_t i = 0; i < count; i++) {
        const char *name = strrchr(paths[i], '/');
        UiRow shown = {.id = paths[i],
                       .shape = ROW_PLAIN,
                       .cells = {name ? name + 1 : paths[i]},
                       .help = paths[i],
                       .usable = true};
        if (ui_list_row(window->ui, &shown)) {
            dialog_pane_close(window);
            files_leave(window, LEAVE_OPEN, paths[i]);
            return true;
        }
    }
    return false;
}

static void show_menu(Window *window) {
    size_t rows = 0;
    const char *paths[SETTINGS_RECENT_MOST];
    for (size_t i = 0; i < keys_count(); i++) {
        KeyRow row = keys_at(i);
        rows += is_there(window, &row, window->menu);
    }
    rows += window->menu == MENU_FILE ? settings_recent(&window->settings, paths) + 2 : 0;
    double left = menu_left(window), top = window->frame.menu.high.y;
    double height = fmin((double)(rows + 1) * MENU_ROW + 34, window->frame.page.y - top);
    Box box = {{left, top}, {fmin(left + MENU_WIDTH, window->frame.page.x), top + height}};
    dialog_pane_begin(window, box);
    bool edits = tab_editor(window_tab(window));
    ui_row(window->ui, MENUS - MENU_FILE - !edits);
    for (KeyMenu menu = MENU_FILE; menu < MENUS; menu++)
        if ((menu != MENU_TOOLS || edits) &&
            ui_button(window->ui,
                      &(UiButton){.label = keys_menus[menu], .plain = true, .chosen = menu == window->menu}))
            window->menu = menu;
    bool done = false;
    for (size_t i = 0; i < keys_count() && !done; i++) {
        KeyRow row = keys_at(i);
        done = is_there(window, &row, window->menu) && show_menu_row(window, &row);
    }
    if (!done)
        show_recent(window);
    ui_pane_end(window->ui);
}

/* The card of keys ------------------------------------------------------------------------------------------------- */

static const char *place_name(KeyPlace place) {
    static const char *const names[] = {[KEY_ANYWHERE] = "Anywhere", [KEY_CANVAS] = "View and plots",
                                        [KEY_VIEW] = "View",         [KEY_PLAN] = "Plan of a house",
                                        [KEY_PLOT] = "Plots",        [KEY_TIMELINE] = "Timeline"};
    return names[place];
}

/* Returns all keys of an action in one place: "Space, Alt+K". */
static const char *all_keys(Window *window, size_t index) {
    KeyRow row = keys_at(index);
    const char *text = row.key;
    for (size_t i = index + 1; i < keys_count() && !keys_at(i).name && row.action != ACTION_LAYER; i++)
        if (keys_at(i).place == row.place)
            text = text_in_arena(&window->arena, "%s, %s", text, keys_at(i).key);
    return row.action == ACTION_LAYER ? "1 ... 9" : text;
}

static void show_keys(Window *window) {
    dialog_pane_begin(window, dialog_pane_centred(window, 1180, 680, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Keys");
    ui_text(
        window->ui, UI_BODY, ROLE_DIM_TEXT,
        "Tab and Shift+Tab go to the next and previous control, F6 and Shift+F6 to the next and previous pane; Return "
        "or "
        "Space presses a button. On a number, arrows change it by 1/20 of its range (Shift: 1/100), PageUp and "
        "PageDown "
        "by 1/10, Home and End go to its limits, Return types a value, Delete restores the file's value. With a tool, "
        "Return begins or completes a gesture, digits type its numbers, Tab goes to the next number, Backspace removes "
        "the last step, Escape cancels; Ctrl switches snapping off while held, Shift keeps to one axis or adds to the "
        "selection.");
    for (KeyPlace place = KEY_ANYWHERE; place <= KEY_TIMELINE; place++) {
        ui_heading(window->ui, place_name(place));
        for (size_t i = 0; i < keys_count(); i++) {
            KeyRow row = keys_at(i), named = row.name ? row : keys_row(row.action);
            bool first = row.name || row.place != keys_at(i - 1).place;
            if (row.place != place || !first)
                continue;
            const char *text = text_in_arena(&window->arena, "%s: %s", named.name, named.help);
            ui_list_row(window->ui, &(UiRow){.id = text_in_arena(&window->arena, "key %zu", i),
                                             .shape = ROW_PLAIN,
                                             .cells = {text, row.name ? all_keys(window, i) : row.key}});
        }
    }
    ui_pane_end(window->ui);
}

/* The log ---------------------------------------------------------------------------------------------------------- */

static void show_messages(Window *window) {
    dialog_pane_begin(window, dialog_pane_centred(window, 1000, 560, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Messages");
    if (!messages_count(&window->messages))
        ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT, "There are no messages yet.");
    for (size_t i = messages_count(&window->messages); i-- > 0;) {
        const Message *message = messages_at(&window->messages, i);
        bool timed = !isnan(message->time);
        const char *when = timed ? text_in_arena(&window->arena, "%.3f s", message->time) : NULL;
        const char *text =
            text_in_arena(&window->arena, "%s%s", message->kind == MESSAGE_FAULT ? "\u26a0 " : "", message->text);
        if (!timed) {
            ui_text(window->ui, UI_BODY, message->kind == MESSAGE_FAULT ? ROLE_ERROR : ROLE_TEXT, text);
            continue;
        }
        UiRow row = {.id = text_in_arena(&window->arena, "message %zu", message->number),
                     .shape = ROW_PLAIN,
                     .cells = {text, when},
                     .usable = true};
        if (ui_list_row(window->ui, &row) && window_tab(window)->session) {
            tab_seek(window_tab(window), message->time);
            dialog_pane_close(window);
        }
    }
    ui_pane_end(window->ui);
}

/* Small dialogs ---------------------------------------------------------------------------------------------------- */

static bool show_close(Window *window) {
    ui_gap(window->ui, 8);
    if (!ui_button(window->ui, &(UiButton){.label = "Close", .help = "Close (Escape): Close this dialog"}))
        return false;
    dialog_pane_close(window);
    return true;
}

static void show_explanation(Window *window) {
    dialog_pane_begin(window, dialog_pane_centred(window, SMALL_WIDTH, SMALL_HEIGHT, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Focused control");
    ui_text(window->ui, UI_BODY, ROLE_TEXT, window->hold);
    show_close(window);
    ui_pane_end(window->ui);
}

static void show_about(Window *window) {
    dialog_pane_begin(window, dialog_pane_centred(window, 760, 420, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "clearance " CLEARANCE_VERSION);
    ui_text(window->ui, UI_BODY, ROLE_TEXT,
            "Can a wheelchair user leave the house, how long does it take, and where is it dangerous? Does a beam that "
            "rattles "
            "in its clearance move periodically or chaotically?");
    ui_text(
        window->ui, UI_BODY, ROLE_TEXT,
        "House: Miura, Takimoto and Kubodera's simulation of evacuation by wheelchair with distinct elements. Beam: Gu "
        "and Dubowsky's impact beam system. Each number says whether it is reconstructed, identified or assumed.");
    ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT,
            "Screen readers cannot read this window. The same results are available as text: clearance run FILE "
            "--json, and --report "
            "for a page with tables.");
    show_close(window);
    ui_pane_end(window->ui);
}

void dialogs_show(Window *window) {
    static void (*const shows[DIALOGS])(Window *) = {
        [DIALOG_MENU] = show_menu,
        [DIALOG_KEYS] = show_keys,
        [DIALOG_GALLERY] = dialog_gallery_show,
        [DIALOG_OPEN] = dialog_gallery_show_open,
        [DIALOG_SAVE] = dialog_export_show_save,
        [DIALOG_EXPORT] = dialog_export_show,
        [DIALOG_MESSAGES] = show_messages,
        [DIALOG_EXPLAIN] = show_explanation,
        [DIALOG_ABOUT] = show_about,
        [DIALOG_LEAVE] = dialog_leave_show,
        [DIALOG_RECOVERED] = dialog_leave_show_recovered,
    };
    if (window->dialog != DIALOG_NONE)
        shows[window->dialog](window);
}
