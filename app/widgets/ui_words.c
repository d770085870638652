#include <math.h>
#include <string.h>

#include "widgets/ui_inside.h"

#define ELLIPSIS "…"
#define HEADING_HEIGHT 30.0

/* As many bytes from the beginning as have room. */
static size_t fitting(Ui *ui, UiLetters letters, const char *words, size_t bytes, double width) {
    while (bytes > 0 && ui_pencil_extent(ui->pencil, letters, words, bytes).x > width) {
        bytes--;
        while (bytes > 0 && ((unsigned char)words[bytes] & 0xC0) == 0x80)
            bytes--;
    }
    return bytes;
}

void ui_words_in(Ui *ui, UiLetters letters, UiInk ink, Box box, double aligned, const char *words) {
    size_t bytes = strcspn(words, "\n");
    double width = ui_pencil_extent(ui->pencil, letters, words, bytes).x, room = box_width(box);
    double middle = (box.low.y + box.high.y) / 2;
    if (width <= room + 0.5) {
        Vec2 at = {box.low.x + aligned * (room - width), middle};
        ui_pencil_words(ui->pencil, letters, ink, at, words, bytes);
        return;
    }
    double dots = ui_extent(ui, letters, ELLIPSIS).x;
    bytes = fitting(ui, letters, words, bytes, room - dots);
    while (bytes > 0 && words[bytes - 1] == ' ')
        bytes--;
    width = ui_pencil_extent(ui->pencil, letters, words, bytes).x;
    ui_pencil_words(ui->pencil, letters, ink, vec2(box.low.x, middle), words, bytes);
    ui_pencil_words(ui->pencil, letters, ink, vec2(box.low.x + width, middle), ELLIPSIS, strlen(ELLIPSIS));
}

double ui_words_wrapped(Ui *ui, UiLetters letters, UiInk ink, Box box, const char *words) {
    double spacing = UI_SPACING * ui_pencil_size(letters), top = box.low.y;
    while (*words) {
        size_t bytes = ui_pencil_wrap(ui->pencil, letters, words, box_width(box));
        if (ink >> 24)
            ui_pencil_words(ui->pencil, letters, ink, vec2(box.low.x, top + spacing / 2), words, bytes);
        words += bytes;
        top += spacing;
        if (*words == '\n')
            words++;
        else
            while (*words == ' ')
                words++;
    }
    return top - box.low.y;
}

void ui_text(Ui *ui, UiLetters letters, Role role, const char *words) {
    Box measured = {{0, 0}, {ui_pane_width(ui), 0}};
    Box box = ui_pane_next(ui, ui_words_wrapped(ui, letters, 0, measured, words));
    ui_words_wrapped(ui, letters, ui_frame_ink(ui, role, 1), box, words);
}

void ui_line(Ui *ui, UiLetters letters, Role role, const char *words) {
    Box box = ui_pane_next(ui, fmax(UI_LINE_HEIGHT, UI_SPACING * ui_pencil_size(letters)));
    ui_words_in(ui, letters, ui_frame_ink(ui, role, 1), box, 0, words);
}

void ui_heading(Ui *ui, const char *words) {
    if (!ui->at_given && ui->y > ui->first_y && ui->place) {
        Box pane = ui->place->box, rule = {{pane.low.x, ui->y + 1}, {pane.high.x, ui->y + 1 + UI_EDGE}};
        ui_pencil_box(ui->pencil, rule, ui_frame_ink(ui, ROLE_ROOM, 0.35));
        ui_gap(ui, UI_GAP);
    }
    double spacing = UI_SPACING * ui_pencil_size(UI_HEADING);
    double height = ui_words_wrapped(ui, UI_HEADING, 0, (Box){{0, 0}, {ui_pane_width(ui), 0}}, words);
    Box box = ui_pane_next(ui, HEADING_HEIGHT + fmax(height - spacing, 0));
    box.low.y += (HEADING_HEIGHT - spacing) / 2;
    ui_words_wrapped(ui, UI_HEADING, ui_frame_ink(ui, ROLE_TEXT, 1), box, words);
}
