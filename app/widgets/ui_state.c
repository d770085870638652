#include "widgets/ui_state.h"

#include "base/digest.h"

static UiInk ink_of(Colour colour, double opacity) {
    return (UiInk)lrint(255 * colour.red) | (UiInk)lrint(255 * colour.green) << 8 |
           (UiInk)lrint(255 * colour.blue) << 16 | (UiInk)lrint(255 * opacity) << 24;
}

UiInk ui_state_ink(const Ui *ui, Role role, double opacity) {
    return ink_of(palette_colour(ui->theme, role), opacity);
}

UiInk ui_state_ink_on(const Ui *ui, Role role) {
    return ink_of(palette_ink(ui->theme, role), 1);
}

/* The mouse -------------------------------------------------------------------------------------------------------- */

void ui_state_stir(Ui *ui) {
    ui->stirred = 2;
}

UiId ui_state_id(const Ui *ui, const char *id) {
    return digest_text(ui->place ? ui->place->id : DIGEST_START, id);
}

static Box common(Box a, Box b) {
    return (Box){{fmax(a.low.x, b.low.x), fmax(a.low.y, b.low.y)},
                 {fmin(a.high.x, b.high.x), fmin(a.high.y, b.high.y)}};
}

UiTouch ui_state_touch(Ui *ui, UiId id, Box box, bool canvas) {
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

UiGrab ui_grab(Ui *ui, const char *id, Box box) {
    UiTouch touch = ui_state_touch(ui, ui_state_id(ui, id), box, true);
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
