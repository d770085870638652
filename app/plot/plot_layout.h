/* Places all parts of a plot, in design points, y down. A low plot keeps its height for the lines: its titles share
 * rows with the names of the series and with the labels of the ticks. Each tick has its label: where a title would need
 * its place, the title stands above the plot, "over time [s]"; where that would leave too little to the lines, only its
 * unit stays, "over s" or between the labels of the last two ticks. */
#pragma once

#include "draw/layout.h"
#include "plot/plot.h"
#include "plot/plot_ticks.h"

#define PLOT_LAYOUT_GUIDE 2.0 /* design points, width of a guide's line */

/* A symbol in the list of names, as in the series. */
typedef struct PlotMark {
    const PlotSeries *series;
    Vec2 at;
} PlotMark;

typedef struct PlotLayout {
    Layout sheet; /* its frame is the box that the axes enclose; texts, line samples, faint lines */
    PlotTicks x, y;
    bool across;      /* the rows above the frame name the x axis or its unit */
    PlotTicks right;  /* of the second axis for y, if there is one */
    Box key;          /* next to a raster, the box that shows its colours; empty without a raster */
    PlotTicks shades; /* of a raster's quantity, along the key */
    PlotMark *marks;  /* (mark_count) */
    size_t mark_count;
} PlotLayout;

/* Where the names of the series go. */
typedef enum PlotNames {
    PLOT_NAMES_BESIDE, /* next to their lines if there is room for all of them, otherwise above the plot */
    PLOT_NAMES_ABOVE,  /* above the plot, for lines that come later */
} PlotNames;

/* Lays out a plot, which must outlive the layout, on a page of that size. plot_layout_clear releases it. */
void plot_layout_make(PlotLayout *layout, const Plot *plot, Vec2 page, PlotNames names);
void plot_layout_clear(PlotLayout *layout);
