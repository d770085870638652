#include "window/canvas.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "draw/caption.h"
#include "window/act.h"
#include "window/act_plot.h"
#include "window/lesson.h"
#include "window/plan_input.h"
#include "window/plan_overlay.h"
#include "window/trace_image.h"

/* Design points. */
#define MARGIN 12.0
#define LEAST_SIDE 24.0
#define EDIT_HEIGHT 32.0
#define EDIT_TOP 8.0
#define EDIT_AIR 4.0      /* around the button, free of labels */
#define SCALE_WIDTH 150.0 /* of the view's scale bar, at the right */
#define SCALE_HEIGHT 40.0 /* of the scale bar with its number, in the same corner */
#define LEAST_NOTE 110.0  /* width of a note */

#define RING 34.0     /* across, of the pointer in presentation mode */
#define ECHO_STAY 1.5 /* s */

enum { RING_POINTS = 36 };

/* The changes that a fix makes. */
#define CHANGE_LINE 3.0
#define CHANGE_ASIDE 18.0
#define CHANGE_TICK 6.0

#define READ_OUT_MARGIN 12.0 /* of a plot's width, beside its read-out */
#define WHEEL_ZOOM 1.15

static Vec2 middle_of(Box box) {
    return vec2_scale(vec2_add(box.low, box.high), 0.5);
}

/* The button that shows the tools ---------------------------------------------------------------------------------- */

static const char *edit_label(bool editing) {
    return editing ? "\u2713 Done editing" : "\u270e Edit plan";
}

/* True if the view has the button that shows the tools. */
static bool has_edit_button(Window *window) {
    return tab_editor(window_tab(window)) && !window->present && !window->frame.compact;
}

static double edit_width(Window *window, bool editing) {
    return ui_extent(window->ui, UI_BODY, edit_label(editing)).x + 2 * MARGIN;
}

/* Shows the button that shows the tools or puts them away. */
static void show_edit_button(Window *window) {
    Vec2 low = vec2_add(window->frame.view.low, vec2(MARGIN, EDIT_TOP));
    ui_at(window->ui, (Box){low, vec2_add(low, vec2(edit_width(window, window->editing), EDIT_HEIGHT))});
    if (ui_button(window->ui, &(UiButton){.id = "edit plan",
                                          .label = edit_label(window->editing),
                                          .help = keys_help(&window->arena, ACTION_EDIT_PLAN)}))
        act_do(window, ACTION_EDIT_PLAN, 0, 0);
}

/* Keeps the labels of the picture off the button, with either of its labels. */
static void keep_off_edit_button(Window *window, ViewLayers *layers) {
    double width = fmax(edit_width(window, false), edit_width(window, true));
    Box button = {{MARGIN, EDIT_TOP}, {MARGIN + width, EDIT_TOP + EDIT_HEIGHT}};
    view_layers_take(layers, has_edit_button(window) ? box_expand(button, EDIT_AIR) : (Box){0});
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

/* Converts a box of the window to whole pixels. */
static void pixels_of(const Window *window, Box box, int *x, int *y, int *width, int *height) {
    *x = (int)lround(box.low.x * window->unit);
    *y = (int)lround(box.low.y * window->unit);
    *width = (int)lround(box.high.x * window->unit) - *x;
    *height = (int)lround(box.high.y * window->unit) - *y;
}

static void choose_plots(Window *window, Tab *tab) {
    const char *names = tab_plots(tab);
    plot_panes_choose(&tab->panes, tab->laboratory, tab->session, names, window->screen);
    if (tab->laboratory->note_plots)
        tab->laboratory->note_plots(tab->session, names);
}

/* Paints the plan with the fix. */
static void paint_trial(Window *window, Tab *tab) {
    ViewLayers *layers = &tab->trial_layers;
    int x, y, width, height;
    pixels_of(window, window->frame.beside, &x, &y, &width, &height);
    if (width < LEAST_SIDE || height < LEAST_SIDE)
        return;
    view_layers_fit(layers, sdl_window_gl(window->sdl_window), width, height, window->unit, window->theme);
    layers->plain = window->present;
    double time = trial_time(tab->laboratory, tab->trial.session, tab->player.time);
    if (layers->paint)
        view_layers_show(layers, tab->laboratory, tab->trial.session, time);
}

void canvas_paint(Window *window) {
    Tab *tab = window_tab(window);
    int x, y, width, height;
    pixels_of(window, window->frame.view, &x, &y, &width, &height);
    if (!tab->session || width < LEAST_SIDE || height < LEAST_SIDE)
        return;
    view_layers_fit(&tab->view_layers, sdl_window_gl(window->sdl_window), width, height, window->unit, window->theme);
    keep_off_edit_button(window, &tab->view_layers);
    tab->view_layers.plain = window->present;
    if (tab->view_layers.paint)
        view_layers_show(&tab->view_layers, tab->laboratory, tab->session, tab_time(tab));
    if (tab->trial.session)
        paint_trial(window, tab);
    window->dirty |= tab->plot_panes_stale; /* the next frame lays them out */
    if (tab->plot_panes_stale)
        choose_plots(window, tab);
    tab->plot_panes_stale = false;
}

void canvas_hold_still(Window *window, const Frame *before) {
    Tab *tab = window_tab(window);
    const Frame *now = &window->frame;
    bool had = box_width(before->toolbar) > 0, has = box_width(now->toolbar) > 0;
    bool same = window->framed == window->current && now->page.x == before->page.x && now->page.y == before->page.y &&
                now->answer.high.y == before->answer.high.y && now->panel.low.x == before->panel.low.x &&
                now->pane_count == before->pane_count;
    window->framed = window->current;
    bool wide = frame_is_wide(now->page);
    if (had != has && same && tab->session && box_width(before->view) > 0)
        tab_keep_still(tab, before->view, now->view, had && !wide);
    if (tab->session && (wide || tab->part_scale > 0)) {
        Box part = now->view;
        part.low.x += now->still_from;
        tab_fit_part(tab, part, now->view);
        if (!wide)
            tab->part_scale = 0;
    }
}

/* Returns the index of a pane's plot among the laboratory's plots. */
static size_t plot_of(const Tab *tab, const PlotPane *pane) {
    size_t count = tab->laboratory->plot_count(tab->session), i = 0;
    while (i < count && strcmp(tab->laboratory->plot(tab->session, i).name, pane->source.name) != 0)
        i++;
    return i;
}

/* The view --------------------------------------------------------------------------------------------------------- */

/* Returns the left edge of the note: next to the button. */
static double note_left(Window *window) {
    double left = window->frame.view.low.x + MARGIN;
    return has_edit_button(window) ? left + edit_width(window, window->editing) + 2 * MARGIN : left;
}

/* Returns the box of the plan and its names in the view, design points. */
static Box picture_box(const Window *window, Tab *tab) {
    const Layout *still = &tab->view_layers.still;
    Box floor = tab->laboratory->still(tab->session)->box, box = box_empty();
    const Vec2 corners[] = {floor.low, {floor.high.x, floor.low.y}, floor.high, {floor.low.x, floor.high.y}};
    for (size_t i = 0; i < sizeof corners / sizeof *corners; i++)
        box = box_include(box, layout_point(still, corners[i]));
    for (size_t i = 0; i < still->caption_count; i++) {
        Box caption = caption_box(&still->captions[i]);
        box = box_include(box_include(box, caption.low), caption.high);
    }
    return (Box){vec2_add(window->frame.view.low, box.low), vec2_add(window->frame.view.low, box.high)};
}

/* Shows the name of an animation at the middle of the upper edge. */
static void show_animation(Window *window, const char *text) {
    if (!text || !*text)
        return;
    Box view = window->frame.view;
    Vec2 size = ui_extent(window->ui, UI_HEADING, text), middle = middle_of(view);
    Box strip = {{middle.x - size.x / 2 - MARGIN, view.low.y + MARGIN},
                 {middle.x + size.x / 2 + MARGIN, view.low.y + MARGIN + size.y + 6}};
    ui_draw_box(window->ui, strip, ROLE_TEXT, 1);
    ui_draw_text(window->ui, UI_HEADING, ROLE_PAPER, middle_of(strip), 0.5, text);
}

static bool stands_in(const Window *window, const Layout *layout, Box box) {
    for (size_t i = 0; i < layout->caption_count; i++) {
        Box label = caption_box(&layout->captions[i]);
        label.low = vec2_add(label.low, window->frame.view.low);
        label.high = vec2_add(label.high, window->frame.view.low);
        if (box.low.x < label.high.x && label.low.x < box.high.x && box.low.y < label.high.y &&
            label.low.y < box.high.y)
            return true;
    }
    return false;
}

/* True if a label of the picture stands in a box of the page. */
static bool has_label(const Window *window, const Tab *tab, Box box) {
    return tab->view_layers.painted &&
           (stands_in(window, &tab->view_layers.still, box) || stands_in(window, &tab->view_layers.moving, box));
}

/* Returns the box of a line of a note, broken between words where a large text has the plan beside it. */
static Box note_line(Window *window, Box picture, Vec2 low, const char *line) {
    Vec2 extent = ui_extent(window->ui, UI_BODY, line);
    bool covers = window->frame.compact && low.y + extent.y > picture.low.y && low.x + extent.x > picture.low.x;
    double width = covers ? fmax(picture.low.x - MARGIN - low.x, LEAST_NOTE) : extent.x + 1;
    return (Box){low, {low.x + width, low.y + ui_text_height(window->ui, UI_BODY, line, width)}};
}

/* Lays a note out line by line below a place, and draws it if that is wanted. Returns its box. */
static Box lay_note(Window *window, Box picture, Vec2 low, const char *note, bool draws) {
    double most = fmax(window->frame.view.high.x - SCALE_WIDTH - low.x, SCALE_WIDTH);
    Box all = {low, low};
    for (const char *at = note; *at;) {
        const char *end = strstr(at, "; ");
        bool fits = ui_extent(window->ui, UI_BODY, at).x <= most || !end;
        const char *line = fits ? at : text_in_arena(&window->arena, "%.*s", (int)(end - at), at);
        Box box = note_line(window, picture, vec2(low.x, all.high.y), line);
        if (draws) {
            ui_draw_box(window->ui, (Box){{low.x - 4, box.low.y}, {box.high.x + 4, box.high.y}}, ROLE_PAPER, 0.8);
            ui_at(window->ui, box);
            ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT, line);
        }
        all.high = vec2(fmax(all.high.x, box.high.x), box.high.y);
        at = fits ? "" : end + 2;
    }
    return all;
}

/* True if a box leaves the view, or has a label or a part of the picture below it. */
static bool covers_something(const Window *window, const Tab *tab, Box picture, Box box) {
    Box view = window->frame.view;
    bool over = box.low.x < picture.high.x && picture.low.x < box.high.x && box.low.y < picture.high.y &&
                picture.low.y < box.high.y;
    return over || box.low.y < view.low.y || box.high.x > view.high.x || has_label(window, tab, box);
}

/* Shows a note at the top of the view, where the title bar has no room for it. With large letters it goes to the foot
 * if it would cover something at the top, and to the timeline if it would at both. */
static void show_note(Window *window, Tab *tab, const char *note) {
    Box view = window->frame.view, picture = tab->view_layers.painted ? picture_box(window, tab) : view;
    Vec2 low = {note_left(window), view.low.y + MARGIN / 2};
    Box box = lay_note(window, picture, low, note, false);
    if (window->frame.compact && covers_something(window, tab, picture, box)) {
        low.y = view.high.y - MARGIN / 2 - box_height(box);
        window->note_crowded = covers_something(window, tab, picture, lay_note(window, picture, low, note, false));
    }
    if (!window->note_crowded)
        window->note = lay_note(window, picture, low, note, true);
}

static void show_view_text(Window *window, Tab *tab) {
    Box view = window->frame.view;
    window->note_crowded = false;
    window->note = box_empty();
    const char *note = tab->laboratory->note(tab->session);
    if (*note && !window->noted_in_bar && !window->present)
        show_note(window, tab, note);
    show_animation(window, plan_input_animation(tab));
    bool crowded =
        window->frame.compact && tab->laboratory->numbers_first; /* a machine fills a low view: Play says it */
    if (window->present || crowded || lesson_hides(window) || tab->player.playing || !tab_can_play(tab) ||
        (window->plan_input.holds && window->plan_input.plays_on))
        return;
    Vec2 size = ui_extent(window->ui, UI_HEADING, "PAUSED");
    Box tag = {{view.high.x - size.x - 3 * MARGIN, view.low.y + MARGIN},
               {view.high.x - MARGIN, view.low.y + MARGIN + size.y + 6}};
    Vec2 down = {0, size.y + 6 + MARGIN};
    while (has_label(window, tab, tag) && tag.high.y + down.y < view.high.y)
        tag = (Box){vec2_add(tag.low, down), vec2_add(tag.high, down)};
    bool on_scale = tag.high.y > view.high.y - SCALE_HEIGHT;
    if (window->frame.compact && (on_scale || has_label(window, tab, tag)))
        return; /* no place is free: Play says it */
    ui_draw_box(window->ui, tag, ROLE_TEXT, 1);
    ui_draw_text(window->ui, UI_HEADING, ROLE_PAPER, vec2(tag.low.x + MARGIN, middle_of(tag).y), 0, "PAUSED");
}

static Vec2 floor_at(const Window *window, const Tab *tab, Vec2 at) {
    return view_layers_floor(&tab->view_layers, vec2_sub(at, window->frame.view.low));
}

/* Selects the item under a click; another click at the same place selects the item below it. */
static void pick(Window *window, Tab *tab, Vec2 place) {
    Item now = tab->laboratory->selected(tab->session);
    Vec2 at = floor_at(window, tab, place);
    Item top = tab->laboratory->pick(tab->session, at, tab_time(tab), (Item){0});
    tab_select(tab, item_same(top, now) ? tab->laboratory->pick(tab->session, at, tab_time(tab), now) : top);
    ui_focus(window->ui, "view");
    window->dirty = true;
}

/* Pans by the right or middle button and zooms by the wheel; the left button edits, or selects where nothing can be
 * edited. */
static void use_mouse(Window *window, Tab *tab) {
    UiGrab grab = ui_grab(window->ui, "view", window->frame.view);
    if (!tab->view_layers.painted || lesson_hides(window))
        return;
    if (grab.hovered && grab.wheel != 0)
        tab_zoom(tab, pow(WHEEL_ZOOM, grab.wheel), floor_at(window, tab, grab.at));
    bool pans = window->input.down[SDL_WINDOW_EVENT_RIGHT] || window->input.down[SDL_WINDOW_EVENT_MIDDLE];
    if (grab.hovered && pans && (grab.delta.x != 0 || grab.delta.y != 0)) {
        tab_pan(tab, vec2_sub(floor_at(window, tab, vec2_sub(grab.at, grab.delta)), floor_at(window, tab, grab.at)));
    }
    if (tab_editor(tab))
        plan_input_mouse(window, &grab);
    else if (grab.pressed)
        pick(window, tab, grab.at);
}

/* Shows where the pointer is, to a room that looks at a wall. */
static void show_ring(Window *window) {
    Vec2 at = vec2_scale(window->mouse, 1 / window->unit), ring[RING_POINTS];
    if (!window->present || !box_holds(window->frame.view, at))
        return;
    for (int i = 0; i < RING_POINTS; i++)
        ring[i] = vec2_along(at, RING / 2, vec2_heading(2 * M_PI * i / RING_POINTS));
    ui_draw_polyline(window->ui, ring, RING_POINTS, true, ROLE_PAPER, 6);
    ui_draw_polyline(window->ui, ring, RING_POINTS, true, ROLE_TEXT, 3);
}

/* Shows the last key for a moment, so that others can follow. */
static void show_echo(Window *window) {
    if (!window->present || !*window->echo || stopwatch_now() - window->echo_at > ECHO_STAY)
        return;
    Box view = window->frame.view;
    Vec2 size = ui_extent(window->ui, UI_DETAIL, window->echo), low = {view.low.x + MARGIN, view.high.y - MARGIN};
    Box box = {{low.x, low.y - size.y - MARGIN}, {low.x + size.x + 2 * MARGIN, low.y}};
    ui_draw_box(window->ui, box, ROLE_TEXT, 1);
    ui_draw_text(window->ui, UI_DETAIL, ROLE_PAPER, middle_of(box), 0.5, window->echo);
    window->dirty = true;
}

/* The fix beside the plan ------------------------------------------------------------------------------------------ */

static void show_head(Window *window, Box head, const char *name, const Result *answer, const char *words) {
    double y = middle_of(head).y, left = head.low.x + MARGIN;
    ui_draw_box(window->ui, head, ROLE_PAPER, 1);
    ui_draw_line(window->ui, vec2(head.low.x, head.high.y), head.high, ROLE_GRID, 2);
    ui_draw_text(window->ui, UI_HEADING, ROLE_TEXT, vec2(left, y), 0, name);
    left += ui_extent(window->ui, UI_HEADING, name).x + MARGIN;
    Role role = answer->role == ROLE_ERROR ? ROLE_ERROR : answer->stale ? ROLE_DIM_TEXT : ROLE_EXIT_TAG;
    if (left + ui_extent(window->ui, UI_BOLD, words).x < head.high.x)
        ui_draw_text(window->ui, UI_BOLD, role, vec2(left, y), 0, words);
}

/* Shows what the fix changes: a door's new width beside its opening, or the outline of a piece. */
static void show_change(Window *window, Tab *tab) {
    const char *label;
    Vec2 points[LABORATORY_OUTLINE_MOST];
    Item item = trial_item(&tab->trial, tab_editor(tab), &label);
    double time = trial_time(tab->laboratory, tab->trial.session, tab->player.time);
    size_t count = item.kind ? tab->laboratory->outline(tab->trial.session, item, time, points) : 0;
    if (!count || !tab->trial_layers.painted)
        return;
    for (size_t i = 0; i < count; i++)
        points[i] = vec2_add(window->frame.beside.low, view_layers_point(&tab->trial_layers, points[i]));
    if (!label || count != 4) {
        ui_draw_polyline(window->ui, points, count, true, ROLE_PAPER, 2 * CHANGE_LINE);
        ui_draw_polyline(window->ui, points, count, true, ROLE_EXIT_TAG, CHANGE_LINE);
        return;
    }
    size_t side = vec2_distance(points[0], points[1]) > vec2_distance(points[1], points[2]) ? 0 : 1;
    Vec2 a = points[side], b = points[side + 1], across = vec2_unit(vec2_left(vec2_sub(b, a)));
    if (across.x > 0 || (across.x == 0 && across.y < 0)) /* to the left or below, where the chair comes from */
        across = vec2_scale(across, -1);
    a = vec2_along(a, CHANGE_ASIDE, across);
    b = vec2_along(b, CHANGE_ASIDE, across);
    ui_draw_line(window->ui, a, b, ROLE_PAPER, 2 * CHANGE_LINE);
    ui_draw_line(window->ui, a, b, ROLE_EXIT_TAG, CHANGE_LINE);
    for (int end = 0; end < 2; end++) {
        Vec2 at = end ? b : a;
        ui_draw_line(window->ui, vec2_along(at, -CHANGE_TICK, across), vec2_along(at, CHANGE_TICK, across),
                     ROLE_EXIT_TAG, CHANGE_LINE);
    }
    Vec2 half = vec2_add(vec2_scale(ui_extent(window->ui, UI_BOLD, label), 0.5), vec2(MARGIN / 2, 2));
    Vec2 on = vec2_unit(vec2_sub(b, a)); /* beyond the end of the line, over the wall: the chair drives elsewhere */
    on = on.y < 0 || (on.y == 0 && on.x < 0) ? vec2_scale(on, -1) : on;
    Vec2 end = vec2_dot(vec2_sub(b, a), on) > 0 ? b : a;
    Vec2 middle = vec2_along(end, fabs(on.x) * half.x + fabs(on.y) * half.y + CHANGE_TICK, on);
    Box tag = {vec2_sub(middle, half), vec2_add(middle, half)};
    if (!box_holds(window->frame.beside, tag.low) || !box_holds(window->frame.beside, tag.high))
        return;
    ui_draw_box(window->ui, tag, ROLE_EXIT_TAG, 1);
    ui_draw_text(window->ui, UI_BOLD, ROLE_PAPER, middle, 0.5, label);
}

/* Shows the plan with the fix right of the plan as it is; both are looked at by the same mouse. */
static void show_trial(Window *window, Tab *tab) {
    Box beside = window->frame.beside;
    Result now = tab->laboratory->answer(tab->session), then = tab->laboratory->answer(tab->trial.session);
    ui_pane_begin(window->ui,
                  &(UiPane){.name = "fix", .box = {window->frame.heads[0].low, beside.high}, .ground = ROLE_COUNT});
    show_head(window, window->frame.heads[0], "As it is", &now, now.role == ROLE_ERROR ? "no way through" : now.title);
    show_head(window, window->frame.heads[1], "With the fix", &then,
              tab->trial_layers.painted && !then.stale ? then.title : "working it out");
    ui_draw_line(window->ui, vec2(beside.low.x - 1, window->frame.heads[1].low.y),
                 vec2(beside.low.x - 1, beside.high.y), ROLE_ROOM, 2);
    UiGrab grab = ui_grab(window->ui, "fix", beside);
    if (tab->trial_layers.painted && grab.hovered) {
        Vec2 at = view_layers_floor(&tab->trial_layers, vec2_sub(grab.at, beside.low));
        Vec2 from = view_layers_floor(&tab->trial_layers, vec2_sub(vec2_sub(grab.at, grab.delta), beside.low));
        bool pans = window->input.down[SDL_WINDOW_EVENT_RIGHT] || window->input.down[SDL_WINDOW_EVENT_MIDDLE];
        if (grab.wheel != 0)
            tab_zoom(tab, pow(WHEEL_ZOOM, grab.wheel), at);
        else if (pans && (grab.delta.x != 0 || grab.delta.y != 0))
            tab_pan(tab, vec2_sub(from, at));
    }
    show_change(window, tab);
    ui_pane_end(window->ui);
}

static void show_view(Window *window, Tab *tab) {
    Box view = window->frame.view;
    ui_pane_begin(
        window->ui,
        &(UiPane){.name = "view", .box = view, .ground = ROLE_COUNT, .stop = true, .unframed = window->present});
    if (tab->session) {
        trace_image_show(window);
        use_mouse(window, tab);
        if (has_edit_button(window))
            show_edit_button(window);
        show_view_text(window, tab);
        plan_overlay_show(window);
        show_ring(window);
        show_echo(window);
    }
    ui_pane_end(window->ui);
}

/* The plots -------------------------------------------------------------------------------------------------------- */

static void show_read_out(Window *window, Tab *tab, PlotPane *pane, size_t plot, Vec2 at) {
    char text[PLOT_PANES_TEXT];
    Vec2 nearest;
    if (!plot_panes_read(pane, tab->laboratory, tab->session, plot, tab->player.time, at, false, &nearest, text))
        return;
    if (ui_extent(window->ui, UI_BODY, text).x > box_width(pane->place) - READ_OUT_MARGIN)
        plot_panes_read(pane, tab->laboratory, tab->session, plot, tab->player.time, at, true, &nearest, text);
    Vec2 extent = ui_extent(window->ui, UI_BODY, text);
    double left = fmin(fmax(nearest.x + 10, pane->place.low.x), pane->place.high.x - extent.x - 8);
    Box frame = plot_panes_frame(pane);
    bool upper = nearest.y < (frame.low.y + frame.high.y) / 2; /* in the half without the point, not over the title */
    double top = upper ? frame.high.y - extent.y - 6 : frame.low.y + 2;
    ui_draw_disc(window->ui, nearest, 4, ROLE_TEXT);
    ui_draw_box(window->ui, (Box){{left - 4, top}, {left + extent.x + 4, top + extent.y + 4}}, ROLE_PANEL, 1);
    ui_draw_text(window->ui, UI_BODY, ROLE_TEXT, vec2(left, top + extent.y / 2 + 2), 0, text);
}

/* Sets the cursor's parameter by a click and zooms about the pointer by the wheel. */
static void use_pane_mouse(Window *window, Tab *tab, PlotPane *pane, size_t plot) {
    Vec2 value;
    UiGrab grab = ui_grab(window->ui, pane->source.name, pane->place);
    if (!pane->canvas || !plot_panes_value(pane, grab.at, &value))
        return;
    if (grab.hovered && grab.wheel != 0) {
        PlotPaneAxes axes = plot_panes_axes(pane);
        double part = pow(WHEEL_ZOOM, -grab.wheel);
        plot_panes_zoom(pane, vec2_add(value, vec2(part * (axes.x[0] - value.x), part * (axes.y[0] - value.y))),
                        vec2_add(value, vec2(part * (axes.x[1] - value.x), part * (axes.y[1] - value.y))));
        return;
    }
    if (grab.pressed) {
        ui_focus(window->ui, text_in_arena(&window->arena, "plot:%s", pane->source.name));
        act_plot_use(window, pane, value);
    }
    if (grab.hovered)
        show_read_out(window, tab, pane, plot, grab.at);
}

static void show_pane(Window *window, Tab *tab, size_t index) {
    PlotPane *pane = &tab->panes.panes[index];
    Box box = window->frame.panes[index];
    ui_pane_begin(window->ui, &(UiPane){.name = text_in_arena(&window->arena, "plot:%s", pane->source.name),
                                        .box = box_expand(box, FRAME_RIM),
                                        .ground = ROLE_PAPER,
                                        .stop = true});
    size_t plot = plot_of(tab, pane);
    if (plot < tab->laboratory->plot_count(tab->session)) {
        plot_panes_show(pane, tab->laboratory, tab->session, plot, tab->player.time, box, window->unit, window->theme,
                        window->screen, window->ui);
        use_pane_mouse(window, tab, pane, plot);
    }
    ui_pane_end(window->ui);
}

void canvas_show(Window *window) {
    Tab *tab = window_tab(window);
    show_view(window, tab);
    if (tab->session && tab->trial.session)
        show_trial(window, tab);
    for (size_t i = 0; tab->session && i < window->frame.pane_count && i < tab->panes.count; i++)
        show_pane(window, tab, i);
    act_plot_explain(window);
}
