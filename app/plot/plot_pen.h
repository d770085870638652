/* Draws a series bit by bit, as it comes. Of the many points that a narrow strip of the page may hold one after the
 * other, the line visits the first, the least, the greatest and the last: what is drawn is the same, and no extreme is
 * lost; of symbols at the same place one is drawn. Drawn in one go or in pieces, a line is the same line, its dashes
 * too. */
#pragma once

#include "plot/plot_layout.h"

struct _cairo; /* cairo's own name of cairo_t */

/* A point of a strip that has not been drawn yet. */
typedef struct PlotHeld {
    size_t index;
    Vec2 at; /* design points */
} PlotHeld;

enum { PLOT_PEN_TAIL = 24 /* points: where a line of noise crosses itself within its width */ };

/* A point of the line that has been drawn. */
typedef struct PlotDrawn {
    Vec2 at;          /* design points */
    double travelled; /* design points, the line's length up to it: where in its dashes it is */
} PlotDrawn;

typedef struct PlotPen {
    double grain;                  /* design points, the width of a strip, and of a place for a symbol */
    size_t next;                   /* the first value that it has not seen */
    PlotDrawn tail[PLOT_PEN_TAIL]; /* (tail_count) the end of the line; none: the next point begins one */
    size_t tail_count;
    bool dot;     /* the line has one point so far */
    double strip; /* in which it ends, in grains */
    bool holds;
    PlotHeld least, greatest, last; /* not drawn yet, in the same strip */
    unsigned char *taken;           /* a bit for each place of the page: has it a symbol? NULL: none has */
} PlotPen;

/* A strip is half a pixel of the context wide. plot_pen_clear releases what drawing makes it keep. */
PlotPen plot_pen_make(struct _cairo *cairo);
void plot_pen_clear(PlotPen *pen);

/* One of the series' signs alone, not too small to be told. */
void plot_pen_mark(struct _cairo *cairo, const PlotSeries *series, Vec2 at, Theme theme);

/* Draws the first `count` points, or what has been added to them since, and all that it holds when that is the whole
 * series. The end of what was drawn is drawn again, so that within the new piece the line crosses itself as it does in
 * the whole. Returns the part of the page that may have changed, in design points. */
Box plot_pen_draw(PlotPen *pen, struct _cairo *cairo, const PlotLayout *layout, const PlotSeries *series, size_t count,
                  Theme theme);
