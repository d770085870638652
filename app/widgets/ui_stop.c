#include "widgets/ui_stop.h"

static const UiSlider *store_number(Ui *ui, const UiSlider *number) {
    if (!number)
        return NULL;
    UiSlider *kept = arena_allocate(&ui->stop_texts, sizeof *kept);
    *kept = *number;
    kept->unit = arena_text(&ui->stop_texts, number->unit ? number->unit : "");
    kept->id = kept->label = kept->help = NULL;
    return kept;
}

bool ui_stop_make_typed(Ui *ui, UiId id, UiKind kind, Box box, const char *text, const UiSlider *number) {
    ui->stops = memory_reserve(ui->stops, &ui->stop_capacity, ui->stop_count + 1, sizeof *ui->stops);
    ui->stops[ui->stop_count++] = (UiStop){id,
                                           ui->place ? ui->place->id : 0,
                                           kind,
                                           box,
                                           text ? arena_text(&ui->stop_texts, text) : NULL,
                                           store_number(ui, number)};
    if (ui->focus != id)
        return false;
    ui->focus_box = box;
    ui->focus_made = true;
    return true;
}

bool ui_stop_make(Ui *ui, UiId id, UiKind kind, Box box) {
    return ui_stop_make_typed(ui, id, kind, box, NULL, NULL);
}

static const UiStop *find(const UiStop *stops, size_t count, UiId id) {
    for (size_t i = 0; id && i < count; i++)
        if (stops[i].id == id)
            return &stops[i];
    return NULL;
}

const UiStop *ui_stop_find(const Ui *ui, UiId id) {
    return find(ui->old_stops, ui->old_stop_count, id);
}

/* Draws two frames, one in the ink's colour and one in the paper's: one of them differs from any ground. */
void ui_stop_draw(Ui *ui) {
    double reach = UI_FRAME + UI_RIM;
    Box box = ui->focus == ui->place->id ? ui->place->box : box_expand(ui->focus_box, reach), pane = ui->place->box;
    box.low = vec2(fmax(box.low.x, pane.low.x), fmax(box.low.y, pane.low.y));
    box.high = vec2(fmin(box.high.x, pane.high.x), fmin(box.high.y, pane.high.y));
    Colour ground = palette_colour(ui->theme, ROLE_PAPER);
    bool dark = palette_ink_on(ground).red > 0.5;
    UiInk black = 0xFF000000, white = 0xFFFFFFFF;
    ui_painter_frame(ui->painter, box, UI_FRAME, dark ? white : black);
    ui_painter_frame(ui->painter, box_expand(box, -UI_FRAME), UI_RIM, dark ? black : white);
}

void ui_stop_press(Ui *ui, UiId id, UiKey key, bool shift) {
    ui->presses = memory_reserve(ui->presses, &ui->press_capacity, ui->press_count + 1, sizeof *ui->presses);
    ui->presses[ui->press_count++] = (UiPress){id, key, shift};
}

bool ui_stop_next_key(Ui *ui, UiId id, UiPress *taken) {
    for (size_t i = 0; i < ui->press_count; i++)
        if (ui->presses[i].id == id) {
            *taken = ui->presses[i];
            ui->presses[i].id = 0;
            return true;
        }
    return false;
}

bool ui_stop_used(Ui *ui, UiId id) {
    bool used = false;
    for (UiPress taken; ui_stop_next_key(ui, id, &taken);)
        used = true;
    return used;
}
