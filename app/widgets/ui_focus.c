#include "widgets/ui_focus.h"

#include <math.h>
#include <string.h>

#include "base/digest.h"
#include "widgets/ui_editor.h"
#include "widgets/ui_pane.h"
#include "widgets/ui_stop.h"
#include "widgets/ui_tip.h"

/* Stops ------------------------------------------------------------------------------------------------------------ */

#define CARD_ROWS 100.0 /* weight of the distance up or down: the next row of cards comes first */

enum { NUMBER_FRAMES = 4 /* in which a pane may make the number that is to have the focus, but the first */ };

static bool reaches(const Ui *ui, const UiStop *stop) {
    return !ui->modal || stop->pane == ui->modal;
}

static void give(Ui *ui, const UiStop *stop) {
    ui_state_stir(ui);
    ui->focus = stop->id;
    ui->focus_pane = stop->pane;
    ui->reveal = true;
    ui->tip_hidden = 0;
    if (stop->kind == UI_IS_FIELD)
        ui_editor_open(ui, stop->id, stop->text);
}

static void give_by_key(Ui *ui, const UiStop *stop) {
    give(ui, stop);
    ui->by_key = true;
}

/* Returns the stop from which Tab continues: that of the field opened by the mouse, if any. */
static size_t current_index(const Ui *ui, UiId from) {
    for (size_t i = 0; i < ui->old_stop_count; i++)
        if (ui->old_stops[i].id == from)
            return i;
    return ui->old_stop_count;
}

/* Without a focus, starts at the first stop, or the last one. */
static size_t begin_of_way(const Ui *ui, size_t index, bool back) {
    return index < ui->old_stop_count ? index : back ? 0 : ui->old_stop_count - 1;
}

static void go_round(Ui *ui, UiId from, bool back) {
    size_t count = ui->old_stop_count, index = begin_of_way(ui, current_index(ui, from), back);
    for (size_t step = 1; step <= count; step++) {
        const UiStop *stop = &ui->old_stops[(index + (back ? count - step : step)) % count];
        if (reaches(ui, stop)) {
            give_by_key(ui, stop);
            return;
        }
    }
}

/* Moves the focus to the first stop of the next pane that has one. */
static void go_to_pane(Ui *ui, UiId from, bool back) {
    size_t count = ui->old_stop_count, index = current_index(ui, from);
    UiId pane = index < count ? ui->old_stops[index].pane : 0, found = 0;
    index = begin_of_way(ui, index, back);
    for (size_t step = 1; step <= count && !found; step++) {
        const UiStop *stop = &ui->old_stops[(index + (back ? count - step : step)) % count];
        if (reaches(ui, stop) && stop->pane != pane)
            found = stop->pane;
    }
    for (size_t i = 0; i < count; i++)
        if (found && ui->old_stops[i].pane == found) {
            give_by_key(ui, &ui->old_stops[i]);
            return;
        }
}

static const UiStop *first_of(const Ui *ui, const UiStop *stops, size_t count, UiId pane) {
    for (size_t i = 0; i < count; i++)
        if (pane ? stops[i].pane == pane : reaches(ui, &stops[i]))
            return &stops[i];
    return NULL;
}

void ui_focus(Ui *ui, const char *pane) {
    UiId id = digest_text(DIGEST_START, pane);
    const UiStop *stop = first_of(ui, ui->old_stops, ui->old_stop_count, id);
    if (ui->editor.id)
        ui_editor_close(ui, UI_END_LEFT);
    ui->by_key = false;
    ui->focus = 0; /* a new pane gets the focus at the end of the frame */
    ui->focus_pane = id;
    if (stop)
        give(ui, stop);
}

void ui_focus_number(Ui *ui, const char *pane) {
    ui_focus(ui, pane);
    ui->wants_number = digest_text(DIGEST_START, pane);
    ui->wants_frames = NUMBER_FRAMES;
}

/* Gives the focus to the first number or text of the pane that should have it. */
static void find_number(Ui *ui) {
    if (!ui->wants_number)
        return;
    bool made = ui->wants_frames < NUMBER_FRAMES; /* the caller may have changed the contents of the pane */
    for (size_t i = 0; made && i < ui->old_stop_count && ui->wants_number; i++)
        if (ui->old_stops[i].pane == ui->wants_number &&
            (ui->old_stops[i].kind == UI_IS_SLIDER || ui->old_stops[i].kind == UI_IS_FIELD)) {
            give(ui, &ui->old_stops[i]);
            ui->wants_number = 0;
        }
    if (ui->wants_number && --ui->wants_frames <= 0)
        ui->wants_number = 0;
    ui_state_stir(ui);
}

static UiId id_in(const char *pane, const char *id) {
    return digest_text(digest_text(DIGEST_START, pane), id);
}

bool ui_focus_on(Ui *ui, const char *pane, const char *id) {
    const UiStop *stop = ui_stop_find(ui, id_in(pane, id));
    if (stop)
        give_by_key(ui, stop);
    return stop;
}

bool ui_focus_is_on(const Ui *ui, const char *pane, const char *id) {
    return ui->focus && ui->focus == id_in(pane, id);
}

const char *ui_focus_pane(const Ui *ui) {
    const UiPlace *place = ui_pane_find(ui, ui->focus_pane);
    return place ? place->name : "";
}

bool ui_focus_is_pane(const Ui *ui) {
    return ui->focus && ui->focus == ui->focus_pane;
}

const char *ui_focus_help(const Ui *ui) {
    return ui->focus && ui->focus_tip.id == ui->focus ? ui->focus_tip.text : NULL;
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

void ui_focus_frame_begin(Ui *ui) {
    ui->focus_made = false;
}

static void swap_stops(Ui *ui) {
    UiStop *stops = ui->old_stops;
    size_t capacity = ui->old_stop_capacity;
    Arena texts = ui->old_stop_texts;
    ui->old_stops = ui->stops;
    ui->old_stop_count = ui->stop_count;
    ui->old_stop_capacity = ui->stop_capacity;
    ui->old_stop_texts = ui->stop_texts;
    arena_clear(&texts);
    ui->stop_texts = texts;
    ui->stops = stops;
    ui->stop_count = 0;
    ui->stop_capacity = capacity;
}

/* Gives the focus to a modal pane, and returns it afterwards. */
static void handle_modal(Ui *ui) {
    if (ui->modal && ui->focus_pane != ui->modal) {
        if (ui->editor.id)
            ui_editor_close(ui, UI_END_LEFT);
        ui->hover_tip.id = 0;
        if (!ui->keeps) {
            ui->kept = ui->focus;
            ui->kept_pane = ui->focus_pane;
        }
        ui->keeps = true;
        ui->focus = 0;
        ui->focus_pane = ui->modal;
    } else if (!ui->modal && ui->keeps) {
        ui_state_stir(ui);
        ui->focus = ui->kept;
        ui->focus_pane = ui->kept_pane;
        ui->keeps = false;
    }
}

/* Returns the first pane that is a stop itself, where no key presses a button; NULL: none. */
static const UiStop *first_pane(const Ui *ui) {
    for (size_t i = 0; i < ui->old_stop_count; i++)
        if (ui->old_stops[i].id == ui->old_stops[i].pane)
            return &ui->old_stops[i];
    return NULL;
}

/* Moves the focus from a removed stop to the first one of its pane; from a removed pane to the first pane that is a
 * stop, since the first stop of all opens a menu. */
static void handle_gone_stop(Ui *ui) {
    if (!ui->focus_pane || ui_stop_find(ui, ui->focus))
        return;
    const UiStop *stop = first_of(ui, ui->old_stops, ui->old_stop_count, ui->focus_pane);
    if (!stop && !ui->modal)
        stop = first_pane(ui);
    if (!stop && !ui->modal)
        stop = first_of(ui, ui->old_stops, ui->old_stop_count, 0);
    ui->focus = 0;
    if (stop)
        give(ui, stop);
}

void ui_focus_frame_end(Ui *ui) {
    swap_stops(ui);
    if (ui->focus_made)
        ui->reveal = false;
    ui->press_count = ui->typed_count = 0;
    arena_clear(&ui->typed_texts);
    if (ui->editor.id && !ui_stop_find(ui, ui->editor.id))
        ui->editor.id = 0;
    handle_modal(ui);
    handle_gone_stop(ui);
    find_number(ui);
}

/* Keys ------------------------------------------------------------------------------------------------------------- */

/* Sets of keys, one bit each. */
#define KEY(name_) (1u << UI_KEY_##name_)
#define USE (KEY(ENTER) | KEY(SPACE))
#define UPWARDS (KEY(UP) | KEY(DOWN) | KEY(HOME) | KEY(END))
#define PAGES (KEY(PAGE_UP) | KEY(PAGE_DOWN))
#define SIDEWAYS (KEY(LEFT) | KEY(RIGHT))

static bool uses(UiKind kind, UiKey key) {
    static const unsigned keys[] = {
        [UI_IS_PANE] = 0,
        [UI_IS_BUTTON] = USE,
        [UI_IS_ROW] = USE | UPWARDS,
        [UI_IS_CARD] = USE | UPWARDS | SIDEWAYS,
        [UI_IS_CHOICE] = USE | UPWARDS | SIDEWAYS,
        [UI_IS_SLIDER] = KEY(ENTER) | UPWARDS | SIDEWAYS | PAGES | KEY(DELETE),
        [UI_IS_FIELD] = KEY(ENTER),
    };
    return keys[kind] & 1u << key;
}

/* True for what arrows go along. */
static bool is_listed(const UiStop *stop) {
    return stop->kind == UI_IS_ROW || stop->kind == UI_IS_CARD;
}

/* Moves the focus from a card to the nearest card or row above or below. */
static void go_between_cards(Ui *ui, const UiStop *stop, UiKey key) {
    const UiStop *end = ui->old_stops + ui->old_stop_count, *next = stop;
    double way = key == UI_KEY_UP ? -1 : 1, least = HUGE_VAL;
    for (const UiStop *s = ui->old_stops; s < end; s++) {
        if (s->pane != stop->pane || !is_listed(s) || way * (s->box.low.y - stop->box.low.y) <= 0)
            continue;
        double far = CARD_ROWS * fabs(s->box.low.y - stop->box.low.y) +
                     fabs(s->box.low.x + s->box.high.x - stop->box.low.x - stop->box.high.x) / 2;
        if (far < least) {
            least = far;
            next = s;
        }
    }
    give_by_key(ui, next);
}

/* Moves the focus from row to row of a list. */
static void go_along_rows(Ui *ui, const UiStop *stop, UiKey key) {
    const UiStop *end = ui->old_stops + ui->old_stop_count, *next = stop;
    int way = key == UI_KEY_UP || key == UI_KEY_HOME || key == UI_KEY_LEFT ? -1 : 1;
    bool all = key == UI_KEY_HOME || key == UI_KEY_END;
    for (const UiStop *s = stop + way; s >= ui->old_stops && s < end && s->pane == stop->pane; s += way)
        if (is_listed(s)) {
            next = s;
            if (!all)
                break;
        }
    give_by_key(ui, next);
}

/* Scrolls the pane of a stop by a key that the stop itself does not use; false: it does not scroll. */
static bool scroll(Ui *ui, const UiStop *stop, UiKey key, bool shift) {
    const UiPlace *place = stop ? ui_pane_find(ui, stop->pane) : NULL;
    if (!place || !ui_pane_overflows(place))
        return false;
    ui_stop_press(ui, place->id, key, shift);
    return true;
}

static bool use_key(Ui *ui, const UiStop *stop, UiKey key, bool shift) {
    if (!uses(stop->kind, key))
        return ((UPWARDS | PAGES) & 1u << key) && scroll(ui, stop, key, shift);
    bool on_card = stop->kind == UI_IS_CARD;
    if (on_card && (key == UI_KEY_UP || key == UI_KEY_DOWN))
        go_between_cards(ui, stop, key);
    else if (is_listed(stop) && ((UPWARDS | (on_card ? SIDEWAYS : 0)) & 1u << key))
        go_along_rows(ui, stop, key);
    else if (stop->text && key == UI_KEY_ENTER)
        ui_editor_open(ui, stop->id, stop->text);
    else
        ui_stop_press(ui, stop->id, key, shift);
    return true;
}

/* Closes a field by Escape. In a dialog, one that was changed opens again with what it held, and one that was not is
 * left to the dialog, which closes. */
static bool escape_field(Ui *ui) {
    UiId id = ui->editor.id;
    const UiStop *stop = ui_stop_find(ui, id);
    bool changed = strcmp(ui->editor.text, ui->editor.original) != 0;
    bool in_dialog = ui->modal && stop && stop->kind == UI_IS_FIELD && ui->focus == id;
    ui_editor_close(ui, UI_END_ESCAPED);
    if (in_dialog && changed)
        ui_editor_open(ui, id, ui->typed[ui->typed_count - 1].text);
    return !in_dialog || changed;
}

static bool escape(Ui *ui) {
    if (ui->editor.id)
        return escape_field(ui);
    if (ui_editor_draft(ui, ui->focus)) {
        ui_editor_drop_draft(ui, ui->focus);
        return true;
    }
    return !ui->modal && ui_tip_hide(ui);
}

static void go(Ui *ui, UiKey key) {
    UiId from = ui->editor.id ? ui->editor.id : ui->focus;
    if (ui->editor.id)
        ui_editor_close(ui, UI_END_LEFT);
    if (!ui->old_stop_count)
        return;
    if (key == UI_KEY_NEXT || key == UI_KEY_PREVIOUS)
        go_round(ui, from, key == UI_KEY_PREVIOUS);
    else
        go_to_pane(ui, from, key == UI_KEY_PANE_BACK);
}

/* Closes a field by Enter; a field that has the focus opens again. */
static void enter(Ui *ui) {
    UiId id = ui->editor.id;
    const UiStop *stop = ui_stop_find(ui, id);
    ui_editor_close(ui, UI_END_ENTERED);
    if (stop && stop->kind == UI_IS_FIELD && ui->focus == id)
        ui_editor_open(ui, id, ui->typed[ui->typed_count - 1].text);
}

bool ui_key(Ui *ui, UiKey key, bool shift, bool control) {
    ui_state_stir(ui);
    if (key <= UI_KEY_PANE_BACK) {
        go(ui, key);
        return true;
    }
    if (key == UI_KEY_ESCAPE)
        return escape(ui);
    if (ui->editor.id) {
        if (key == UI_KEY_ENTER)
            enter(ui);
        else if ((KEY(UP) | KEY(DOWN) | PAGES) & 1u << key)
            scroll(ui, ui_stop_find(ui, ui->editor.id), key, shift);
        else
            ui_editor_key(ui, key, shift, control);
        return true;
    }
    const UiStop *stop = ui_stop_find(ui, ui->focus);
    return stop && !control && use_key(ui, stop, key, shift);
}
