#include "draw/plot_ground.h"

#include <cairo.h>

#include "draw/paint_cairo.h"

/* Design points. */
#define AXIS_WIDTH 2.0
#define GUIDE_WIDTH 2.0
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
        double x = plot_layout_point(layout, vec2(plot_ticks_at(&layout->x, i), 0)).x;
        path_segment(cairo, vec2(x, frame.high.y), vec2(x, frame.high.y + TICK_LENGTH));
    }
    for (int i = 0; i < layout->y.count; i++) {
        double y = plot_layout_point(layout, vec2(0, plot_ticks_at(&layout->y, i))).y;
        path_segment(cairo, vec2(frame.low.x, y), vec2(frame.low.x - TICK_LENGTH, y));
    }
    paint_cairo_line(cairo, LINE_SOLID, AXIS_WIDTH);
    use_role(cairo, theme, ROLE_WALL);
    cairo_stroke(cairo);
}

static void paint_guide(cairo_t *cairo, const PlotLayout *layout, const PlotGuide *guide, Theme theme) {
    Vec2 ends[2];
    if (!plot_layout_guide(layout, guide, ends))
        return;
    path_segment(cairo, ends[0], ends[1]);
    paint_cairo_line(cairo, guide->style, GUIDE_WIDTH);
    use_role(cairo, theme, guide->role);
    cairo_stroke(cairo);
}

void plot_ground_paint(cairo_t *cairo, const PlotLayout *layout, const Plot *plot, Theme theme) {
    cairo_rectangle(cairo, 0, 0, layout->sheet.page.x, layout->sheet.page.y);
    use_role(cairo, theme, ROLE_PAPER);
    cairo_fill(cairo);
    paint_cairo_grid(cairo, &layout->sheet, theme);
    for (size_t g = 0; g < plot->guide_count; g++)
        paint_guide(cairo, layout, &plot->guides[g], theme);
    paint_axes(cairo, layout, theme);
}

void plot_ground_paint_words(cairo_t *cairo, const PlotLayout *layout, Theme theme) {
    paint_cairo_words(cairo, &layout->sheet, theme);
}
