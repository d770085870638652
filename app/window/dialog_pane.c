#include "window/dialog_pane.h"

#include <time.h>

#include <math.h>

void dialog_pane_begin(Window *window, Box box) {
    UiPane pane = {.name = "sheet", .box = box, .ground = ROLE_PANEL, .scrolls = true, .modal = true};
    ui_pane_begin(window->ui, &pane);
}

Box dialog_pane_centred(const Window *window, double width, double height, double edge) {
    Vec2 page = window->frame.page, half = {fmin(width, page.x - edge) / 2, fmin(height, page.y - edge) / 2};
    Vec2 middle = vec2_scale(page, 0.5);
    return (Box){vec2_sub(middle, half), vec2_add(middle, half)};
}

void dialog_pane_show(Window *window, Dialog dialog) {
    window->dialog = dialog;
    window->dirty = true;
}

void dialog_pane_close(Window *window) {
    window->dialog = DIALOG_NONE;
    window->leave = LEAVE_NOTHING;
    window->dirty = true;
}

const char *dialog_pane_when(Window *window, int64_t when) {
    time_t moment = (time_t)when, now = time(NULL);
    struct tm then, today;
    char text[64];
    localtime_r(&moment, &then);
    localtime_r(&now, &today);
    bool same = then.tm_year == today.tm_year && then.tm_yday == today.tm_yday;
    strftime(text, sizeof text, same ? "%H:%M" : "%Y-%m-%d %H:%M", &then);
    return text_in_arena(&window->arena, "%s", text);
}
