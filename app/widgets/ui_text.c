#include "widgets/ui_text.h"

#include <math.h>
#include <string.h>

#include "widgets/ui_pane.h"

#define ELLIPSIS "…"
#define HEADING_HEIGHT 30.0

Vec2 ui_extent(Ui *ui, UiTextStyle style, const char *text) {
    return ui_painter_extent(ui->painter, style, text, strlen(text));
}

/* Returns how many bytes from the beginning have room. */
static size_t fitting(Ui *ui, UiTextStyle style, const char *text, size_t bytes, double width) {
    while (bytes > 0 && ui_painter_extent(ui->painter, style, text, bytes).x > width) {
        bytes--;
        while (bytes > 0 && ((unsigned char)text[bytes] & 0xC0) == 0x80)
            bytes--;
    }
    return bytes;
}

void ui_text_in(Ui *ui, UiTextStyle style, UiInk ink, Box box, double aligned, const char *text) {
    size_t bytes = strcspn(text, "\n");
    double width = ui_painter_extent(ui->painter, style, text, bytes).x, room = box_width(box);
    double middle = (box.low.y + box.high.y) / 2;
    if (width <= room + 0.5) {
        Vec2 at = {box.low.x + aligned * (room - width), middle};
        ui_painter_text(ui->painter, style, ink, at, text, bytes);
        return;
    }
    double dots = ui_extent(ui, style, ELLIPSIS).x;
    bytes = fitting(ui, style, text, bytes, room - dots);
    while (bytes > 0 && text[bytes - 1] == ' ')
        bytes--;
    width = ui_painter_extent(ui->painter, style, text, bytes).x;
    ui_painter_text(ui->painter, style, ink, vec2(box.low.x, middle), text, bytes);
    ui_painter_text(ui->painter, style, ink, vec2(box.low.x + width, middle), ELLIPSIS, strlen(ELLIPSIS));
}

void ui_text_start(Ui *ui, UiTextStyle style, UiInk ink, Box box, const char *text) {
    size_t bytes = fitting(ui, style, text, strcspn(text, "\n"), box_width(box));
    ui_painter_text(ui->painter, style, ink, vec2(box.low.x, (box.low.y + box.high.y) / 2), text, bytes);
}

/* Returns the end of a line that does not part a number from its unit: "0.75 m" goes to the next line whole. */
static size_t end_with_unit(const char *text, size_t bytes) {
    static const char *const units[] = {"m", "cm", "mm", "s", "min", "m/s", "N", "kg", "Hz", "rpm", "%"};
    if (bytes == 0 || text[bytes] != ' ' || text[bytes - 1] < '0' || text[bytes - 1] > '9')
        return bytes;
    size_t length = strcspn(text + bytes + 1, " ,.;:)\n"), number = bytes;
    while (number > 0 && text[number - 1] != ' ')
        number--;
    for (size_t u = 0; number > 0 && u < sizeof units / sizeof *units; u++)
        if (strlen(units[u]) == length && strncmp(text + bytes + 1, units[u], length) == 0)
            return number - 1;
    return bytes;
}

double ui_text_wrapped(Ui *ui, UiTextStyle style, UiInk ink, Box box, const char *text) {
    double spacing = UI_SPACING * ui_painter_size(style), top = box.low.y;
    while (*text) {
        size_t bytes = end_with_unit(text, ui_painter_wrap(ui->painter, style, text, box_width(box)));
        if (ink >> 24)
            ui_painter_text(ui->painter, style, ink, vec2(box.low.x, top + spacing / 2), text, bytes);
        text += bytes;
        top += spacing;
        if (*text == '\n')
            text++;
        else
            while (*text == ' ')
                text++;
    }
    return top - box.low.y;
}

double ui_text_height(Ui *ui, UiTextStyle style, const char *text, double width) {
    return ui_text_wrapped(ui, style, 0, (Box){{0, 0}, {width, 0}}, text);
}

void ui_text(Ui *ui, UiTextStyle style, Role role, const char *text) {
    Box measured = {{0, 0}, {ui_pane_width(ui), 0}};
    Box box = ui_pane_next(ui, ui_text_wrapped(ui, style, 0, measured, text));
    ui_text_wrapped(ui, style, ui_state_ink(ui, role, 1), box, text);
}

void ui_line(Ui *ui, UiTextStyle style, Role role, const char *text) {
    Box box = ui_pane_next(ui, fmax(UI_LINE_HEIGHT, UI_SPACING * ui_painter_size(style)));
    ui_text_in(ui, style, ui_state_ink(ui, role, 1), box, 0, text);
}

void ui_heading(Ui *ui, const char *text) {
    if (!ui->at_given && ui->y > ui->first_y && ui->place) {
        Box pane = ui->place->box, rule = {{pane.low.x, ui->y + 1}, {pane.high.x, ui->y + 1 + UI_EDGE}};
        ui_painter_box(ui->painter, rule, ui_state_ink(ui, ROLE_ROOM, 0.35));
        ui_gap(ui, UI_GAP);
    }
    double spacing = UI_SPACING * ui_painter_size(UI_HEADING);
    double height = ui_text_wrapped(ui, UI_HEADING, 0, (Box){{0, 0}, {ui_pane_width(ui), 0}}, text);
    Box box = ui_pane_next(ui, HEADING_HEIGHT + fmax(height - spacing, 0));
    box.low.y += (HEADING_HEIGHT - spacing) / 2;
    ui_text_wrapped(ui, UI_HEADING, ui_state_ink(ui, ROLE_TEXT, 1), box, text);
}
