#include <string.h>

#include "widgets/ui_state.h"

void ui_image(Ui *ui, const ScreenTexture *texture, Box box) {
    if (texture->name)
        ui_painter_image(ui->painter, texture, box);
}

void ui_draw_picture(Ui *ui, const ScreenTexture *texture, const Vec2 corners[4], double opacity) {
    if (texture->name)
        ui_painter_picture(ui->painter, texture, corners, opacity);
}

void ui_draw_box(Ui *ui, Box box, Role role, double opacity) {
    ui_painter_box(ui->painter, box, ui_state_ink(ui, role, opacity));
}

void ui_draw_frame(Ui *ui, Box box, Role role, double width) {
    ui_painter_frame(ui->painter, box, width, ui_state_ink(ui, role, 1));
}

void ui_draw_line(Ui *ui, Vec2 from, Vec2 to, Role role, double width) {
    ui_painter_polyline(ui->painter, (Vec2[]){from, to}, 2, false, width, ui_state_ink(ui, role, 1));
}

void ui_draw_polyline(Ui *ui, const Vec2 *points, size_t count, bool closed, Role role, double width) {
    if (count)
        ui_painter_polyline(ui->painter, points, count, closed, width, ui_state_ink(ui, role, 1));
}

void ui_draw_disc(Ui *ui, Vec2 middle, double radius, Role role) {
    ui_painter_disc(ui->painter, middle, radius, ui_state_ink(ui, role, 1));
}

void ui_draw_diamond(Ui *ui, Vec2 middle, double radius, Role role) {
    Vec2 corners[] = {{middle.x - radius, middle.y},
                      {middle.x, middle.y - radius},
                      {middle.x + radius, middle.y},
                      {middle.x, middle.y + radius}};
    ui_painter_convex(ui->painter, corners, 4, ui_state_ink(ui, role, 1));
}

void ui_draw_text(Ui *ui, UiTextStyle style, Role role, Vec2 at, double aligned, const char *text) {
    at.x -= aligned * ui_extent(ui, style, text).x;
    ui_painter_text(ui->painter, style, ui_state_ink(ui, role, 1), at, text, strlen(text));
}

const UiPainted *ui_painted(const Ui *ui, size_t *count) {
    return ui_painter_painted(ui->painter, count);
}
