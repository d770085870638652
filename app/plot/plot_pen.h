/* Draws a series bit by bit as its points come. If a narrow strip of the page holds many consecutive points, the line
 * visits the first, the least, the greatest and the last: the drawing is the same, and no extreme is lost; of symbols
 * at the same place one is drawn. A line drawn in pieces is the same as a line drawn at once, including its dashes. */
#pragma once

#include "plot/plot_layout.h"

struct _cairo; /* cairo's own name of cairo_t */

/* A point of a strip that has not been drawn yet. */
typedef struct PlotHeld {
    size_t index;
    Vec2 at; /* design points */
} PlotHeld;

enum { PLOT_PEN_TAIL = 24 /* points: where a line of noise crosses itself within its width */ };

/* A point of the line that is drawn already. */
typedef struct PlotDrawn {
    Vec2 at;          /* design points */
    double travelled; /* design points, the length of the line up to it: its phase in the dashes */
} PlotDrawn;

typedef struct PlotPen {
    double grain;                  /* design points, the width of a strip, and of a symbol's place */
    size_t next;                   /* the first value that was not visited yet */
    PlotDrawn tail[PLOT_PEN_TAIL]; /* (tail_count) the end of the line; none: the next point begins one */
    size_t tail_count;
    bool dot;     /* the line has only one point so far */
    double strip; /* that holds the end of the line, in grains */
    bool holds;
    PlotHeld least, greatest, last; /* not drawn yet, in the same strip */
    unsigned char *taken;           /* a bit for each place of the page, set if it has a symbol; NULL: none has */
} PlotPen;

/* Makes a pen with strips half a pixel of the context wide. plot_pen_clear releases the memory that drawing allocates.
 */
PlotPen plot_pen_make(struct _cairo *cairo);
void plot_pen_clear(PlotPen *pen);

/* Draws a single symbol of the series, large enough to be recognised. */
void plot_pen_mark(struct _cairo *cairo, const PlotSeries *series, Vec2 at, Theme theme);

/* Draws the first `count` points, or those added since the last call, and the held points if that completes the
 * series. The end of the earlier line is drawn again, so that the line crosses itself within the new piece as it does
 * in the whole. Returns the part of the page that may have changed, in design points. */
Box plot_pen_draw(PlotPen *pen, struct _cairo *cairo, const PlotLayout *layout, const PlotSeries *series, size_t count,
                  Theme theme);
