#include "window/dialogs.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

#include "base/text.h"
#include "window/act.h"
#include "window/dialog_export.h"
#include "window/dialog_gallery.h"
#include "window/dialog_leave.h"
#include "window/dialog_pane.h"
#include "window/dialog_unit.h"
#include "window/menu.h"

/* Design points. */
#define EDGE 24.0
#define SMALL_WIDTH 620.0
#define SMALL_HEIGHT 230.0
#define NARROW_CARD 900.0 /* width of a page below which the card of keys has one column */

enum { KEY_COLUMNS = 3, STRIP_KEYS = 12 };

/* The card of keys ------------------------------------------------------------------------------------------------- */

/* What keys are for: the columns of the card. */
typedef enum Task { TASK_WATCH, TASK_PLOTS, TASK_EDIT, TASK_FILES, TASK_PRESENT, TASK_HELP, TASKS } Task;

static const char *const task_names[TASKS] = {
    [TASK_WATCH] = "Watch", [TASK_PLOTS] = "Plots and beam",       [TASK_EDIT] = "Edit",
    [TASK_FILES] = "Files", [TASK_PRESENT] = "Screen and present", [TASK_HELP] = "Help"};

/* The tasks of each column, from above. */
static const Task columns[KEY_COLUMNS][KEY_COLUMNS] = {
    {TASK_WATCH, TASK_PLOTS, TASKS}, {TASK_EDIT, TASKS, TASKS}, {TASK_FILES, TASK_PRESENT, TASK_HELP}};

static Task task_of(const KeyRow *row) {
    if (row->place == KEY_PLOT || row->action == ACTION_SWEEP || row->action == ACTION_FOLLOW_ORBIT ||
        row->action == ACTION_CLEAR)
        return TASK_PLOTS;
    if (row->action >= ACTION_PANEL && row->action <= ACTION_NORMAL_SIZE && row->action != ACTION_EDIT_PLAN)
        return TASK_PRESENT;
    if (row->action < ACTION_TOOL_SELECT)
        return TASK_FILES;
    if (row->place == KEY_PLAN || row->menu == MENU_EDIT)
        return TASK_EDIT;
    return row->menu == MENU_HELP || row->action == ACTION_MENU || row->action == ACTION_ESCAPE ||
                   row->action >= ACTION_LABORATORY
               ? TASK_HELP
               : TASK_WATCH;
}

/* Returns the keys of an action in one place: "Space, Alt+K"; of nudging only the first. */
static const char *all_keys(Window *window, size_t index) {
    KeyRow row = keys_at(index);
    const char *text = row.key;
    bool nudges = row.action >= ACTION_NUDGE_LEFT && row.action <= ACTION_NUDGE_DOWN;
    for (size_t i = index + 1; i < keys_count() && !keys_at(i).name && row.action != ACTION_LAYER && !nudges; i++)
        if (keys_at(i).place == row.place && !strstr(keys_at(i).key, "Keypad") && !strstr(keys_at(i).key, "Shift+="))
            text = text_in_arena(&window->arena, "%s, %s", text, keys_at(i).key);
    if (row.action == ACTION_COPY_COMMAND) /* which shares its key with the selection's */
        return text_in_arena(&window->arena, "%s, nothing selected", text);
    return row.action == ACTION_LAYER ? "1 ... 9" : text;
}

/* True if a text contains what is typed, in capitals or small letters. */
static bool matches(const Window *window, const char *text) {
    return strcasestr(text, window->field) != NULL;
}

/* A line of a column: a heading, or the row of a key. */
typedef struct KeyLine {
    const char *heading;
    size_t key;
} KeyLine;

/* Writes the lines of a column that match what is typed; returns how many. */
static size_t column_lines(Window *window, const Task *tasks, KeyLine *lines) {
    size_t count = 0;
    for (int t = 0; t < KEY_COLUMNS && tasks[t] != TASKS; t++) {
        bool headed = false;
        for (size_t i = 0; i < keys_count(); i++) {
            KeyRow row = keys_at(i);
            if (!row.name || task_of(&row) != tasks[t] ||
                !(matches(window, row.name) || matches(window, row.help) || matches(window, all_keys(window, i))))
                continue;
            if (!headed)
                lines[count++] = (KeyLine){task_names[tasks[t]], 0};
            headed = true;
            lines[count++] = (KeyLine){NULL, i};
        }
    }
    return count;
}

/* Writes the keys that the strip names while the present pane has the focus; returns how many. */
static size_t strip_lines(Window *window, KeyLine *lines) {
    size_t count = 0;
    for (size_t i = 0; i < keys_count() && count < STRIP_KEYS; i++) {
        KeyRow row = keys_at(i);
        bool there = row.place != KEY_PLAN || tab_editor(window_tab(window));
        if (row.strip && row.name && there)
            lines[count++] = (KeyLine){NULL, i};
    }
    return count;
}

static void show_key_line(Window *window, const KeyLine *line, const char *kind) {
    if (line->heading) {
        ui_line(window->ui, UI_HEADING, ROLE_TEXT, line->heading);
        return;
    }
    KeyRow row = keys_at(line->key);
    ui_list_row(window->ui,
                &(UiRow){.id = text_in_arena(&window->arena, "%s %zu", kind, line->key),
                         .shape = ROW_PLAIN,
                         .cells = {row.name, text_in_arena(&window->arena, "%s    ", all_keys(window, line->key))},
                         .help = text_in_arena(&window->arena, "%s: %s", row.name, row.help)});
}

static void show_keys(Window *window) {
    enum { LINES_MOST = 256 };
    KeyLine lines[KEY_COLUMNS][LINES_MOST], strip[STRIP_KEYS];
    size_t counts[KEY_COLUMNS], most = 0;
    assert(keys_count() + TASKS < LINES_MOST);
    dialog_pane_begin(window, dialog_pane_centred(window, 1180, 680, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Keys");
    ui_field(window->ui, "find", NULL, "Find: Type a part of a name or of a key", window->field, sizeof window->field);
    int shown = window->frame.page.x < NARROW_CARD ? 1 : KEY_COLUMNS;
    size_t first = *window->field ? 0 : strip_lines(window, strip);
    if (first)
        ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT,
                "Type above to find a key. Tab goes to the next control, F6 to the next pane. Most used here:");
    for (size_t i = 0; i < first; i++) {
        if (i % (size_t)shown == 0)
            ui_row(window->ui, shown);
        show_key_line(window, &strip[i], "here");
    }
    for (int c = 0; c < KEY_COLUMNS; c++) {
        counts[c] = column_lines(window, columns[c], lines[c]);
        most = counts[c] > most ? counts[c] : most;
    }
    for (int c = 0; c < KEY_COLUMNS && shown == 1; c++)
        for (size_t i = 0; i < counts[c]; i++) {
            ui_row(window->ui, 1);
            show_key_line(window, &lines[c][i], "key");
        }
    for (size_t i = 0; i < most && shown > 1; i++) {
        ui_row(window->ui, KEY_COLUMNS);
        for (int c = 0; c < KEY_COLUMNS; c++)
            if (i < counts[c])
                show_key_line(window, &lines[c][i], "key");
            else
                ui_line(window->ui, UI_BODY, ROLE_TEXT, "");
    }
    ui_row(window->ui, 1);
    if (!most)
        ui_text(window->ui, UI_BODY, ROLE_TEXT, "No key has this in its name.");
    if (!*window->field)
        ui_text(
            window->ui, UI_BODY, ROLE_DIM_TEXT,
            "On a number, arrows change it by 1/20 of its range (Shift: 1/100), PageUp and PageDown by 1/10, Home "
            "and End go to its limits, Return types a value, Delete restores the file's value. With a tool, Return "
            "begins or completes a gesture, digits type its numbers, Tab goes to the next number, Backspace removes "
            "the last step, Escape cancels; Ctrl switches snapping off while held, Shift keeps to one axis or adds "
            "to the selection.");
    ui_pane_end(window->ui);
}

/* The history of edits --------------------------------------------------------------------------------------------- */

static void show_history(Window *window) {
    Editor *editor = tab_editor(window_tab(window));
    EditStep steps[EDITOR_STEPS_MOST];
    size_t count = editor ? editor_steps(editor, steps) : 0;
    dialog_pane_begin(window, dialog_pane_centred(window, SMALL_WIDTH, 600, EDGE));
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Undo history");
    ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT, "Choose an edit to go to just after it. Grey ones are undone.");
    size_t first = count ? steps[0].number - 1 : 0, chosen = SIZE_MAX, now = first;
    for (size_t i = 0; i < count; i++)
        now = steps[i].done ? steps[i].number : now;
    UiRow begin = {.id = "step begin",
                   .shape = ROW_PLAIN,
                   .cells = {first ? text_in_arena(&window->arena, "%zu earlier edits", first) : "as opened"},
                   .selected = now == first,
                   .usable = true};
    if (ui_list_row(window->ui, &begin))
        chosen = first;
    for (size_t i = 0; i < count; i++) {
        char when[16] = "";
        struct tm local;
        if (steps[i].at && localtime_r(&steps[i].at, &local))
            strftime(when, sizeof when, "%H:%M:%S", &local);
        UiRow row = {
            .id = text_in_arena(&window->arena, "step %zu", steps[i].number),
            .shape = ROW_PLAIN,
            .cells = {text_in_arena(&window->arena, "%s", steps[i].name), text_in_arena(&window->arena, "%s", when)},
            .selected = steps[i].number == now,
            .dim = !steps[i].done,
            .usable = true};
        if (ui_list_row(window->ui, &row))
            chosen = steps[i].number;
    }
    ui_pane_end(window->ui);
    if (chosen == SIZE_MAX)
        return;
    editor_go_to_step(editor, chosen);
    dialog_pane_close(window);
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
        [DIALOG_HISTORY] = show_history,
        [DIALOG_LEAVE] = dialog_leave_show,
        [DIALOG_LESSON] = dialog_leave_show_lesson,
        [DIALOG_KEPT] = dialog_leave_show_kept,
        [DIALOG_RECOVERED] = dialog_leave_show_recovered,
        [DIALOG_UNIT] = dialog_unit_show,
    };
    if (window->dialog != DIALOG_NONE)
        shows[window->dialog](window);
}
