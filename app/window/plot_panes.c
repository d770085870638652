#include "window/plot_panes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define NOW_RADIUS 5.0 /* design points, of the disc at the present end of a line */
#define TAIL_WIDTH 3.0 /* of the tail of a line */
#define PIXELS 400.0   /* about, of an axis */
#define MOST_DIGITS 6.0
#define NEAR 24.0        /* design points: farther points are not read out */
#define CURSOR_WIDTH 3.0 /* of the cursor */

/* Choice of plots -------------------------------------------------------------------------------------------------- */

static void drop_canvas(PlotPane *pane) {
    if (pane->canvas)
        plot_canvas_destroy(pane->canvas);
    pane->canvas = NULL;
}

static void clear_pane(PlotPane *pane, PaintGlScreen *screen) {
    drop_canvas(pane);
    paint_gl_screen_release(screen, &pane->texture);
    *pane = (PlotPane){.canvas = NULL};
}

void plot_panes_clear(PlotPanes *panes, PaintGlScreen *screen) {
    for (size_t i = 0; i < panes->count; i++)
        clear_pane(&panes->panes[i], screen);
    panes->count = 0;
}

/* Returns the index of the plot with a name of `length` bytes; the number of plots if there is none. */
static size_t find_plot(const Laboratory *laboratory, const void *session, const char *name, size_t length) {
    size_t count = laboratory->plot_count(session), i = 0;
    while (i < count && (strlen(laboratory->plot(session, i).name) != length ||
                         memcmp(laboratory->plot(session, i).name, name, length) != 0))
        i++;
    return i;
}

/* Returns the existing pane of a plot, with its chosen axes, or a new one. */
static PlotPane take_pane(PlotPanes *before, const LaboratoryPlot *plot) {
    for (size_t i = 0; i < before->count; i++)
        if (strcmp(before->panes[i].source.name, plot->name) == 0) {
            PlotPane pane = before->panes[i];
            before->panes[i] = before->panes[--before->count];
            return pane;
        }
    return (PlotPane){.source = *plot};
}

void plot_panes_choose(PlotPanes *panes, const Laboratory *laboratory, void *session, const char *names,
                       PaintGlScreen *screen) {
    PlotPanes before = *panes;
    panes->count = 0;
    for (const char *at = names; *at && panes->count < PLOT_PANES_MOST; at += strcspn(at, ","), at += *at == ',') {
        size_t plot = find_plot(laboratory, session, at, strcspn(at, ","));
        if (plot == laboratory->plot_count(session))
            continue;
        LaboratoryPlot shown = laboratory->plot(session, plot);
        panes->panes[panes->count++] = take_pane(&before, &shown);
    }
    plot_panes_clear(&before, screen);
}

PlotPane *plot_panes_focused(PlotPanes *panes, const Ui *ui) {
    const char *pane = ui_focus_pane(ui);
    if (strncmp(pane, "plot:", 5) != 0)
        return NULL;
    for (size_t i = 0; i < panes->count; i++)
        if (strcmp(panes->panes[i].source.name, pane + 5) == 0)
            return &panes->panes[i];
    return NULL;
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

static void set_axes(PlotPane *pane) {
    pane->shown = *pane->source.plot;
    if (!pane->view_count)
        return;
    const PlotPaneAxes *axes = &pane->views[pane->view_count - 1];
    pane->shown.x.low = axes->x[0];
    pane->shown.x.high = axes->x[1];
    pane->shown.y.low = axes->y[0];
    pane->shown.y.high = axes->y[1];
}

/* Takes over the laboratory's present plot, and rebuilds the canvas if axes, note, size or theme have changed. */
static void refresh(PlotPane *pane, const LaboratoryPlot *now, int width, int height, double unit, Theme theme) {
    char note[PLOT_PANES_TEXT];
    snprintf(note, sizeof note, "%s", now->plot->note ? now->plot->note : "");
    bool same = pane->canvas && pane->source.revision == now->revision &&
                pane->shown.series_count == now->plot->series_count && pane->width == width && pane->height == height &&
                pane->unit == unit && pane->theme == theme && strcmp(pane->note, note) == 0;
    pane->source = *now;
    set_axes(pane);
    if (same)
        return;
    drop_canvas(pane);
    pane->width = width;
    pane->height = height;
    pane->unit = unit;
    pane->theme = theme;
    pane->time = NAN;
    memcpy(pane->note, note, sizeof note);
    pane->canvas = plot_canvas_create(&pane->shown, width, height, unit, theme);
}

static PlotPixels together(PlotPixels a, PlotPixels b) {
    if (a.width <= 0 || b.width <= 0)
        return a.width > 0 ? a : b;
    int left = a.x < b.x ? a.x : b.x, top = a.y < b.y ? a.y : b.y;
    int right = a.x + a.width > b.x + b.width ? a.x + a.width : b.x + b.width;
    int bottom = a.y + a.height > b.y + b.height ? a.y + a.height : b.y + b.height;
    return (PlotPixels){left, top, right - left, bottom - top};
}

static void draw(PlotPane *pane, const Laboratory *laboratory, const void *session, size_t index, double time,
                 PaintGlScreen *screen) {
    PlotPixels changed = {0};
    if (isnan(pane->time) || (time < pane->time && !pane->source.still)) {
        plot_canvas_restart(pane->canvas);
        changed = plot_canvas_all(pane->canvas);
    }
    pane->time = time;
    for (size_t s = 0; s < pane->shown.series_count; s++)
        changed =
            together(changed, plot_canvas_advance(pane->canvas, s, laboratory->points_until(session, index, s, time)));
    if (changed.width > 0)
        paint_gl_screen_fill(screen, &pane->texture, plot_canvas_pixels(pane->canvas), pane->width, pane->height,
                             plot_canvas_stride(pane->canvas), changed.x, changed.y, changed.width, changed.height);
}

/* Overlays --------------------------------------------------------------------------------------------------------- */

/* Returns the place of a value, design points of the window. */
static Vec2 place_of(const PlotPane *pane, Vec2 value) {
    return vec2_along(pane->place.low, 1 / pane->unit, plot_canvas_place(pane->canvas, value));
}

Box plot_panes_frame(const PlotPane *pane) {
    Box frame = plot_canvas_frame(pane->canvas);
    return (Box){vec2_along(pane->place.low, 1 / pane->unit, frame.low),
                 vec2_along(pane->place.low, 1 / pane->unit, frame.high)};
}

/* Draws a part of a series as one line. */
static void mark_part(const PlotPane *pane, const PlotSeries *series, size_t first, size_t count, Role role, Ui *ui) {
    enum { PIECES_MOST = 512 };
    Vec2 points[PIECES_MOST];
    size_t pieces = 0, stride = (count - first) / PIECES_MOST + 1;
    Box frame = plot_panes_frame(pane);
    for (size_t i = first; i < count; i += stride) {
        Vec2 at = place_of(pane, plot_value(series, i));
        if (isfinite(at.x) && isfinite(at.y) && box_holds(frame, at))
            points[pieces++] = at;
    }
    if (pieces > 1)
        ui_draw_polyline(ui, points, pieces, false, role, TAIL_WIDTH);
}

/* Marks the present end of each series. */
static void mark_present(const PlotPane *pane, const Laboratory *laboratory, const void *session, size_t index,
                         double time, Ui *ui) {
    Box frame = plot_panes_frame(pane);
    for (size_t s = 0; s < pane->shown.series_count && !pane->source.still; s++) {
        const PlotSeries *series = &pane->shown.series[s];
        size_t count = laboratory->points_until(session, index, s, time);
        count = count < series->count ? count : series->count;
        if (!count || series->role == ROLE_GHOST || series->width <= 0)
            continue;
        if (pane->source.ahead)
            mark_part(pane, series, count - 1, series->count, ROLE_BAND, ui);
        size_t first =
            pane->source.tail > 0 ? laboratory->points_until(session, index, s, time - pane->source.tail) : count;
        if (first < count)
            mark_part(pane, series, first, count, series->role, ui);
        Vec2 at = place_of(pane, plot_value(series, count - 1));
        if (isfinite(at.x) && isfinite(at.y) && box_holds(frame, at))
            ui_draw_disc(ui, at, NOW_RADIUS, pane->source.now == ROLE_PAPER ? series->role : pane->source.now);
    }
}

/* Draws the cursor, a vertical line with a label. */
static void draw_cursor(const PlotPane *pane, double x, const char *text, Ui *ui) {
    Box frame = plot_panes_frame(pane);
    double at = place_of(pane, vec2(x, plot_canvas_value(pane->canvas, vec2(0, 0)).y)).x;
    if (!(at >= frame.low.x && at <= frame.high.x))
        return;
    ui_draw_line(ui, vec2(at, frame.low.y), vec2(at, frame.high.y), ROLE_IMPACT, CURSOR_WIDTH);
    if (!text)
        return;
    Vec2 extent = ui_extent(ui, UI_BOLD, text);
    double left = fmin(fmax(at - extent.x - 12, frame.low.x), frame.high.x - extent.x - 12);
    Box tag = {{left, frame.low.y + 2}, {left + extent.x + 12, frame.low.y + extent.y + 4}};
    ui_draw_box(ui, tag, ROLE_IMPACT, 1);
    ui_draw_text(ui, UI_BOLD, ROLE_PAPER, vec2(tag.low.x + 6, (tag.low.y + tag.high.y) / 2), 0, text);
}

/* Draws the cursor of y, a level line. */
static void draw_cursor_y(const PlotPane *pane, double y, Ui *ui) {
    Box frame = plot_panes_frame(pane);
    double at = place_of(pane, vec2(plot_canvas_value(pane->canvas, vec2(0, 0)).x, y)).y;
    if (at >= frame.low.y && at <= frame.high.y)
        ui_draw_line(ui, vec2(frame.low.x, at), vec2(frame.high.x, at), ROLE_IMPACT, CURSOR_WIDTH);
}

Vec2 plot_panes_place(Box frame, Vec2 part) {
    return vec2(frame.low.x + part.x * box_width(frame), frame.high.y - part.y * box_height(frame));
}

static void draw_box(const PlotPane *pane, Ui *ui) {
    if (!pane->box.corner)
        return;
    Box frame = plot_panes_frame(pane);
    Vec2 from = plot_panes_place(frame, pane->box.from), to = plot_panes_place(frame, pane->box.to);
    ui_draw_disc(ui, pane->box.corner == 1 ? from : to, NOW_RADIUS, ROLE_IMPACT);
    if (pane->box.corner == 2)
        ui_draw_frame(ui, box_include(box_include(box_empty(), from), to), ROLE_IMPACT, CURSOR_WIDTH);
}

void plot_panes_show(PlotPane *pane, const Laboratory *laboratory, const void *session, size_t index, double time,
                     Box place, double unit, Theme theme, PaintGlScreen *screen, Ui *ui) {
    LaboratoryPlot now = laboratory->plot(session, index);
    int width = (int)lround(box_width(place) * unit), height = (int)lround(box_height(place) * unit);
    pane->place = place;
    refresh(pane, &now, width, height, unit, theme);
    draw(pane, laboratory, session, index, time, screen);
    ui_image(ui, &pane->texture, place);
    mark_present(pane, laboratory, session, index, time, ui);
    if (!isnan(now.cursor))
        draw_cursor(pane, now.cursor, now.cursor_text, ui);
    if (now.cursor_y_parameter)
        draw_cursor_y(pane, now.cursor_y, ui);
    draw_box(pane, ui);
}

/* Reading and zooming ---------------------------------------------------------------------------------------------- */

bool plot_panes_value(const PlotPane *pane, Vec2 at, Vec2 *value) {
    if (!pane->canvas || !box_holds(plot_panes_frame(pane), at))
        return false;
    *value = plot_canvas_value(pane->canvas, vec2_scale(vec2_sub(at, pane->place.low), pane->unit));
    return true;
}

/* Writes a value with as many digits as a pixel of the axis can tell, behind the axis' title unless it is `brief`. */
static void format_axis(char *text, size_t size, const PlotAxis *axis, const double ends[2], double value, bool brief) {
    bool pure = !axis->unit || strcmp(axis->unit, "1") == 0;
    double step = fabs(ends[1] - ends[0]) / PIXELS;
    int digits = step > 0 ? (int)fmin(fmax(ceil(-log10(step)), 0), MOST_DIGITS) : (int)MOST_DIGITS;
    char number[48];
    if (axis->logarithmic || fabs(value) >= 1e7)
        snprintf(number, sizeof number, "%.4g", value);
    else
        snprintf(number, sizeof number, "%.*f", digits, value);
    const char *minus = *number == '-' ? "\u2212" : "";
    snprintf(text, size, "%s%s%s%s%s%s", brief ? "" : axis->title, brief ? "" : " ", minus, number + (*minus != 0),
             pure ? "" : " ", pure ? "" : axis->unit);
}

bool plot_panes_read(const PlotPane *pane, const Laboratory *laboratory, const void *session, size_t index, double time,
                     Vec2 at, bool brief, Vec2 *nearest, char text[PLOT_PANES_TEXT]) {
    double least = NEAR;
    Vec2 value = {0};
    if (!pane->canvas)
        return false;
    for (size_t s = 0; s < pane->shown.series_count; s++) {
        const PlotSeries *series = &pane->shown.series[s];
        size_t count = laboratory->points_until(session, index, s, time);
        for (size_t i = 0; i < count && i < series->count; i++) {
            Vec2 place = place_of(pane, plot_value(series, i));
            double apart = vec2_distance(place, at);
            if (apart >= least)
                continue;
            least = apart;
            value = plot_value(series, i);
            *nearest = place;
        }
    }
    char x[PLOT_PANES_TEXT / 2], y[PLOT_PANES_TEXT / 2];
    PlotPaneAxes axes = plot_panes_axes(pane);
    format_axis(x, sizeof x, &pane->shown.x, axes.x, value.x, brief);
    format_axis(y, sizeof y, &pane->shown.y, axes.y, value.y, brief);
    snprintf(text, PLOT_PANES_TEXT, "%.*s, %.*s", PLOT_PANES_TEXT / 2 - 4, x, PLOT_PANES_TEXT / 2 - 4, y);
    return least < NEAR;
}

PlotPaneAxes plot_panes_axes(const PlotPane *pane) {
    Box frame = plot_canvas_frame(pane->canvas);
    Vec2 low = plot_canvas_value(pane->canvas, vec2(frame.low.x, frame.high.y));
    Vec2 high = plot_canvas_value(pane->canvas, vec2(frame.high.x, frame.low.y));
    return (PlotPaneAxes){{low.x, high.x}, {low.y, high.y}};
}

void plot_panes_zoom(PlotPane *pane, Vec2 from, Vec2 to) {
    Box box = box_include(box_include(box_empty(), from), to);
    if (!(box.low.x < box.high.x && box.low.y < box.high.y))
        return;
    if (pane->view_count == PLOT_PANES_VIEWS_MOST)
        memmove(pane->views, pane->views + 1, (PLOT_PANES_VIEWS_MOST - 1) * sizeof *pane->views);
    else
        pane->view_count++;
    pane->views[pane->view_count - 1] = (PlotPaneAxes){{box.low.x, box.high.x}, {box.low.y, box.high.y}};
    drop_canvas(pane);
}

void plot_panes_zoom_back(PlotPane *pane) {
    pane->view_count -= pane->view_count > 0;
    drop_canvas(pane);
}

void plot_panes_fit(PlotPane *pane) {
    pane->view_count = 0;
    drop_canvas(pane);
}
