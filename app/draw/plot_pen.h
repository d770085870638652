/* Draws a series bit by bit, as it comes. Of the many points that a narrow strip of the page may hold one after the
 * other, the line visits the first, the least, the greatest and the last: what is drawn is the same, and no extreme is
 * lost. Drawn in one go or in pieces, a line is the same line, its dashes too. */
#pragma once

#include "draw/plot_layout.h"

struct _cairo; /* cairo's own name of cairo_t */

/* A point of a strip that has not been drawn yet. */
typedef struct PlotHeld {
    size_t index;
    Vec2 at; /* design points */
} PlotHeld;

typedef struct PlotPen {
    double grain;     /* design points, the width of a strip */
    size_t next;      /* the first value that it has not seen */
    bool down;        /* there is a line to go on from */
    bool dot;         /* of one point so far */
    Vec2 at;          /* design points, where the line ends */
    double travelled; /* design points, its length so far: where in its dashes it is */
    double strip;     /* in which it ends, in grains */
    bool holds;
    PlotHeld least, greatest, last; /* behind `at`, in the same strip */
} PlotPen;

/* A strip is half a pixel of the context wide. */
PlotPen plot_pen_make(struct _cairo *cairo);

/* Draws the first `count` points, or what has been added to them since, and all that it holds when that is the whole
 * series. Returns the part of the page that may have changed, in design points. */
Box plot_pen_draw(PlotPen *pen, struct _cairo *cairo, const PlotLayout *layout, const PlotSeries *series, size_t count,
                  Theme theme);
