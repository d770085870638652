#include "window/charts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define NOW_RADIUS 5.0   /* design points, of the disc where a line has come to */
#define TAIL_WIDTH 3.0   /* of the last piece of a line */
#define NEAR 24.0        /* design points: farther points are not read out */
#define CURSOR_WIDTH 3.0 /* of the upright line */

/* Which plots ------------------------------------------------------------------------------------------------------ */

static void drop_canvas(Chart *chart) {
    if (chart->canvas)
        plot_canvas_destroy(chart->canvas);
    chart->canvas = NULL;
}

static void clear_chart(Chart *chart, PaintGlScreen *screen) {
    drop_canvas(chart);
    paint_gl_screen_forget(screen, &chart->texture);
    *chart = (Chart){.cursor = NAN};
}

void charts_clear(Charts *charts, PaintGlScreen *screen) {
    for (size_t i = 0; i < charts->count; i++)
        clear_chart(&charts->charts[i], screen);
    charts->count = 0;
}

/* The index of the plot with a name of so many bytes; the number of plots: there is none. */
static size_t find_plot(const LiveKind *kind, const void *live, const char *name, size_t length) {
    size_t count = kind->plot_count(live), i = 0;
    while (i < count &&
           (strlen(kind->plot(live, i).name) != length || memcmp(kind->plot(live, i).name, name, length) != 0))
        i++;
    return i;
}

/* Takes a plot's chart out of those that there were, with the axes somebody has chosen; a new one: there was none. */
static Chart take_chart(Charts *before, const LivePlot *plot) {
    for (size_t i = 0; i < before->count; i++)
        if (strcmp(before->charts[i].live.name, plot->name) == 0) {
            Chart chart = before->charts[i];
            before->charts[i] = before->charts[--before->count];
            return chart;
        }
    return (Chart){.live = *plot, .cursor = NAN};
}

void charts_choose(Charts *charts, const LiveKind *kind, void *live, const char *names, PaintGlScreen *screen) {
    Charts before = *charts;
    charts->count = 0;
    for (const char *at = names; *at && charts->count < CHARTS_MOST; at += strcspn(at, ","), at += *at == ',') {
        size_t plot = find_plot(kind, live, at, strcspn(at, ","));
        if (plot == kind->plot_count(live))
            continue;
        LivePlot shown = kind->plot(live, plot);
        charts->charts[charts->count++] = take_chart(&before, &shown);
    }
    charts_clear(&before, screen);
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

static void set_axes(Chart *chart) {
    chart->shown = *chart->live.plot;
    if (!chart->view_count)
        return;
    const ChartAxes *axes = &chart->views[chart->view_count - 1];
    chart->shown.x.low = axes->x[0];
    chart->shown.x.high = axes->x[1];
    chart->shown.y.low = axes->y[0];
    chart->shown.y.high = axes->y[1];
}

/* Takes over what the laboratory says now; a canvas for other axes, another size or another theme is made anew. */
static void refresh(Chart *chart, const LivePlot *now, int width, int height, double unit, Theme theme) {
    bool same = chart->canvas && chart->live.revision == now->revision &&
                chart->shown.series_count == now->plot->series_count && chart->width == width &&
                chart->height == height && chart->unit == unit && chart->theme == theme;
    chart->live = *now;
    set_axes(chart);
    if (same)
        return;
    drop_canvas(chart);
    chart->width = width;
    chart->height = height;
    chart->unit = unit;
    chart->theme = theme;
    chart->time = NAN;
    chart->canvas = plot_canvas_create(&chart->shown, width, height, unit, theme);
}

static PlotPixels together(PlotPixels a, PlotPixels b) {
    if (a.width <= 0 || b.width <= 0)
        return a.width > 0 ? a : b;
    int left = a.x < b.x ? a.x : b.x, top = a.y < b.y ? a.y : b.y;
    int right = a.x + a.width > b.x + b.width ? a.x + a.width : b.x + b.width;
    int bottom = a.y + a.height > b.y + b.height ? a.y + a.height : b.y + b.height;
    return (PlotPixels){left, top, right - left, bottom - top};
}

static void draw(Chart *chart, const LiveKind *kind, const void *live, size_t index, double time,
                 PaintGlScreen *screen) {
    PlotPixels changed = {0};
    if (isnan(chart->time) || (time < chart->time && !chart->live.still)) {
        plot_canvas_restart(chart->canvas);
        changed = plot_canvas_all(chart->canvas);
    }
    chart->time = time;
    for (size_t s = 0; s < chart->shown.series_count; s++)
        changed = together(changed, plot_canvas_advance(chart->canvas, s, kind->until(live, index, s, time)));
    if (changed.width > 0)
        paint_gl_screen_fill(screen, &chart->texture, plot_canvas_pixels(chart->canvas), chart->width, chart->height,
                             plot_canvas_stride(chart->canvas), changed.x, changed.y, changed.width, changed.height);
}

/* Over the picture ------------------------------------------------------------------------------------------------- */

/* Where a value is, design points of the window. */
static Vec2 place_of(const Chart *chart, Vec2 value) {
    return vec2_along(chart->place.low, 1 / chart->unit, plot_canvas_place(chart->canvas, value));
}

/* What the axes enclose, design points of the window. */
static Box frame_of(const Chart *chart) {
    Box frame = plot_canvas_frame(chart->canvas);
    return (Box){vec2_along(chart->place.low, 1 / chart->unit, frame.low),
                 vec2_along(chart->place.low, 1 / chart->unit, frame.high)};
}

static void mark_tail(const Chart *chart, const PlotSeries *series, size_t first, size_t count, Box frame, Ui *ui) {
    enum { PIECES_MOST = 512 };
    Vec2 points[PIECES_MOST];
    size_t pieces = 0, stride = (count - first) / PIECES_MOST + 1;
    for (size_t i = first; i < count; i += stride) {
        Vec2 at = place_of(chart, plot_value(series, i));
        if (isfinite(at.x) && isfinite(at.y) && box_holds(frame, at))
            points[pieces++] = at;
    }
    if (pieces > 1)
        ui_draw_polyline(ui, points, pieces, false, series->role, TAIL_WIDTH);
}

/* Where each series has come to. */
static void mark_present(const Chart *chart, const LiveKind *kind, const void *live, size_t index, double time,
                         Ui *ui) {
    Box frame = frame_of(chart);
    for (size_t s = 0; s < chart->shown.series_count && !chart->live.still; s++) {
        const PlotSeries *series = &chart->shown.series[s];
        size_t count = kind->until(live, index, s, time);
        count = count < series->count ? count : series->count;
        if (!count || series->role == ROLE_GHOST || series->width <= 0)
            continue;
        size_t first = chart->live.tail > 0 ? kind->until(live, index, s, time - chart->live.tail) : count;
        if (first < count)
            mark_tail(chart, series, first, count, frame, ui);
        Vec2 at = place_of(chart, plot_value(series, count - 1));
        if (isfinite(at.x) && isfinite(at.y) && box_holds(frame, at))
            ui_draw_disc(ui, at, NOW_RADIUS, chart->live.now == ROLE_PAPER ? series->role : chart->live.now);
    }
}

/* An upright line with words on it. */
static void draw_cursor(const Chart *chart, double x, const char *words, Ui *ui) {
    Box frame = frame_of(chart);
    double at = place_of(chart, vec2(x, plot_canvas_value(chart->canvas, vec2(0, 0)).y)).x;
    if (!(at >= frame.low.x && at <= frame.high.x))
        return;
    ui_draw_line(ui, vec2(at, frame.low.y), vec2(at, frame.high.y), ROLE_IMPACT, CURSOR_WIDTH);
    if (!words)
        return;
    Vec2 extent = ui_extent(ui, UI_BOLD, words);
    double left = fmin(fmax(at - extent.x - 12, frame.low.x), frame.high.x - extent.x - 12);
    Box tag = {{left, frame.low.y + 2}, {left + extent.x + 12, frame.low.y + extent.y + 4}};
    ui_draw_box(ui, tag, ROLE_IMPACT, 1);
    ui_draw_words(ui, UI_BOLD, ROLE_PAPER, vec2(tag.low.x + 6, (tag.low.y + tag.high.y) / 2), 0, words);
}

Vec2 charts_place(Box frame, Vec2 part) {
    return vec2(frame.low.x + part.x * box_width(frame), frame.high.y - part.y * box_height(frame));
}

static void draw_box(const Chart *chart, Ui *ui) {
    if (!chart->box.corner)
        return;
    Box frame = frame_of(chart);
    Vec2 from = charts_place(frame, chart->box.from), to = charts_place(frame, chart->box.to);
    ui_draw_disc(ui, chart->box.corner == 1 ? from : to, NOW_RADIUS, ROLE_IMPACT);
    if (chart->box.corner == 2)
        ui_draw_frame(ui, box_include(box_include(box_empty(), from), to), ROLE_IMPACT, CURSOR_WIDTH);
}

void charts_show(Chart *chart, const LiveKind *kind, const void *live, size_t index, double time, Box place,
                 double unit, Theme theme, PaintGlScreen *screen, Ui *ui) {
    LivePlot now = kind->plot(live, index);
    int width = (int)lround(box_width(place) * unit), height = (int)lround(box_height(place) * unit);
    chart->place = place;
    refresh(chart, &now, width, height, unit, theme);
    draw(chart, kind, live, index, time, screen);
    ui_image(ui, &chart->texture, place);
    mark_present(chart, kind, live, index, time, ui);
    if (!isnan(now.cursor))
        draw_cursor(chart, now.cursor, now.cursor_words, ui);
    if (!isnan(chart->cursor))
        draw_cursor(chart, chart->cursor, NULL, ui);
    draw_box(chart, ui);
}

/* Reading and zooming ---------------------------------------------------------------------------------------------- */

bool charts_value(const Chart *chart, Vec2 at, Vec2 *value) {
    if (!chart->canvas || !box_holds(frame_of(chart), at))
        return false;
    *value = plot_canvas_value(chart->canvas, vec2_scale(vec2_sub(at, chart->place.low), chart->unit));
    return true;
}

static void say_axis(char *words, size_t size, const PlotAxis *axis, double value) {
    bool pure = !axis->unit || strcmp(axis->unit, "1") == 0;
    snprintf(words, size, "%s %.6g%s%s", axis->title, value, pure ? "" : " ", pure ? "" : axis->unit);
}

bool charts_read(const Chart *chart, const LiveKind *kind, const void *live, size_t index, double time, Vec2 at,
                 Vec2 *nearest, char words[CHART_WORDS]) {
    double least = NEAR;
    Vec2 value = {0};
    if (!chart->canvas)
        return false;
    for (size_t s = 0; s < chart->shown.series_count; s++) {
        const PlotSeries *series = &chart->shown.series[s];
        size_t count = kind->until(live, index, s, time);
        for (size_t i = 0; i < count && i < series->count; i++) {
            Vec2 place = place_of(chart, plot_value(series, i));
            double apart = vec2_distance(place, at);
            if (apart >= least)
                continue;
            least = apart;
            value = plot_value(series, i);
            *nearest = place;
        }
    }
    char x[CHART_WORDS / 2], y[CHART_WORDS / 2];
    say_axis(x, sizeof x, &chart->shown.x, value.x);
    say_axis(y, sizeof y, &chart->shown.y, value.y);
    snprintf(words, CHART_WORDS, "%.*s, %.*s", CHART_WORDS / 2 - 4, x, CHART_WORDS / 2 - 4, y);
    return least < NEAR;
}

ChartAxes charts_axes(const Chart *chart) {
    Box frame = plot_canvas_frame(chart->canvas);
    Vec2 low = plot_canvas_value(chart->canvas, vec2(frame.low.x, frame.high.y));
    Vec2 high = plot_canvas_value(chart->canvas, vec2(frame.high.x, frame.low.y));
    return (ChartAxes){{low.x, high.x}, {low.y, high.y}};
}

void charts_zoom(Chart *chart, Vec2 from, Vec2 to) {
    Box box = box_include(box_include(box_empty(), from), to);
    if (!(box.low.x < box.high.x && box.low.y < box.high.y))
        return;
    if (chart->view_count == CHART_VIEWS_MOST)
        memmove(chart->views, chart->views + 1, (CHART_VIEWS_MOST - 1) * sizeof *chart->views);
    else
        chart->view_count++;
    chart->views[chart->view_count - 1] = (ChartAxes){{box.low.x, box.high.x}, {box.low.y, box.high.y}};
    drop_canvas(chart);
}

void charts_zoom_back(Chart *chart) {
    chart->view_count -= chart->view_count > 0;
    drop_canvas(chart);
}

void charts_fit(Chart *chart) {
    chart->view_count = 0;
    drop_canvas(chart);
}
