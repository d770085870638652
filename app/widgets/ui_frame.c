#include <string.h>

#include "base/digest.h"
#include "widgets/ui_inside.h"

#define TWICE_SECONDS 0.4
#define TWICE_REACH 5.0 /* design points */

Ui *ui_create(PaintGlScreen *screen, Theme theme, UiClipboard clipboard) {
    Ui *ui = memory_zeroed(1, sizeof *ui);
    ui->pencil = ui_pencil_create(screen);
    ui->theme = theme;
    ui->clipboard = clipboard;
    ui->mouse = vec2(-1, -1);
    return ui;
}

void ui_destroy(Ui *ui) {
    ui_pencil_destroy(ui->pencil);
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
        ui_slider_drop_draft(ui, ui->drafts[0].id);
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

/* Colours ---------------------------------------------------------------------------------------------------------- */

static UiInk ink_of(Colour colour, double opacity) {
    return (UiInk)lrint(255 * colour.red) | (UiInk)lrint(255 * colour.green) << 8 |
           (UiInk)lrint(255 * colour.blue) << 16 | (UiInk)lrint(255 * opacity) << 24;
}

UiInk ui_frame_ink(const Ui *ui, Role role, double opacity) {
    return ink_of(palette_colour(ui->theme, role), opacity);
}

UiInk ui_frame_ink_on(const Ui *ui, Role role) {
    return ink_of(palette_ink(ui->theme, role), 1);
}

/* The mouse -------------------------------------------------------------------------------------------------------- */

/* What is uppermost where the mouse is: of what was made in the frame before, the last. */
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
    ui->pressed_time = ui->twice ? -1 : ui->clock; /* a third press is no second double click */
    ui->held = ui->hovered;
    if (ui->editor.id && ui->editor.id != ui->hovered)
        ui_editor_close(ui, UI_END_LEFT);
}

static void take_mouse(Ui *ui) {
    Vec2 before = ui->mouse;
    ui->mouse = vec2_scale(ui->input.mouse, 1 / ui->input.unit);
    ui->moved = vec2_sub(ui->mouse, before);
    ui->clock += ui->input.seconds;
    ui->twice = false;
    for (int i = 0; i < 3; i++) {
        ui->pressed[i] = ui->input.down[i] && !ui->was_down[i];
        ui->released[i] = !ui->input.down[i] && ui->was_down[i];
        if (ui->was_down[i] != ui->input.down[i])
            ui_frame_stir(ui);
        ui->was_down[i] = ui->input.down[i];
    }
    if (ui->moved.x != 0 || ui->moved.y != 0 || ui->input.wheel != 0)
        ui_frame_stir(ui);
    find_hovered(ui);
    if (ui->pressed[0] || ui->pressed[1])
        ui->by_key = false;
    if (ui->pressed[0])
        press_left(ui);
}

void ui_frame_stir(Ui *ui) {
    ui->stirred = 2;
}

bool ui_is_busy(const Ui *ui) {
    return ui->stirred > 0 || ui_pencil_is_stale(ui->pencil) || ui_tip_comes(ui);
}

UiId ui_frame_id(const Ui *ui, const char *id) {
    return digest_text(ui->place ? ui->place->id : DIGEST_START, id);
}

static Box common(Box a, Box b) {
    return (Box){{fmax(a.low.x, b.low.x), fmax(a.low.y, b.low.y)},
                 {fmin(a.high.x, b.high.x), fmin(a.high.y, b.high.y)}};
}

UiTouch ui_frame_touch(Ui *ui, UiId id, Box box, bool canvas) {
    ui->items = memory_reserve(ui->items, &ui->item_capacity, ui->item_count + 1, sizeof *ui->items);
    ui->items[ui->item_count++] =
        (UiItem){id, ui->place ? ui->place->id : 0, ui->place ? common(box, ui->place->box) : box, canvas};
    UiTouch touch = {.hovered = ui->hovered == id && (!ui->held || ui->held == id), .held = ui->held == id};
    touch.pressed = touch.held && ui->pressed[0];
    touch.twice = touch.pressed && ui->twice;
    touch.released = touch.held && ui->released[0];
    touch.clicked = touch.released && touch.hovered;
    touch.held = touch.held && !touch.released;
    return touch;
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
    ui_pencil_begin(ui->pencil, input->width, input->height, input->unit, input->seconds);
    take_mouse(ui);
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
    ui_pencil_end(ui->pencil);
}

Vec2 ui_extent(Ui *ui, UiLetters letters, const char *words) {
    return ui_pencil_extent(ui->pencil, letters, words, strlen(words));
}

/* Pieces ----------------------------------------------------------------------------------------------------------- */

void ui_image(Ui *ui, const ScreenTexture *texture, Box box) {
    if (texture->name)
        ui_pencil_image(ui->pencil, texture, box);
}

void ui_draw_picture(Ui *ui, const ScreenTexture *texture, const Vec2 corners[4], double opacity) {
    if (texture->name)
        ui_pencil_picture(ui->pencil, texture, corners, opacity);
}

void ui_draw_box(Ui *ui, Box box, Role role, double opacity) {
    ui_pencil_box(ui->pencil, box, ui_frame_ink(ui, role, opacity));
}

void ui_draw_frame(Ui *ui, Box box, Role role, double width) {
    ui_pencil_frame(ui->pencil, box, width, ui_frame_ink(ui, role, 1));
}

void ui_draw_line(Ui *ui, Vec2 from, Vec2 to, Role role, double width) {
    ui_pencil_polyline(ui->pencil, (Vec2[]){from, to}, 2, false, width, ui_frame_ink(ui, role, 1));
}

void ui_draw_polyline(Ui *ui, const Vec2 *points, size_t count, bool closed, Role role, double width) {
    if (count)
        ui_pencil_polyline(ui->pencil, points, count, closed, width, ui_frame_ink(ui, role, 1));
}

void ui_draw_disc(Ui *ui, Vec2 middle, double radius, Role role) {
    ui_pencil_disc(ui->pencil, middle, radius, ui_frame_ink(ui, role, 1));
}

void ui_draw_diamond(Ui *ui, Vec2 middle, double radius, Role role) {
    Vec2 corners[] = {{middle.x - radius, middle.y},
                      {middle.x, middle.y - radius},
                      {middle.x + radius, middle.y},
                      {middle.x, middle.y + radius}};
    ui_pencil_convex(ui->pencil, corners, 4, ui_frame_ink(ui, role, 1));
}

void ui_draw_words(Ui *ui, UiLetters letters, Role role, Vec2 at, double aligned, const char *words) {
    at.x -= aligned * ui_extent(ui, letters, words).x;
    ui_pencil_words(ui->pencil, letters, ui_frame_ink(ui, role, 1), at, words, strlen(words));
}

UiGrab ui_grab(Ui *ui, const char *id, Box box) {
    UiTouch touch = ui_frame_touch(ui, ui_frame_id(ui, id), box, true);
    UiGrab grab = {.hovered = touch.hovered,
                   .pressed = touch.pressed,
                   .held = touch.held,
                   .released = touch.released,
                   .right_pressed = touch.hovered && ui->pressed[1],
                   .twice = touch.twice,
                   .at = ui->mouse,
                   .delta = ui->moved,
                   .wheel = touch.hovered ? ui->input.wheel : 0};
    return grab;
}
