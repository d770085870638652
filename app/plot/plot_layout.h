/* Where everything of a plot is: all in design points, y down. A low plot keeps its height for the lines: its titles
 * share rows with the names of the series and with the labels of the ticks. */
#pragma once

#include "draw/layout.h"
#include "plot/plot.h"
#include "plot/plot_ticks.h"

/* A sign in the list of names, as the series has it. */
typedef struct PlotMark {
    const PlotSeries *series;
    Vec2 at;
} PlotMark;

typedef struct PlotLayout {
    Layout sheet; /* its frame is what the axes enclose; words, pieces of line, faint lines */
    PlotTicks x, y;
    PlotTicks right;  /* of the second axis for y, if there is one */
    Box key;          /* beside a raster, what its colours are shown in; empty without one */
    PlotTicks shades; /* of a raster's quantity, along the key */
    PlotMark *marks;  /* (mark_count) */
    size_t mark_count;
} PlotLayout;

/* How names of series find their place. */
typedef enum PlotNames {
    PLOT_NAMES_BESIDE, /* beside their lines if there is room for all of them, otherwise above the plot */
    PLOT_NAMES_ABOVE,  /* for lines that are yet to come */
} PlotNames;

/* Lays out a plot, which must outlive the layout, on a page of that size. plot_layout_clear releases it. */
void plot_layout_make(PlotLayout *layout, const Plot *plot, Vec2 page, PlotNames names);
void plot_layout_clear(PlotLayout *layout);
