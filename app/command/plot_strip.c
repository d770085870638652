#include "command/plot_strip.h"

#include "command/output.h"
#include "plot/plot_write.h"

/* In design points. */
#define TAIL_WIDTH 4.0
#define TAIL_PIECE 4.0 /* least length */
#define TAIL_OVER 1.0

static int pixels(double points, double unit) {
    return (int)lround(points * unit);
}

static void give_pixels(const PlotStrip *strip, size_t plot, PlotPixels part, PaintGl *paint) {
    const PlotCanvas *canvas = strip->canvases[plot];
    PlotPixels all = plot_canvas_all(canvas);
    if (part.width > 0)
        paint_gl_panel(paint, (int)plot, plot_canvas_pixels(canvas), all.width, all.height, plot_canvas_stride(canvas),
                       part.x, part.y, part.width, part.height);
}

void plot_strip_open(PlotStrip *strip, const PlotStripSource *source, const Layout *still, PaintGl *paint,
                     const Options *options) {
    *strip = (PlotStrip){.source = *source, .still = still, .unit = layout_unit(options->width, options->height)};
    for (size_t i = 0; i < source->count; i++) {
        Box panel = still->panels[i];
        strip->canvases[i] = plot_canvas_create(&source->plots[i], pixels(box_width(panel), strip->unit),
                                                pixels(box_height(panel), strip->unit), strip->unit, options->theme);
        give_pixels(strip, i, plot_canvas_all(strip->canvases[i]), paint);
    }
}

void plot_strip_close(PlotStrip *strip) {
    for (size_t i = 0; i < strip->source.count; i++)
        plot_canvas_destroy(strip->canvases[i]);
}

/* Returns the place of a point of a series on the page. */
static Vec2 place_of(const PlotStrip *strip, size_t plot, const PlotSeries *series, size_t index) {
    Vec2 place = plot_canvas_place(strip->canvases[plot], plot_value(series, index));
    return vec2_along(strip->still->panels[plot].low, 1 / strip->unit, place);
}

/* Draws the last part of a line thick, in pieces that overlap a little since their ends are blurred. */
static void mark_tail(const PlotStrip *strip, size_t plot, const PlotSeries *series, size_t first, size_t count,
                      Layout *moving) {
    if (first >= count)
        return;
    Vec2 from = place_of(strip, plot, series, first);
    for (size_t i = first + 1; i < count; i++) {
        Vec2 to = place_of(strip, plot, series, i);
        if (vec2_distance(from, to) < TAIL_PIECE && i + 1 < count)
            continue;
        Vec2 over = vec2_along(to, TAIL_OVER, vec2_unit(vec2_sub(to, from)));
        layout_add_sample(moving, (Sample){.from = from, .to = over, .role = series->role, .width = TAIL_WIDTH});
        from = to;
    }
}

/* Draws a disc at the present value of a series. */
static void mark_present(const PlotStrip *strip, size_t plot, const PlotSeries *series, size_t count, Layout *moving) {
    Role role = strip->source.now == ROLE_PAPER ? series->role : strip->source.now;
    Vec2 at = place_of(strip, plot, series, count - 1);
    if (isfinite(at.x) && isfinite(at.y))
        layout_add_sample(moving, (Sample){.from = at, .to = at, .role = role, .symbol = SYMBOL_DISC});
}

void plot_strip_show(PlotStrip *strip, double time, PaintGl *paint, Layout *moving) {
    const PlotStripSource *source = &strip->source;
    for (size_t i = 0; i < source->count; i++) {
        const Plot *plot = &source->plots[i];
        for (size_t s = 0; s < plot->series_count; s++) {
            size_t count = source->until(source->owner, i, s, time);
            PlotPixels changed = plot_canvas_advance(strip->canvases[i], s, count);
            give_pixels(strip, i, changed, paint);
            if (!count || plot->series[s].role == ROLE_GHOST || plot->series[s].width <= 0)
                continue;
            if (source->tail > 0)
                mark_tail(strip, i, &plot->series[s], source->until(source->owner, i, s, time - source->tail), count,
                          moving);
            mark_present(strip, i, &plot->series[s], count, moving);
        }
    }
}

bool plot_strip_write(const HousePlots *plots, const char *source, const Options *options) {
    PlotSheet sheet = output_sheet(options, source);
    char path[PLOT_WRITE_PATH];
    int error = 0;
    for (size_t i = 0; i < plots->choice.count && !error; i++)
        error =
            plot_write_files(&plots->plots[i], house_plots_name(plots->choice.indices[i]), options->out, &sheet, path);
    if (error)
        output_failed(path, error);
    return !error;
}
