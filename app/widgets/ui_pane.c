#include "widgets/ui_pane.h"

#include <string.h>

#include "base/digest.h"
#include "base/text.h"
#include "widgets/ui_stop.h"

#define NARROW 160.0 /* a pane of at most this width has only a small margin */
#define MARGIN 16.0
#define NARROW_MARGIN 6.0
#define TOP_MARGIN 8.0
#define BAR_WIDTH 8.0
#define BAR_LEAST 24.0
#define NOTCH 60.0
#define DIM 0.45

/* Places ----------------------------------------------------------------------------------------------------------- */

UiPlace *ui_pane_find(const Ui *ui, UiId id) {
    for (size_t i = 0; i < ui->place_count; i++)
        if (ui->places[i]->id == id)
            return ui->places[i];
    return NULL;
}

static UiPlace *make_place(Ui *ui, UiId id, const char *name) {
    UiPlace *place = memory_zeroed(1, sizeof *place);
    place->id = id;
    place->name = text_copy(name);
    ui->places = memory_reserve(ui->places, &ui->place_capacity, ui->place_count + 1, sizeof *ui->places);
    ui->places[ui->place_count++] = place;
    return place;
}

void ui_pane_frame_begin(Ui *ui) {
    for (size_t i = 0; i < ui->place_count; i++)
        ui->places[i]->made = false;
    ui->order = 0;
    ui->modal = 0;
    ui->place = NULL;
    ui->at_given = false;
    ui->row_count = ui->row_index = 0;
    ui->inner = ui->window;
}

/* Forgets the scroll position of a pane that was not made: it starts at its top the next time. */
void ui_pane_frame_end(Ui *ui) {
    for (size_t i = 0; i < ui->place_count; i++)
        if (!ui->places[i]->made)
            ui->places[i]->scroll = 0;
}

/* Scrolling -------------------------------------------------------------------------------------------------------- */

static double hidden(const UiPlace *place) {
    return fmax(0, place->content - box_height(place->box));
}

bool ui_pane_overflows(const UiPlace *place) {
    return place->scrolls && hidden(place) > 0.5;
}

static void scroll_by_wheel(Ui *ui, UiPlace *place) {
    if (ui->hovered_pane == place && !ui->on_canvas)
        place->scroll -= NOTCH * ui->input.wheel;
}

/* Draws the scroll bar, which can be dragged. */
static void draw_bar(Ui *ui, UiPlace *place) {
    Box box = place->box;
    double height = box_height(box), length = fmax(BAR_LEAST, height * height / place->content);
    double part = hidden(place) > 0 ? place->scroll / hidden(place) : 0;
    Box track = {{box.high.x - BAR_WIDTH - 2, box.low.y}, box.high};
    UiTouch touch = ui_state_touch(ui, ui_state_id(ui, "scroll bar"), track, false);
    if (touch.held)
        place->scroll += ui->moved.y * hidden(place) / fmax(1, height - length);
    double top = box.low.y + part * (height - length);
    Box block = {{box.high.x - BAR_WIDTH, top}, {box.high.x - 2, top + length}};
    ui_painter_box(ui->painter, block, ui_state_ink(ui, ROLE_ROOM, touch.hovered || touch.held ? 1 : 0.75));
}

static void bring_into_view(Ui *ui, UiPlace *place) {
    double margin = UI_FRAME + UI_RIM + 2;
    double above = place->box.low.y + margin - ui->focus_box.low.y;
    double below = ui->focus_box.high.y + margin - place->box.high.y;
    if (above > 0)
        place->scroll -= above;
    else if (below > 0)
        place->scroll += fmin(below, -above);
}

/* Panes ------------------------------------------------------------------------------------------------------------ */

static void begin_flow(Ui *ui, UiPlace *place) {
    double margin = box_width(place->box) <= NARROW ? NARROW_MARGIN : MARGIN;
    double right = ui_pane_overflows(place) ? fmax(margin, BAR_WIDTH + UI_FRAME + UI_RIM) : margin;
    ui->inner = (Box){{place->box.low.x + margin, place->box.low.y}, {place->box.high.x - right, place->box.high.y}};
    ui->list_y = -HUGE_VAL;
    ui->first_y = ui->y = place->box.low.y + TOP_MARGIN - place->scroll;
    ui->row_count = ui->row_index = 0;
    ui->at_given = false;
    memcpy(place->columns[0], place->columns[1], sizeof place->columns[0]);
    memset(place->columns[1], 0, sizeof place->columns[1]);
}

static void draw_ground(Ui *ui, const UiPane *pane) {
    ui_painter_layer(ui->painter, pane->modal ? UI_LAYER_MODAL : UI_LAYER_PANES);
    if (pane->modal && !pane->clear)
        ui_painter_box(ui->painter, ui->window, (UiInk)lrint(255 * DIM) << 24);
    if (pane->ground != ROLE_COUNT)
        ui_painter_ground(ui->painter, pane->box, palette_colour(ui->theme, pane->ground));
    if (pane->modal)
        ui_painter_frame(ui->painter, box_expand(pane->box, UI_RIM), UI_RIM, ui_state_ink(ui, ROLE_TEXT, 1));
}

void ui_pane_begin(Ui *ui, const UiPane *pane) {
    UiId id = digest_text(DIGEST_START, pane->name);
    UiPlace *place = ui_pane_find(ui, id);
    if (!place)
        place = make_place(ui, id, pane->name);
    place->box = pane->box;
    place->made = true;
    place->modal = pane->modal;
    place->unframed = pane->unframed;
    place->stop = pane->stop;
    place->scrolls = pane->scrolls;
    place->order = ui->order++;
    if (pane->modal)
        ui->modal = id;
    if (place->subject != pane->subject)
        place->scroll = 0;
    place->subject = pane->subject;
    if (pane->scrolls)
        scroll_by_wheel(ui, place);
    place->scroll = place->seen_scroll = pane->scrolls ? real_clamp(place->scroll, 0, hidden(place)) : 0;
    ui->place = place;
    ui->ground = pane->ground;
    draw_ground(ui, pane);
    ui_painter_clip(ui->painter, pane->box);
    begin_flow(ui, place);
    ui->first_stop = ui->stop_count;
    if (pane->stop)
        ui_stop_make(ui, id, UI_IS_PANE, pane->box);
}

static void scroll_by_key(Ui *ui, UiPlace *place) {
    double page = 0.9 * box_height(place->box);
    for (UiPress press; ui_stop_next_key(ui, place->id, &press);)
        switch (press.key) {
        case UI_KEY_UP:
            place->scroll -= NOTCH;
            break;
        case UI_KEY_DOWN:
            place->scroll += NOTCH;
            break;
        case UI_KEY_PAGE_UP:
            place->scroll -= page;
            break;
        case UI_KEY_PAGE_DOWN:
            place->scroll += page;
            break;
        case UI_KEY_HOME:
            place->scroll = 0;
            break;
        default:
            place->scroll = hidden(place);
        }
}

/* Returns the stop of the pane that is held by the mouse, or that was and is still below it, or that has the focus;
 * NULL: none. `top` is where the content begins. */
static const UiStop *stop_in_use(const Ui *ui, const UiPlace *place, double top) {
    const UiStop *focused = NULL;
    for (size_t i = ui->first_stop; i < ui->stop_count; i++) {
        const UiStop *stop = &ui->stops[i];
        UiId track = stop->kind == UI_IS_SLIDER ? ui_state_track(stop->id) : stop->id;
        Vec2 was = {ui->mouse.x, ui->mouse.y + stop->box.low.y - top - place->anchor_y};
        bool stays = stop->id == place->anchor && box_holds(stop->box, was);
        if (stop->kind == UI_IS_PANE)
            continue;
        if (stays || (ui->held && (ui->held == stop->id || ui->held == track)))
            return stop;
        if (ui->focus == stop->id)
            focused = stop;
    }
    return focused;
}

/* Scrolls with the content where it grows or shrinks above the stop in use, which stays under the pointer. */
static void keep_in_place(const Ui *ui, UiPlace *place) {
    double top = place->box.low.y - place->seen_scroll, was = place->anchor_y + top;
    const UiStop *stop = place->scrolls ? stop_in_use(ui, place, top) : NULL;
    if (stop && stop->id == place->anchor && was >= place->box.low.y && was < place->box.high.y)
        place->scroll += stop->box.low.y - was;
    place->anchor = stop ? stop->id : 0;
    place->anchor_y = stop ? stop->box.low.y - top : 0;
}

/* Requests another frame if the content was resized or scrolled: it moves in the next frame. */
static void handle_change(Ui *ui, UiPlace *place, double content) {
    bool wider = memcmp(place->columns[0], place->columns[1], sizeof place->columns[0]) != 0;
    if (place->content != content || place->scroll != place->seen_scroll || wider)
        ui_state_stir(ui);
}

void ui_pane_end(Ui *ui) {
    UiPlace *place = ui->place;
    double content = place->content;
    if (ui->row_index)
        ui->y += ui->row_height + UI_GAP;
    place->content = ui->y - ui->first_y + TOP_MARGIN; /* the gap below the last widget is the margin */
    if (ui_pane_overflows(place)) {
        draw_bar(ui, place);
        scroll_by_key(ui, place);
    }
    keep_in_place(ui, place);
    if (ui->stop_count == ui->first_stop && (place->modal || ui_pane_overflows(place)))
        ui_stop_make(ui, place->id, UI_IS_PANE, place->box);
    if (ui->focus_pane == place->id && ui->focus_made) {
        if (ui->reveal && place->scrolls && ui->focus != place->id)
            bring_into_view(ui, place);
        if (!place->unframed || ui->focus != place->id)
            ui_stop_draw(ui);
    }
    handle_change(ui, place, content);
    ui_painter_unclip(ui->painter);
    ui_painter_layer(ui->painter, UI_LAYER_PANES);
    ui->place = NULL;
    ui->inner = ui->window;
}

/* Flow ------------------------------------------------------------------------------------------------------------- */

void ui_at(Ui *ui, Box box) {
    ui->at = box;
    ui->at_given = true;
}

void ui_row(Ui *ui, int count) {
    if (ui->row_index)
        ui->y += ui->row_height + UI_GAP;
    ui->row_count = count;
    ui->row_index = 0;
    ui->row_height = 0;
}

void ui_gap(Ui *ui, double height) {
    ui->y += height;
}

Box ui_space(Ui *ui, double height) {
    Box box = {{ui->inner.low.x, ui->y}, {ui->inner.high.x, ui->y + height}};
    ui->y += height;
    return box;
}

double ui_pane_width(const Ui *ui) {
    if (ui->at_given)
        return box_width(ui->at);
    double width = box_width(ui->inner);
    return ui->row_count > 1 ? (width - UI_GAP * (ui->row_count - 1)) / ui->row_count : width;
}

Box ui_pane_next(Ui *ui, double height) {
    if (ui->at_given) {
        ui->at_given = false;
        return ui->at;
    }
    double width = ui_pane_width(ui), left = ui->inner.low.x + ui->row_index * (width + UI_GAP);
    Box box = {{left, ui->y}, {left + width, ui->y + height}};
    if (ui->row_count <= 1) {
        ui->y += height + UI_GAP;
        ui->row_count = 0;
        return box;
    }
    ui->row_height = fmax(ui->row_height, height);
    if (++ui->row_index == ui->row_count) {
        ui->y += ui->row_height + UI_GAP;
        ui->row_count = ui->row_index = 0;
    }
    return box;
}
