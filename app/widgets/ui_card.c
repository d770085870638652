#include "widgets/ui_pane.h"
#include "widgets/ui_stop.h"
#include "widgets/ui_text.h"
#include "widgets/ui_tip.h"

#define EDGE 6.0 /* design points, round the picture and the text */
#define NAME_HEIGHT 26.0
#define THIN 1.5
#define THICK 4.0

/* Returns the place of the picture, which keeps its shape, in the middle of the box. */
static Box fitted(Box place, const ScreenTexture *picture) {
    double scale = fmin(box_width(place) / picture->width, box_height(place) / picture->height);
    Vec2 half = vec2_scale(vec2(picture->width, picture->height), scale / 2);
    Vec2 middle = vec2_scale(vec2_add(place.low, place.high), 0.5);
    return (Box){vec2_sub(middle, half), vec2_add(middle, half)};
}

static void draw_shape(Ui *ui, const UiCard *card, Vec2 middle) {
    enum { MOST = 64 };
    Vec2 points[MOST];
    size_t count = card->shape_count < MOST ? card->shape_count : MOST;
    for (size_t i = 0; i < count; i++)
        points[i] = vec2_add(middle, card->shape[i]);
    ui_draw_polyline(ui, points, count, true, ROLE_FURNITURE_LINE, THIN);
    ui_draw_polyline(ui, points, 2, false, ROLE_FURNITURE_LINE, THICK);
}

bool ui_card(Ui *ui, const UiCard *card) {
    UiId id = ui_state_id(ui, card->id ? card->id : card->name);
    Box box = ui_pane_next(ui, card->picture_height + NAME_HEIGHT + card->text_height + 3 * EDGE);
    UiTouch touch = ui_state_touch(ui, id, box, false);
    bool focused = ui_stop_make(ui, id, UI_IS_CARD, box);
    bool used = ui_stop_used(ui, id) || touch.clicked;
    ui_tip_offer(ui, id, box, card->help, touch.hovered, focused);
    Box inside = box_expand(box, -EDGE), place = inside;
    place.high.y = inside.low.y + card->picture_height;
    /* a name of several lines takes them from the picture */
    double line = UI_SPACING * ui_painter_size(UI_BOLD);
    double more = ui_text_height(ui, UI_BOLD, card->name, box_width(inside)) - line;
    double rest = card->whole ? ui_text_height(ui, UI_SMALL, card->text, box_width(inside)) - card->text_height : 0;
    rest = real_clamp(rest, 0, box_height(place) - more);
    place.high.y -= real_clamp(more + rest, 0, box_height(place));
    ui_painter_box(ui->painter, box, ui_state_ink(ui, touch.hovered ? ROLE_SHADE : ROLE_PAPER, 1));
    bool bold = touch.hovered || card->chosen;
    ui_painter_frame(ui->painter, box, bold ? 2 * UI_EDGE : UI_EDGE,
                     ui_state_ink(ui, card->chosen ? ROLE_CHAIR : ROLE_ROOM, 1));
    if (card->shape_count)
        draw_shape(ui, card, vec2_scale(vec2_add(place.low, place.high), 0.5));
    if (card->picture)
        ui_painter_image(ui->painter, card->picture, fitted(place, card->picture));
    Box text = {{inside.low.x, inside.low.y + card->picture_height - rest + EDGE / 2 + NAME_HEIGHT}, inside.high};
    Box name = {{inside.low.x, text.low.y - (NAME_HEIGHT + line) / 2 - more}, {inside.high.x, text.low.y}};
    ui_text_wrapped(ui, UI_BOLD, ui_state_ink(ui, ROLE_TEXT, 1), name, card->name);
    text.high.y = text.low.y + line * floor((box_height(text) + EDGE) / line); /* whole lines */
    ui_painter_clip(ui->painter, text);
    ui_text_wrapped(ui, UI_SMALL, ui_state_ink(ui, ROLE_DIM_TEXT, 1), text, card->text ? card->text : "");
    ui_painter_unclip(ui->painter);
    return used;
}

#define FOLD_HEIGHT 38.0
#define SIGN 5.0 /* design points, half the width of the sign before a fold's title */

bool ui_fold(Ui *ui, const char *title, const char *summary, bool *open) {
    UiId id = ui_state_id(ui, title);
    Box box = ui_pane_next(ui, FOLD_HEIGHT - UI_GAP), pane = ui->place->box;
    if (box.low.y > ui->first_y)
        ui_painter_box(ui->painter, (Box){{pane.low.x, box.low.y - 2}, {pane.high.x, box.low.y - 1}},
                       ui_state_ink(ui, ROLE_ROOM, 0.35));
    UiTouch touch = ui_state_touch(ui, id, box, false);
    bool focused = ui_stop_make(ui, id, UI_IS_ROW, box), used = ui_stop_used(ui, id) || touch.clicked;
    if (touch.hovered)
        ui_painter_box(ui->painter, box, ui_state_ink(ui, ROLE_SHADE, 0.6));
    double y = (box.low.y + box.high.y) / 2, x = box.low.x + SIGN;
    Vec2 down[] = {{x - SIGN, y - 3}, {x + SIGN, y - 3}, {x, y + 4}},
         aside[] = {{x - 3, y - SIGN}, {x + 4, y}, {x - 3, y + SIGN}};
    ui_painter_convex(ui->painter, *open ? down : aside, 3, ui_state_ink(ui, ROLE_DIM_TEXT, 1));
    Box inside = {{box.low.x + 4 * SIGN, box.low.y}, box.high};
    double width = summary ? ui_extent(ui, UI_BODY, summary).x : 0, named = ui_extent(ui, UI_HEADING, title).x;
    if (summary && named + width + 2 * SIGN < box_width(inside))
        ui_draw_text(ui, UI_BODY, ROLE_DIM_TEXT, (Vec2){inside.high.x, y}, 1, summary);
    ui_text_in(ui, UI_HEADING, ui_state_ink(ui, ROLE_TEXT, 1), inside, 0, title);
    ui_tip_offer(ui, id, box, NULL, touch.hovered, focused);
    *open ^= used;
    return used;
}
