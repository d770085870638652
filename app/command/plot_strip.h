/* Plots next to a film, which grow with it, and the plots of --plots as files. */
#pragma once

#include "options/options.h"
#include "draw/layout.h"
#include "paint/paint_gl.h"
#include "plot/plot_canvas.h"
#include "visual/house/house_plots.h"

/* The plots, and a function that returns how many points of a series lie at or before a time, s. */
typedef struct PlotStripSource {
    const Plot *plots; /* (count) at most SCENE_PANELS */
    size_t count;
    double tail; /* s, length of the thick part of each line before the present; 0: none */
    Role now;    /* colour of the discs on present values; ROLE_PAPER: that of their lines */
    const void *owner;
    size_t (*until)(const void *owner, size_t plot, size_t series, double time);
} PlotStripSource;

typedef struct PlotStrip {
    PlotStripSource source;
    PlotCanvas *canvases[SCENE_PANELS]; /* (source.count) */
    const Layout *still;
    double unit; /* pixels per design point */
} PlotStrip;

/* Puts plots into the panels of a layout, both of which must outlive the strip, and gives the painter their empty axes.
 * plot_strip_close releases the strip. */
void plot_strip_open(PlotStrip *strip, const PlotStripSource *source, const Layout *still, PaintGl *paint,
                     const Options *options);
void plot_strip_close(PlotStrip *strip);

/* Continues the lines to a time that is not before the last one, gives the painter the changed pixels, and puts a disc
 * on the present value of each line. */
void plot_strip_show(PlotStrip *strip, double time, PaintGl *paint, Layout *moving);

/* Writes plot-NAME.png, .svg, .pdf and .csv to --out, with the origin of the numbers. False: an error was printed. */
bool plot_strip_write(const HousePlots *plots, const char *source, const Options *options);
