#include "draw/plot_pen.h"

#include <cairo.h>

#include "draw/paint_cairo.h"

#define GRAIN 0.5 /* pixels */
#define EDGE 1.0  /* design points, of blur around a line */

enum { PIECE = 512 /* points a path: strokes of many points that cross each other take cairo long */ };

/* What is drawn at once. */
typedef struct Piece {
    PlotPen *pen;
    cairo_t *cairo;
    const PlotSeries *series;
    double begin; /* design points, of the line where the path begins */
    size_t points;
    Box box; /* design points */
} Piece;

PlotPen plot_pen_make(cairo_t *cairo) {
    double grain = GRAIN, across = 0;
    cairo_device_to_user_distance(cairo, &grain, &across);
    return (PlotPen){.grain = grain};
}

/* Dashes with round ends, as long as flat ones: a piece that begins within a dash joins the last one without a gap. */
static void use_line(cairo_t *cairo, const PlotSeries *series) {
    paint_cairo_line(cairo, series->style, series->width);
    if (series->style == LINE_DASHED) {
        double dashes[4], offset;
        cairo_get_dash(cairo, dashes, &offset);
        for (int i = 0; i < 4; i++)
            dashes[i] += i % 2 ? series->width : -series->width;
        cairo_set_dash(cairo, dashes, 4, offset);
    }
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
}

static void stroke(Piece *piece) {
    if (piece->points) {
        double dashes[4], offset;
        cairo_get_dash(piece->cairo, dashes, &offset);
        cairo_set_dash(piece->cairo, dashes, cairo_get_dash_count(piece->cairo), piece->begin);
        cairo_stroke(piece->cairo);
    }
    piece->points = 0;
}

static void draw_to(Piece *piece, Vec2 to) {
    PlotPen *pen = piece->pen;
    if (!piece->points) {
        Vec2 from = pen->down ? pen->at : to;
        cairo_move_to(piece->cairo, from.x, from.y);
        piece->begin = pen->travelled;
        piece->box = box_include(piece->box, from);
    }
    if (pen->down) {
        cairo_line_to(piece->cairo, to.x, to.y);
        pen->travelled += vec2_distance(pen->at, to);
    }
    piece->box = box_include(piece->box, to);
    pen->dot = !pen->down;
    pen->down = true;
    pen->at = to;
    if (++piece->points == PIECE)
        stroke(piece);
}

/* Visits what the pen holds in the order in which it came. */
static void draw_held(Piece *piece) {
    PlotPen *pen = piece->pen;
    if (!pen->holds)
        return;
    bool falling = pen->greatest.index < pen->least.index;
    PlotHeld first = falling ? pen->greatest : pen->least, second = falling ? pen->least : pen->greatest;
    draw_to(piece, first.at);
    if (second.index != first.index)
        draw_to(piece, second.at);
    if (pen->last.index != second.index)
        draw_to(piece, pen->last.at);
    pen->holds = false;
}

static void hold(PlotPen *pen, PlotHeld point) {
    if (!pen->holds || point.at.y < pen->least.at.y)
        pen->least = point;
    if (!pen->holds || point.at.y > pen->greatest.at.y)
        pen->greatest = point;
    pen->last = point;
    pen->holds = true;
}

/* A line of one point is a dot. */
static void lift(Piece *piece) {
    draw_held(piece);
    if (piece->pen->dot)
        draw_to(piece, piece->pen->at);
    stroke(piece);
    piece->pen->down = piece->pen->dot = false;
    piece->pen->travelled = 0;
}

static void draw_line(Piece *piece, const PlotLayout *layout, size_t count) {
    PlotPen *pen = piece->pen;
    use_line(piece->cairo, piece->series);
    for (size_t i = pen->next; i < count; i++) {
        Vec2 value = plot_value(piece->series, i);
        if (!isfinite(value.x) || !isfinite(value.y)) {
            lift(piece);
            continue;
        }
        Vec2 at = plot_layout_point(layout, value);
        double strip = floor(at.x / pen->grain);
        if (pen->down && strip == pen->strip) {
            hold(pen, (PlotHeld){i, at});
            continue;
        }
        draw_held(piece);
        draw_to(piece, at);
        pen->strip = strip;
    }
    if (count == piece->series->count)
        draw_held(piece);
    if (pen->dot && count == piece->series->count)
        draw_to(piece, pen->at);
    stroke(piece);
}

static void path_symbol(cairo_t *cairo, Symbol symbol, Vec2 at, double half) {
    switch (symbol) {
    case SYMBOL_DISC:
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, at.x, at.y, half, 0, 2 * M_PI);
        break;
    case SYMBOL_DIAMOND:
        cairo_move_to(cairo, at.x - half, at.y);
        cairo_line_to(cairo, at.x, at.y - half);
        cairo_line_to(cairo, at.x + half, at.y);
        cairo_line_to(cairo, at.x, at.y + half);
        cairo_close_path(cairo);
        break;
    case SYMBOL_BOX:
        cairo_rectangle(cairo, at.x - half, at.y - half, 2 * half, 2 * half);
        break;
    case SYMBOL_NONE:
        break;
    }
}

static void draw_symbols(Piece *piece, const PlotLayout *layout, size_t count) {
    cairo_set_fill_rule(piece->cairo, CAIRO_FILL_RULE_WINDING);
    for (size_t i = piece->pen->next; i < count; i++) {
        Vec2 value = plot_value(piece->series, i);
        if (!isfinite(value.x) || !isfinite(value.y))
            continue;
        Vec2 at = plot_layout_point(layout, value);
        path_symbol(piece->cairo, piece->series->symbol, at, piece->series->size / 2);
        piece->box = box_include(piece->box, at);
    }
    cairo_fill(piece->cairo);
}

Box plot_pen_draw(PlotPen *pen, cairo_t *cairo, const PlotLayout *layout, const PlotSeries *series, size_t count,
                  Theme theme) {
    Piece piece = {.pen = pen, .cairo = cairo, .series = series, .box = box_empty()};
    Box frame = box_expand(layout->sheet.frame, series->width / 2);
    Colour colour = palette_colour(theme, series->role);
    cairo_save(cairo);
    cairo_rectangle(cairo, frame.low.x, frame.low.y, frame.high.x - frame.low.x, frame.high.y - frame.low.y);
    cairo_clip(cairo);
    cairo_set_source_rgb(cairo, colour.red, colour.green, colour.blue);
    if (series->width > 0)
        draw_line(&piece, layout, count);
    if (series->symbol != SYMBOL_NONE)
        draw_symbols(&piece, layout, count);
    cairo_restore(cairo);
    pen->next = count > pen->next ? count : pen->next;
    return box_expand(piece.box, fmax(series->width, series->size) / 2 + EDGE);
}
