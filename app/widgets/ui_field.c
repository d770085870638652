#include <string.h>

#include "widgets/ui_editor.h"
#include "widgets/ui_pane.h"
#include "widgets/ui_stop.h"
#include "widgets/ui_text.h"
#include "widgets/ui_tip.h"

#define FIELD_HEIGHT 32.0

static void draw_text(Ui *ui, Box box, const char *text, UiTouch touch, bool typing) {
    ui_painter_box(ui->painter, box, ui_state_ink(ui, ROLE_PAPER, 1));
    ui_painter_frame(ui->painter, box, UI_EDGE, ui_state_ink(ui, typing || touch.hovered ? ROLE_TEXT : ROLE_ROOM, 1));
    if (typing)
        ui_editor_draw(ui, box, touch);
    else
        ui_text_start(ui, UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1),
                      (Box){{box.low.x + 7, box.low.y}, {box.high.x - 7, box.high.y}}, text);
}

/* Copies as much of the text as has room, in whole characters. */
static void take(char *text, size_t size, const char *label) {
    size_t bytes = strlen(label);
    if (bytes >= size) {
        bytes = size - 1;
        while (bytes > 0 && ((unsigned char)label[bytes] & 0xC0) == 0x80)
            bytes--;
    }
    memcpy(text, label, bytes);
    text[bytes] = 0;
}

bool ui_field(Ui *ui, const char *id_text, const char *label, const char *help, char *text, size_t size) {
    UiId id = ui_state_id(ui, id_text ? id_text : label);
    bool named = label && *label, typing = ui->editor.id == id;
    Box whole = ui_pane_next(ui, FIELD_HEIGHT + (named ? UI_LINE_HEIGHT : 0)), box = whole;
    const UiTyped *ended = ui_editor_ended(ui, id);
    if (ended)
        take(text, size, ended->text);
    if (typing)
        take(text, size, ui->editor.text);
    if (named) {
        box.low.y += UI_LINE_HEIGHT;
        ui_text_in(ui, UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1), (Box){whole.low, {whole.high.x, box.low.y}}, 0, label);
    }
    bool focused = ui_stop_make_typed(ui, id, UI_IS_FIELD, whole, text, NULL);
    UiTouch touch = ui_state_touch(ui, id, box, false);
    if (touch.pressed && !typing) {
        ui_editor_open(ui, id, text);
        typing = true;
    }
    draw_text(ui, box, text, touch, typing);
    ui_tip_offer(ui, id, whole, help, touch.hovered, focused);
    return ended && ended->end == UI_END_ENTERED;
}
