#include "plot/plot_ground.h"

#include <cairo.h>

#include "paint/paint_cairo.h"
#include "plot/plot_frame.h"
#include "plot/plot_pen.h"
#include "plot/plot_raster.h"

/* Design points. */
#define AXIS_WIDTH 2.0
#define TICK_LENGTH 5.0

static void use_role(cairo_t *cairo, Theme theme, Role role) {
    Colour colour = palette_colour(theme, role);
    cairo_set_source_rgb(cairo, colour.red, colour.green, colour.blue);
}

static void path_segment(cairo_t *cairo, Vec2 from, Vec2 to) {
    cairo_move_to(cairo, from.x, from.y);
    cairo_line_to(cairo, to.x, to.y);
}

static void paint_axes(cairo_t *cairo, const PlotLayout *layout, Theme theme) {
    Box frame = layout->sheet.frame;
    cairo_move_to(cairo, frame.low.x, frame.low.y);
    cairo_line_to(cairo, frame.low.x, frame.high.y);
    cairo_line_to(cairo, frame.high.x, frame.high.y);
    for (int i = 0; i < layout->x.count; i++) {
        double x = plot_frame_point(layout, vec2(plot_ticks_at(&layout->x, i), 0)).x;
        path_segment(cairo, vec2(x, frame.high.y), vec2(x, frame.high.y + TICK_LENGTH));
    }
    for (int i = 0; i < layout->y.count; i++) {
        double y = plot_frame_point(layout, vec2(0, plot_ticks_at(&layout->y, i))).y;
        path_segment(cairo, vec2(frame.low.x, y), vec2(frame.low.x - TICK_LENGTH, y));
    }
    if (layout->right.count) {
        cairo_move_to(cairo, frame.high.x, frame.low.y);
        cairo_line_to(cairo, frame.high.x, frame.high.y);
    }
    for (int i = 0; i < layout->right.count; i++) {
        double part = plot_ticks_part(&layout->right, plot_ticks_at(&layout->right, i));
        double y = frame.high.y - part * box_height(frame);
        path_segment(cairo, vec2(frame.high.x, y), vec2(frame.high.x + TICK_LENGTH, y));
    }
    paint_cairo_line(cairo, LINE_SOLID, AXIS_WIDTH);
    use_role(cairo, theme, ROLE_WALL);
    cairo_stroke(cairo);
}

static void paint_band(cairo_t *cairo, const PlotLayout *layout, const PlotGuide *guide, Theme theme) {
    Box band;
    if (!guide->band || !plot_frame_band(layout, guide, &band))
        return;
    cairo_rectangle(cairo, band.low.x, band.low.y, box_width(band), box_height(band));
    use_role(cairo, theme, guide->role);
    cairo_fill(cairo);
}

/* The area has a gap where a curve has one. */
static void paint_area(cairo_t *cairo, const PlotLayout *layout, const PlotArea *area, Theme theme) {
    Box frame = layout->sheet.frame;
    cairo_save(cairo);
    cairo_rectangle(cairo, frame.low.x, frame.low.y, box_width(frame), box_height(frame));
    cairo_clip(cairo);
    for (size_t from = 0, to; from < area->count; from = to + 1) {
        cairo_new_sub_path(cairo);
        for (to = from; to < area->count && plot_frame_shows(layout, vec2(area->x[to], area->low[to])) &&
                        plot_frame_shows(layout, vec2(area->x[to], area->high[to]));
             to++) {
            Vec2 at = plot_frame_point(layout, vec2(area->x[to], area->high[to]));
            cairo_line_to(cairo, at.x, at.y);
        }
        for (size_t i = to; i-- > from;) {
            Vec2 at = plot_frame_point(layout, vec2(area->x[i], area->low[i]));
            cairo_line_to(cairo, at.x, at.y);
        }
        cairo_close_path(cairo);
    }
    use_role(cairo, theme, area->role);
    cairo_fill(cairo);
    cairo_restore(cairo);
}

static void paint_guide(cairo_t *cairo, const PlotLayout *layout, const PlotGuide *guide, Theme theme) {
    Vec2 ends[2];
    if (!plot_frame_guide(layout, guide, ends))
        return;
    path_segment(cairo, ends[0], ends[1]);
    paint_cairo_line(cairo, guide->style, PLOT_LAYOUT_GUIDE);
    use_role(cairo, theme, guide->role);
    cairo_stroke(cairo);
}

void plot_ground_paint(cairo_t *cairo, const PlotLayout *layout, const Plot *plot, Theme theme) {
    cairo_rectangle(cairo, 0, 0, layout->sheet.page.x, layout->sheet.page.y);
    use_role(cairo, theme, ROLE_PAPER);
    cairo_fill(cairo);
    for (size_t g = 0; g < plot->guide_count; g++)
        paint_band(cairo, layout, &plot->guides[g], theme);
    for (size_t a = 0; a < plot->area_count; a++)
        paint_area(cairo, layout, &plot->areas[a], theme);
    paint_cairo_grid(cairo, &layout->sheet, theme);
    if (plot->raster)
        plot_raster_paint(cairo, layout, plot, theme);
    for (size_t g = 0; g < plot->guide_count; g++)
        paint_guide(cairo, layout, &plot->guides[g], theme);
    paint_axes(cairo, layout, theme);
}

void plot_ground_paint_text(cairo_t *cairo, const PlotLayout *layout, Theme theme) {
    paint_cairo_captions(cairo, &layout->sheet, theme);
    for (size_t i = 0; i < layout->mark_count; i++)
        plot_pen_mark(cairo, layout->marks[i].series, layout->marks[i].at, theme);
}
