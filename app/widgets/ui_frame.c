#include "widgets/ui_editor.h"
#include "widgets/ui_focus.h"
#include "widgets/ui_pane.h"
#include "widgets/ui_tip.h"

#define TWICE_SECONDS 0.4
#define TWICE_REACH 5.0 /* design points */

Ui *ui_create(PaintGlScreen *screen, Theme theme, UiClipboard clipboard) {
    Ui *ui = memory_zeroed(1, sizeof *ui);
    ui->painter = ui_painter_create(screen);
    ui->theme = theme;
    ui->clipboard = clipboard;
    ui->mouse = vec2(-1, -1);
    return ui;
}

void ui_destroy(Ui *ui) {
    ui_painter_destroy(ui->painter);
    for (size_t i = 0; i < ui->place_count; i++) {
        memory_free(ui->places[i]->name);
        memory_free(ui->places[i]);
    }
    memory_free(ui->places);
    memory_free(ui->items);
    memory_free(ui->old_items);
    memory_free(ui->stops);
    memory_free(ui->old_stops);
    memory_free(ui->presses);
    memory_free(ui->typed);
    while (ui->draft_count)
        ui_editor_drop_draft(ui, ui->drafts[0].id);
    memory_free(ui->drafts);
    ui_editor_clear(ui);
    arena_clear(&ui->stop_texts);
    arena_clear(&ui->old_stop_texts);
    arena_clear(&ui->typed_texts);
    memory_free(ui);
}

void ui_set_theme(Ui *ui, Theme theme) {
    ui->theme = theme;
}

/* The mouse -------------------------------------------------------------------------------------------------------- */

/* Finds the topmost item under the mouse: the last one made in the previous frame. */
static void find_hovered(Ui *ui) {
    ui->hovered = 0;
    ui->on_canvas = false;
    ui->hovered_pane = NULL;
    for (size_t i = 0; i < ui->place_count; i++) {
        UiPlace *place = ui->places[i];
        if (place->made && (!ui->modal || place->id == ui->modal) && box_holds(place->box, ui->mouse) &&
            (!ui->hovered_pane || place->order > ui->hovered_pane->order))
            ui->hovered_pane = place;
    }
    for (size_t i = 0; i < ui->old_item_count; i++) {
        const UiItem *item = &ui->old_items[i];
        bool reached = ui->hovered_pane ? item->pane == ui->hovered_pane->id : item->pane == 0 && !ui->modal;
        if (reached && box_holds(item->box, ui->mouse)) {
            ui->hovered = item->id;
            ui->on_canvas = item->canvas;
        }
    }
}

static void press_left(Ui *ui) {
    bool near = vec2_distance(ui->mouse, ui->pressed_at) < TWICE_REACH;
    ui->twice = ui->input.twice || (near && ui->clock - ui->pressed_time < TWICE_SECONDS);
    ui->pressed_at = ui->mouse;
    ui->pressed_time = ui->twice ? -1 : ui->clock; /* a third press is not a second double click */
    ui->held = ui->hovered;
    if (ui->editor.id && ui->editor.id != ui->hovered)
        ui_editor_close(ui, UI_END_LEFT);
}

static void update_mouse(Ui *ui) {
    Vec2 before = ui->mouse;
    ui->mouse = vec2_scale(ui->input.mouse, 1 / ui->input.unit);
    ui->moved = vec2_sub(ui->mouse, before);
    ui->clock += ui->input.seconds;
    ui->twice = false;
    for (int i = 0; i < 3; i++) {
        ui->pressed[i] = ui->input.down[i] && !ui->was_down[i];
        ui->released[i] = !ui->input.down[i] && ui->was_down[i];
        if (ui->was_down[i] != ui->input.down[i])
            ui_state_stir(ui);
        ui->was_down[i] = ui->input.down[i];
    }
    if (ui->moved.x != 0 || ui->moved.y != 0 || ui->input.wheel != 0)
        ui_state_stir(ui);
    find_hovered(ui);
    if (ui->pressed[0] || ui->pressed[1])
        ui->by_key = false;
    if (ui->pressed[0])
        press_left(ui);
}

bool ui_is_busy(const Ui *ui) {
    return ui->stirred > 0 || ui_painter_is_stale(ui->painter) || ui_tip_comes(ui);
}

static const UiItem *find_item(const Ui *ui, UiId id) {
    for (size_t i = 0; id && i < ui->old_item_count; i++)
        if (ui->old_items[i].id == id)
            return &ui->old_items[i];
    return NULL;
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

void ui_begin(Ui *ui, const UiInput *input) {
    ui->input = *input;
    ui->window = (Box){{0, 0}, {input->width / input->unit, input->height / input->unit}};
    ui_painter_begin(ui->painter, input->width, input->height, input->unit, input->seconds);
    update_mouse(ui);
    ui_pane_frame_begin(ui);
    ui_focus_frame_begin(ui);
    ui_tip_frame_begin(ui);
}

static void swap_items(Ui *ui) {
    UiItem *items = ui->old_items;
    size_t capacity = ui->old_item_capacity;
    ui->old_items = ui->items;
    ui->old_item_count = ui->item_count;
    ui->old_item_capacity = ui->item_capacity;
    ui->items = items;
    ui->item_count = 0;
    ui->item_capacity = capacity;
}

void ui_end(Ui *ui) {
    ui->stirred -= ui->stirred > 0;
    swap_items(ui);
    if (!ui->input.down[0] || !find_item(ui, ui->held))
        ui->held = 0;
    ui_focus_frame_end(ui);
    ui_pane_frame_end(ui);
    ui_tip_draw(ui);
    ui_painter_end(ui->painter);
}
