#include "window/outlook.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "window/act.h"
#include "window/act_plot.h"
#include "window/backdrop.h"
#include "window/edit.h"
#include "window/edit_marks.h"

/* Design points. */
#define MARGIN 12.0
#define LEAST_SIDE 24.0
#define SCALE_WIDTH 150.0 /* of the view's scale, to the right */

enum { NOTE_LINES = 4 };

#define WHEEL_ZOOM 1.15

static Vec2 middle_of(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

/* Whole pixels of a place in the window. */
static void pixels_of(const Window *window, Box box, int *x, int *y, int *width, int *height) {
    *x = (int)lround(box.low.x * window->unit);
    *y = (int)lround(box.low.y * window->unit);
    *width = (int)lround(box.high.x * window->unit) - *x;
    *height = (int)lround(box.high.y * window->unit) - *y;
}

void outlook_paint(Window *window) {
    Room *room = window_room(window);
    int x, y, width, height;
    pixels_of(window, window->frame.view, &x, &y, &width, &height);
    if (!room->live || width < LEAST_SIDE || height < LEAST_SIDE)
        return;
    scenery_fit(&room->scenery, glass_gl(window->glass), width, height, window->unit, window->theme);
    if (room->scenery.paint)
        scenery_show(&room->scenery, room->kind, room->live, room->player.time);
    window->dirty |= room->charts_wait; /* they have their places with the next picture */
    if (room->charts_wait)
        charts_choose(&room->charts, room->kind, room->live, room->plots, window->screen);
    room->charts_wait = false;
}

/* The index of a chart's plot among the laboratory's. */
static size_t plot_of(const Room *room, const Chart *chart) {
    size_t count = room->kind->plot_count(room->live), i = 0;
    while (i < count && strcmp(room->kind->plot(room->live, i).name, chart->live.name) != 0)
        i++;
    return i;
}

/* The view --------------------------------------------------------------------------------------------------------- */

/* One line after the other, from the foot of the view up, beside the scale; where letters are large from its top down.
 */
static void show_note(Window *window, const char *note) {
    Box view = window->frame.view;
    double height = ui_extent(window->ui, UI_BODY, "x").y, most = fmax(box_width(view) - SCALE_WIDTH, SCALE_WIDTH);
    const char *lines[NOTE_LINES];
    int count = 0;
    for (const char *at = note; *at && count < NOTE_LINES; count++) {
        const char *end = strstr(at, "; ");
        bool fits = ui_extent(window->ui, UI_BODY, at).x <= most || !end;
        lines[count] = fits ? at : text_in_arena(&window->words, "%.*s", (int)(end - at), at);
        at = fits ? "" : end + 2;
    }
    for (int i = 0; i < count; i++) {
        double y = window->frame.compact ? view.low.y + height * (i + 1)
                                         : view.high.y - MARGIN - height * (count - i) + height / 2;
        double right = view.low.x + MARGIN + ui_extent(window->ui, UI_BODY, lines[i]).x;
        ui_draw_box(window->ui, (Box){{view.low.x + MARGIN - 4, y - height / 2}, {right + 4, y + height / 2}},
                    ROLE_PAPER, 0.8);
        ui_draw_words(window->ui, UI_BODY, ROLE_DIM_TEXT, vec2(view.low.x + MARGIN, y), 0, lines[i]);
    }
}

/* In the middle of the upper edge. */
static void show_animation(Window *window, const char *words) {
    if (!words || !*words)
        return;
    Box view = window->frame.view;
    Vec2 size = ui_extent(window->ui, UI_HEADING, words), middle = middle_of(view);
    Box strip = {{middle.x - size.x / 2 - MARGIN, view.low.y + MARGIN},
                 {middle.x + size.x / 2 + MARGIN, view.low.y + MARGIN + size.y + 6}};
    ui_draw_box(window->ui, strip, ROLE_TEXT, 1);
    ui_draw_words(window->ui, UI_HEADING, ROLE_PAPER, middle_of(strip), 0.5, words);
}

static void show_view_words(Window *window, const Room *room) {
    Box view = window->frame.view;
    show_note(window, room->kind->note(room->live));
    show_animation(window, edit_animation(room));
    if (room->player.playing || (window->edit.holds && window->edit.plays_on))
        return;
    Vec2 size = ui_extent(window->ui, UI_HEADING, "PAUSED");
    Box tag = {{view.high.x - size.x - 3 * MARGIN, view.low.y + MARGIN},
               {view.high.x - MARGIN, view.low.y + MARGIN + size.y + 6}};
    ui_draw_box(window->ui, tag, ROLE_TEXT, 1);
    ui_draw_words(window->ui, UI_HEADING, ROLE_PAPER, vec2(tag.low.x + MARGIN, middle_of(tag).y), 0, "PAUSED");
}

static Vec2 floor_at(const Window *window, const Room *room, Vec2 at) {
    return scenery_floor(&room->scenery, vec2_sub(at, window->frame.view.low));
}

/* A click selects, a second one on the same place what lies below. */
static void pick(Window *window, Room *room, Vec2 place) {
    LiveThing now = room->kind->selected(room->live);
    Vec2 at = floor_at(window, room, place);
    LiveThing top = room->kind->pick(room->live, at, room->player.time, (LiveThing){0});
    room_select(room, live_same(top, now) ? room->kind->pick(room->live, at, room->player.time, now) : top);
    ui_focus(window->ui, "view");
    window->dirty = true;
}

/* The right or middle button moves the view, the wheel enlarges it; what can be edited has the left one. */
static void use_mouse(Window *window, Room *room) {
    UiGrab grab = ui_grab(window->ui, "view", window->frame.view);
    if (!room->scenery.painted)
        return;
    if (grab.hovered && grab.wheel != 0)
        room_zoom(room, pow(WHEEL_ZOOM, grab.wheel), floor_at(window, room, grab.at));
    bool pans = window->input.down[GLASS_RIGHT] || window->input.down[GLASS_MIDDLE];
    if (grab.hovered && pans && (grab.delta.x != 0 || grab.delta.y != 0)) {
        room_pan(room,
                 vec2_sub(floor_at(window, room, vec2_sub(grab.at, grab.delta)), floor_at(window, room, grab.at)));
    }
    if (edit_of(room))
        edit_mouse(window, &grab);
    else if (grab.pressed)
        pick(window, room, grab.at);
}

static void show_view(Window *window, Room *room) {
    Box view = window->frame.view;
    ui_pane_begin(window->ui, &(UiPane){.name = "view", .box = view, .ground = ROLE_COUNT, .stop = true});
    if (room->live) {
        backdrop_show(window);
        use_mouse(window, room);
        show_view_words(window, room);
        edit_marks_show(window);
    }
    ui_pane_end(window->ui);
}

/* The plots -------------------------------------------------------------------------------------------------------- */

static void show_read_out(Window *window, Room *room, Chart *chart, size_t plot, Vec2 at) {
    char words[CHART_WORDS];
    Vec2 nearest;
    if (!charts_read(chart, room->kind, room->live, plot, room->player.time, at, &nearest, words))
        return;
    Vec2 extent = ui_extent(window->ui, UI_BODY, words);
    double left = fmin(fmax(nearest.x + 10, chart->place.low.x), chart->place.high.x - extent.x - 8);
    double top = fmax(nearest.y - extent.y - 10, chart->place.low.y);
    ui_draw_disc(window->ui, nearest, 4, ROLE_TEXT);
    ui_draw_box(window->ui, (Box){{left - 4, top}, {left + extent.x + 4, top + extent.y + 4}}, ROLE_PANEL, 1);
    ui_draw_words(window->ui, UI_BODY, ROLE_TEXT, vec2(left, top + extent.y / 2 + 2), 0, words);
}

/* A click sets what the cursor stands for; the wheel zooms about the pointer. */
static void use_chart_mouse(Window *window, Room *room, Chart *chart, size_t plot) {
    Vec2 value;
    UiGrab grab = ui_grab(window->ui, chart->live.name, chart->place);
    if (!chart->canvas || !charts_value(chart, grab.at, &value))
        return;
    if (grab.hovered && grab.wheel != 0) {
        ChartAxes axes = charts_axes(chart);
        double part = pow(WHEEL_ZOOM, -grab.wheel);
        charts_zoom(chart, vec2_add(value, vec2(part * (axes.x[0] - value.x), part * (axes.y[0] - value.y))),
                    vec2_add(value, vec2(part * (axes.x[1] - value.x), part * (axes.y[1] - value.y))));
        return;
    }
    if (grab.pressed) {
        ui_focus(window->ui, text_in_arena(&window->words, "plot:%s", chart->live.name));
        act_plot_use(window, chart, value.x);
    }
    if (grab.hovered)
        show_read_out(window, room, chart, plot, grab.at);
}

static void show_chart(Window *window, Room *room, size_t index) {
    Chart *chart = &room->charts.charts[index];
    Box box = window->frame.charts[index];
    ui_pane_begin(window->ui, &(UiPane){.name = text_in_arena(&window->words, "plot:%s", chart->live.name),
                                        .box = box,
                                        .ground = ROLE_PAPER,
                                        .stop = true});
    size_t plot = plot_of(room, chart);
    if (plot < room->kind->plot_count(room->live)) {
        charts_show(chart, room->kind, room->live, plot, room->player.time, box, window->unit, window->theme,
                    window->screen, window->ui);
        use_chart_mouse(window, room, chart, plot);
    }
    ui_pane_end(window->ui);
}

void outlook_show(Window *window) {
    Room *room = window_room(window);
    show_view(window, room);
    for (size_t i = 0; room->live && i < window->frame.chart_count && i < room->charts.count; i++)
        show_chart(window, room, i);
}
