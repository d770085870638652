#include "window/dialogs.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "window/act.h"
#include "window/dialog_export.h"
#include "window/dialog_gallery.h"
#include "window/dialog_leave.h"
#include "window/dialog_pane.h"
#include "window/menu.h"

/* Design points. */
#define EDGE 24.0
#define SMALL_WIDTH 620.0
#define SMALL_HEIGHT 230.0

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
        [DIALOG_MENU] = menu_show,
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
