/* A plot as data: series of numbers over two axes as lines, marks or stems, areas between curves, a map of cells, and
 * lines and bands across that mark the meaning of a number. A plot knows arrays and roles only. plot_canvas.h draws it
 * bit by bit, plot_write.h writes it to files.
 *
 *        force, N   - A  -.- B               names of the series, when there are several and no room next to the lines
 *          |         .
 *       50 |- - - - / \- - - - warning - -   a guide, with its name
 *          |   ____/   \___ A
 *        0 +------------------
 *          0      10      20   time, s                                                                               */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "draw/palette.h"
#include "draw/scene.h"

typedef struct PlotAxis {
    const char *title;
    const char *unit; /* "1" or NULL: a pure number */
    double low, high; /* low == high: fitted to the series and guides and widened to a round number */
    bool logarithmic; /* 0 and negative values are left out */
} PlotAxis;

/* Points (x[i * stride], y[i * stride]). A point that is not finite breaks the line. */
typedef struct PlotSeries {
    const char *name;    /* or NULL: not named */
    const char *heading; /* in a table; NULL: the name */
    const double *x, *y; /* (count x stride) */
    size_t count;
    size_t stride; /* from one value to the next; 0 counts as 1 */
    Role role;
    LineStyle style;
    double width;  /* design points, of the line from point to point; 0: none */
    double ground; /* design points, on either side of the line: a strip of paper under it, over a raster; 0: none */
    Symbol symbol; /* at each point */
    double size;   /* design points, across a symbol */
    double veil;   /* opacity of one filled symbol, where many lie upon each other; 0: opaque */
    bool open;     /* symbols are outlines */
    bool stems;    /* lines from the foot of the plot up to each point instead of from point to point */
} PlotSeries;

/* A line across the whole plot, or a band. */
typedef struct PlotGuide {
    bool upright; /* at a value of x; otherwise of y */
    bool band;    /* covers `at` to `to`, which may be infinite: up to the edge of the plot */
    double at, to;
    const char *name; /* or NULL */
    bool listed;      /* a line whose name stands among those of the series, where these stand above the plot */
    Role role;
    LineStyle style;
} PlotGuide;

/* The area between two curves. */
typedef struct PlotArea {
    const char *name;             /* or NULL: not named */
    const double *x, *low, *high; /* (count) */
    size_t count;
    Role role; /* of the inside */
} PlotArea;

/* A pattern over a colour, so that classes differ without colour. */
typedef enum PlotPattern {
    PLOT_PATTERN_PLAIN,
    PLOT_PATTERN_RISING, /* thin lines */
    PLOT_PATTERN_FALLING,
    PLOT_PATTERN_CROSSED,
    PLOT_PATTERN_UPRIGHT,
    PLOT_PATTERN_LEVEL,
    PLOT_PATTERNS,
} PlotPattern;

typedef struct PlotClass {
    const char *name; /* in the legend */
    const char *mark; /* one or two characters, shown where the class has room for them; or NULL */
    Role role;
    PlotPattern pattern;
} PlotClass;

/* A map: cells that fill the box. */
typedef struct PlotRaster {
    Box box; /* values of x and y at its edges */
    size_t columns, rows;
    const double *values;     /* (rows x columns) from the lowest x and y on; NAN: an empty cell */
    const PlotClass *classes; /* (class_count) a value is an index into them; NULL: a quantity, from light to dark */
    size_t class_count;
    PlotAxis value; /* of the quantity */
} PlotRaster;

typedef struct Plot {
    const char *title;  /* or NULL: the title of the y axis replaces it */
    const char *note;   /* a caveat next to the title, or NULL */
    const char *source; /* the origin of the numbers, a line at the foot, or NULL */
    PlotAxis x, y;
    PlotSeries *series; /* (series_count) in painting order */
    PlotGuide *guides;  /* (guide_count), below the series */
    size_t series_count, guide_count;
    PlotArea *areas; /* (area_count), below everything */
    size_t area_count;
    const PlotRaster *raster; /* or NULL */
    PlotAxis right;           /* a second axis for y, which shows `right_factor` times the value */
    double right_factor;      /* 0: none */
} Plot;

static inline Vec2 plot_value(const PlotSeries *series, size_t index) {
    size_t at = index * (series->stride ? series->stride : 1);
    return vec2(series->x[at], series->y[at]);
}

struct _cairo; /* cairo's own name of cairo_t */

/* Paints the whole plot from the origin of the context, whose unit is the design point. */
void plot_paint(const Plot *plot, struct _cairo *cairo, Vec2 size, Theme theme);
