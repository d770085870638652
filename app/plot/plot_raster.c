#include "plot/plot_raster.h"

#include <cairo.h>

#include "paint/paint_cairo.h"
#include "plot/plot_frame.h"
#include "plot/plot_key.h"

/* Design points. */
#define PATTERN_GAP 8.0
#define PATTERN_WIDTH 1.0
#define EDGE_WIDTH 1.0 /* around the colours of the key */

#define PATTERN_OPACITY 0.55

enum { SHADES = 64 /* levels of a quantity: finer than the eye distinguishes, few enough for a small file */ };

static void use_colour(cairo_t *cairo, Colour colour) {
    cairo_set_source_rgb(cairo, colour.red, colour.green, colour.blue);
}

/* Adds a cell corner by corner: a rounded width would leave seams between neighbours. */
static void path_box(cairo_t *cairo, Box box) {
    cairo_move_to(cairo, box.low.x, box.low.y);
    cairo_line_to(cairo, box.high.x, box.low.y);
    cairo_line_to(cairo, box.high.x, box.high.y);
    cairo_line_to(cairo, box.low.x, box.high.y);
    cairo_close_path(cairo);
}

/* Returns the class of a cell, or the level of its quantity; -1 if the cell is empty. */
static int cell_level(const PlotLayout *layout, const PlotRaster *raster, double value) {
    if (raster->classes)
        return value >= 0 && value < (double)raster->class_count ? (int)value : -1;
    double part = plot_ticks_part(&layout->shades, value);
    return isfinite(part) ? (int)real_clamp(part * SHADES, 0, SHADES - 1) : -1;
}

/* Returns the box of the cells of a row from column `from` up to `to`. */
static Box cells_box(const PlotLayout *layout, const PlotRaster *raster, size_t row, size_t from, size_t to) {
    Vec2 low = raster->box.low;
    double width = box_width(raster->box) / (double)raster->columns;
    double height = box_height(raster->box) / (double)raster->rows;
    Vec2 first = plot_frame_point(layout, vec2(low.x + width * (double)from, low.y + height * (double)row));
    Vec2 last = plot_frame_point(layout, vec2(low.x + width * (double)to, low.y + height * (double)(row + 1)));
    return (Box){{first.x, last.y}, {last.x, first.y}};
}

/* Makes a path of all cells of a level; neighbours in a row are one piece. */
static void path_level(cairo_t *cairo, const PlotLayout *layout, const PlotRaster *raster, int level) {
    for (size_t row = 0; row < raster->rows; row++) {
        const double *values = raster->values + row * raster->columns;
        for (size_t from = 0, to; from < raster->columns; from = to) {
            int found = cell_level(layout, raster, values[from]);
            for (to = from + 1; to < raster->columns && cell_level(layout, raster, values[to]) == found;)
                to++;
            if (found == level)
                path_box(cairo, cells_box(layout, raster, row, from, to));
        }
    }
}

static void path_slanted(cairo_t *cairo, Box box, int way) {
    double height = box_height(box);
    double first = PATTERN_GAP * floor((box.low.x - height) / PATTERN_GAP);
    for (double x = first; x < box.high.x + height; x += PATTERN_GAP) {
        cairo_move_to(cairo, x, way > 0 ? box.high.y : box.low.y);
        cairo_line_to(cairo, x + height, way > 0 ? box.low.y : box.high.y);
    }
}

static void path_straight(cairo_t *cairo, Box box, bool upright) {
    double from = upright ? box.low.x : box.low.y, to = upright ? box.high.x : box.high.y;
    for (double at = from + PATTERN_GAP / 2; at < to; at += PATTERN_GAP) {
        cairo_move_to(cairo, upright ? at : box.low.x, upright ? box.low.y : at);
        cairo_line_to(cairo, upright ? at : box.high.x, upright ? box.high.y : at);
    }
}

static void path_pattern(cairo_t *cairo, Box box, PlotPattern pattern) {
    if (pattern == PLOT_PATTERN_RISING || pattern == PLOT_PATTERN_CROSSED)
        path_slanted(cairo, box, 1);
    if (pattern == PLOT_PATTERN_FALLING || pattern == PLOT_PATTERN_CROSSED)
        path_slanted(cairo, box, -1);
    if (pattern == PLOT_PATTERN_UPRIGHT || pattern == PLOT_PATTERN_LEVEL)
        path_straight(cairo, box, pattern == PLOT_PATTERN_UPRIGHT);
}

/* Fills the path with the colour and pattern of a class, and clears the path. */
static void fill_class(cairo_t *cairo, const PlotClass *filled, Box box, Theme theme) {
    Colour ground = palette_colour(theme, filled->role), ink = palette_ink_on(ground);
    cairo_save(cairo);
    use_colour(cairo, ground);
    cairo_fill_preserve(cairo);
    cairo_clip(cairo);
    if (filled->pattern != PLOT_PATTERN_PLAIN) {
        path_pattern(cairo, box, filled->pattern);
        paint_cairo_line(cairo, LINE_SOLID, PATTERN_WIDTH);
        cairo_set_source_rgba(cairo, ink.red, ink.green, ink.blue, PATTERN_OPACITY);
        cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
        cairo_stroke(cairo);
    }
    cairo_restore(cairo);
}

static void paint_cells(cairo_t *cairo, const PlotLayout *layout, const PlotRaster *raster, Theme theme) {
    Box frame = layout->sheet.frame;
    int levels = raster->classes ? (int)raster->class_count : SHADES;
    cairo_save(cairo);
    path_box(cairo, frame);
    cairo_clip(cairo);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE); /* avoids seams between cells */
    for (int level = 0; level < levels; level++) {
        path_level(cairo, layout, raster, level);
        if (raster->classes) {
            fill_class(cairo, &raster->classes[level], frame, theme);
        } else {
            use_colour(cairo, palette_shade(theme, (level + 0.5) / SHADES));
            cairo_fill(cairo);
        }
    }
    cairo_restore(cairo);
}

static void paint_edge(cairo_t *cairo, Box box, Theme theme) {
    path_box(cairo, box);
    paint_cairo_line(cairo, LINE_SOLID, EDGE_WIDTH);
    use_colour(cairo, palette_colour(theme, ROLE_ROOM));
    cairo_stroke(cairo);
}

static void paint_key(cairo_t *cairo, const PlotLayout *layout, const Plot *plot, Theme theme) {
    const PlotRaster *raster = plot->raster;
    for (size_t c = 0; c < raster->class_count; c++) {
        Box box = plot_key_class(layout, plot, c);
        path_box(cairo, box);
        fill_class(cairo, &raster->classes[c], box, theme);
        paint_edge(cairo, box, theme);
    }
    Box key = layout->key;
    double step = box_height(key) / SHADES;
    for (int level = 0; !raster->classes && level < SHADES; level++) {
        cairo_rectangle(cairo, key.low.x, key.high.y - (level + 1) * step, box_width(key), level ? step + 0.5 : step);
        use_colour(cairo, palette_shade(theme, (level + 0.5) / SHADES));
        cairo_fill(cairo);
    }
    if (!raster->classes)
        paint_edge(cairo, key, theme);
}

void plot_raster_paint(cairo_t *cairo, const PlotLayout *layout, const Plot *plot, Theme theme) {
    paint_cells(cairo, layout, plot->raster, theme);
    paint_key(cairo, layout, plot, theme);
}
