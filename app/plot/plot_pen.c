#include "plot/plot_pen.h"

#include <cairo.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "paint/paint_cairo.h"
#include "paint/paint_sizes.h"
#include "plot/plot_frame.h"

#define GRAIN 0.5 /* pixels */
#define EDGE 1.0  /* design points, of blur around a line */

/* Design points. */
#define OPEN_WIDTH 2.0 /* of a symbol's outline */
#define MARK_LEAST 6.0 /* across a symbol that stands alone */

enum { VEILS = 8 /* shades of symbols that shine through */ };

enum { PIECE = 512 /* points per path: cairo is slow on strokes of many points that cross each other */ };

/* The path that is drawn at once. */
typedef struct Piece {
    PlotPen *pen;
    cairo_t *cairo;
    const PlotSeries *series;
    double begin; /* design points, length of the line up to the begin of the path */
    size_t points;
    bool first; /* nothing has been drawn yet */
    Box box;    /* design points */
} Piece;

PlotPen plot_pen_make(cairo_t *cairo) {
    double grain = GRAIN, across = 0;
    cairo_device_to_user_distance(cairo, &grain, &across);
    return (PlotPen){.grain = grain};
}

void plot_pen_clear(PlotPen *pen) {
    memory_free(pen->taken);
    pen->taken = NULL;
}

/* Sets dashes with round ends, as long as flat ones: a piece that begins within a dash joins the previous piece
 * without a gap. */
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
        piece->first = false;
        double dashes[4], offset;
        cairo_get_dash(piece->cairo, dashes, &offset);
        cairo_set_dash(piece->cairo, dashes, cairo_get_dash_count(piece->cairo), piece->begin);
        cairo_stroke(piece->cairo);
    }
    piece->points = 0;
}

static void begin_at(Piece *piece, size_t first) {
    const PlotPen *pen = piece->pen;
    piece->begin = pen->tail[first].travelled;
    for (size_t i = first; i < pen->tail_count; i++) {
        cairo_line_to(piece->cairo, pen->tail[i].at.x, pen->tail[i].at.y);
        piece->box = box_include(piece->box, pen->tail[i].at);
    }
}

static void remember(PlotPen *pen, Vec2 at) {
    PlotDrawn drawn = {.at = at};
    if (pen->tail_count) {
        PlotDrawn last = pen->tail[pen->tail_count - 1];
        drawn.travelled = last.travelled + vec2_distance(last.at, at);
    }
    if (pen->tail_count == PLOT_PEN_TAIL)
        memmove(pen->tail, pen->tail + 1, --pen->tail_count * sizeof *pen->tail);
    pen->tail[pen->tail_count++] = drawn;
}

static void draw_to(Piece *piece, Vec2 to) {
    PlotPen *pen = piece->pen;
    pen->dot = !pen->tail_count;
    if (pen->dot)
        piece->begin = 0;
    else if (!piece->points)
        begin_at(piece, piece->first ? 0 : pen->tail_count - 1);
    remember(pen, to);
    cairo_line_to(piece->cairo, to.x, to.y);
    piece->box = box_include(piece->box, to);
    if (++piece->points == PIECE)
        stroke(piece);
}

/* Visits the held points of the pen in the order in which they came. */
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

/* Draws a line of one point as a dot. */
static void draw_dot(Piece *piece) {
    if (piece->pen->dot && piece->pen->tail_count)
        draw_to(piece, piece->pen->tail[0].at);
}

static void lift(Piece *piece) {
    draw_held(piece);
    draw_dot(piece);
    stroke(piece);
    piece->pen->tail_count = 0;
}

static void draw_line(Piece *piece, const PlotLayout *layout, size_t count) {
    PlotPen *pen = piece->pen;
    use_line(piece->cairo, piece->series);
    for (size_t i = pen->next; i < count; i++) {
        Vec2 value = plot_value(piece->series, i);
        if (!plot_frame_shows(layout, value)) {
            lift(piece);
            continue;
        }
        Vec2 at = plot_frame_point(layout, value);
        double strip = floor(at.x / pen->grain);
        if (pen->tail_count && strip == pen->strip) {
            hold(pen, (PlotHeld){i, at});
            continue;
        }
        draw_held(piece);
        draw_to(piece, at);
        pen->strip = strip;
    }
    if (count == piece->series->count) {
        draw_held(piece);
        draw_dot(piece);
    }
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
    case SYMBOL_TRIANGLE: {
        Vec2 corners[3];
        paint_triangle_corners(at, half, corners);
        cairo_move_to(cairo, corners[0].x, corners[0].y);
        for (int i = 1; i < 3; i++)
            cairo_line_to(cairo, corners[i].x, corners[i].y);
        cairo_close_path(cairo);
        break;
    }
    case SYMBOL_NONE:
    case SYMBOLS:
        break;
    }
}

/* Returns the place of a symbol among the grains of the frame, or SIZE_MAX outside it. `*places`: their number. */
static size_t find_place(const PlotPen *pen, const Layout *sheet, Vec2 at, double size, size_t *places) {
    Box frame = box_expand(sheet->frame, size);
    Vec2 extent = vec2_sub(frame.high, frame.low);
    size_t columns = (size_t)(extent.x / pen->grain) + 1, rows = (size_t)(extent.y / pen->grain) + 1;
    *places = columns * rows;
    if (!(at.x > frame.low.x && at.x < frame.high.x && at.y > frame.low.y && at.y < frame.high.y))
        return SIZE_MAX;
    size_t column = (size_t)((at.x - frame.low.x) / pen->grain), row = (size_t)((at.y - frame.low.y) / pen->grain);
    return row * columns + column;
}

/* Reserves a place for a symbol; false if the place is taken or outside the frame. */
static bool claim_place(PlotPen *pen, const Layout *sheet, Vec2 at, double size) {
    size_t places, place = find_place(pen, sheet, at, size, &places);
    if (place == SIZE_MAX)
        return false;
    if (!pen->taken)
        pen->taken = memory_zeroed(places / 8 + 1, 1);
    unsigned char bit = (unsigned char)(1 << place % 8);
    bool free = !(pen->taken[place / 8] & bit);
    pen->taken[place / 8] |= bit;
    return free;
}

/* Paints the path of the symbols, filled or as outlines. */
static void finish_symbols(cairo_t *cairo, const PlotSeries *series) {
    if (series->open) {
        paint_cairo_line(cairo, LINE_SOLID, OPEN_WIDTH);
        cairo_stroke(cairo);
    } else {
        cairo_fill(cairo);
    }
}

static void draw_symbols(Piece *piece, const PlotLayout *layout, size_t count) {
    cairo_set_fill_rule(piece->cairo, CAIRO_FILL_RULE_WINDING);
    for (size_t i = piece->pen->next; i < count; i++) {
        Vec2 value = plot_value(piece->series, i);
        if (!plot_frame_shows(layout, value))
            continue;
        Vec2 at = plot_frame_point(layout, value);
        if (!claim_place(piece->pen, &layout->sheet, at, piece->series->size))
            continue;
        path_symbol(piece->cairo, piece->series->symbol, at, piece->series->size / 2);
        piece->box = box_include(piece->box, at);
    }
    finish_symbols(piece->cairo, piece->series);
}

/* Returns which of the VEILS shades, 0 the faintest, so many symbols upon each other have. */
static int find_veil(double veil, unsigned count) {
    double opacity = 1 - pow(1 - veil, count);
    int shade = (int)(opacity * VEILS);
    return shade < VEILS ? shade : VEILS - 1;
}

/* Draws symbols that shine through, each place once, as opaque as its symbols upon each other. Symbols beside each
 * other of one shade do not add up. */
static void draw_veiled(Piece *piece, const PlotLayout *layout, size_t count, Colour colour) {
    const PlotSeries *series = piece->series;
    size_t first = piece->pen->next, places = 0;
    find_place(piece->pen, &layout->sheet, vec2(0, 0), series->size, &places);
    unsigned short *upon = memory_zeroed(places + 1, sizeof *upon);
    cairo_set_fill_rule(piece->cairo, CAIRO_FILL_RULE_WINDING);
    for (int shade = -1; shade < VEILS; shade++) { /* counts them first */
        for (size_t i = first; i < count; i++) {
            Vec2 value = plot_value(series, i);
            if (!plot_frame_shows(layout, value))
                continue;
            Vec2 at = plot_frame_point(layout, value);
            size_t place = find_place(piece->pen, &layout->sheet, at, series->size, &places);
            if (place == SIZE_MAX)
                continue;
            if (shade < 0) {
                upon[place] = (unsigned short)(upon[place] + (upon[place] < USHRT_MAX));
            } else if (upon[place] && find_veil(series->veil, upon[place]) == shade) {
                upon[place] = 0;
                path_symbol(piece->cairo, series->symbol, at, series->size / 2);
                piece->box = box_include(piece->box, at);
            }
        }
        cairo_set_source_rgba(piece->cairo, colour.red, colour.green, colour.blue, (shade + 1.0) / VEILS);
        cairo_fill(piece->cairo);
    }
    memory_free(upon);
}

static void draw_stems(Piece *piece, const PlotLayout *layout, size_t count) {
    paint_cairo_line(piece->cairo, piece->series->style, piece->series->width);
    double foot = layout->sheet.frame.high.y;
    for (size_t i = piece->pen->next; i < count; i++) {
        Vec2 value = plot_value(piece->series, i);
        if (!plot_frame_shows(layout, value))
            continue;
        Vec2 at = plot_frame_point(layout, value);
        cairo_move_to(piece->cairo, at.x, foot);
        cairo_line_to(piece->cairo, at.x, at.y);
        piece->box = box_include(box_include(piece->box, at), vec2(at.x, foot));
    }
    cairo_stroke(piece->cairo);
}

/* Draws a strip of paper where the line will be. */
static void draw_ground(const Piece *piece, const PlotLayout *layout, size_t count, Theme theme) {
    PlotPen pen = *piece->pen;
    PlotSeries wide = *piece->series;
    Piece strip = *piece;
    Colour paper = palette_colour(theme, ROLE_PAPER);
    wide.width += 2 * wide.ground;
    wide.style = LINE_SOLID;
    strip.pen = &pen;
    strip.series = &wide;
    cairo_save(piece->cairo);
    cairo_set_source_rgb(piece->cairo, paper.red, paper.green, paper.blue);
    draw_line(&strip, layout, count);
    cairo_restore(piece->cairo);
}

void plot_pen_mark(cairo_t *cairo, const PlotSeries *series, Vec2 at, Theme theme) {
    Colour colour = palette_colour(theme, series->role);
    cairo_set_source_rgb(cairo, colour.red, colour.green, colour.blue);
    path_symbol(cairo, series->symbol, at, fmax(series->size, MARK_LEAST) / 2);
    finish_symbols(cairo, series);
}

Box plot_pen_draw(PlotPen *pen, cairo_t *cairo, const PlotLayout *layout, const PlotSeries *series, size_t count,
                  Theme theme) {
    Piece piece = {.pen = pen, .cairo = cairo, .series = series, .first = true, .box = box_empty()};
    double reach = fmax(series->width + 2 * series->ground, series->size + (series->open ? OPEN_WIDTH : 0)) / 2;
    Box frame = box_expand(layout->sheet.frame, reach);
    Colour colour = palette_colour(theme, series->role);
    cairo_save(cairo);
    cairo_rectangle(cairo, frame.low.x, frame.low.y, box_width(frame), box_height(frame));
    cairo_clip(cairo);
    cairo_set_source_rgb(cairo, colour.red, colour.green, colour.blue);
    if (series->width > 0 && series->ground > 0)
        draw_ground(&piece, layout, count, theme);
    if (series->width > 0 && series->stems)
        draw_stems(&piece, layout, count);
    else if (series->width > 0)
        draw_line(&piece, layout, count);
    if (series->symbol != SYMBOL_NONE && series->veil > 0)
        draw_veiled(&piece, layout, count, colour);
    else if (series->symbol != SYMBOL_NONE)
        draw_symbols(&piece, layout, count);
    cairo_restore(cairo);
    pen->next = count > pen->next ? count : pen->next;
    return box_expand(piece.box, reach + EDGE);
}
