/* Plots beside a film, growing with it; and those of --plots as files. */
#pragma once

#include "options/options.h"
#include "draw/layout.h"
#include "paint/paint_gl.h"
#include "plot/plot_canvas.h"
#include "visual/house/house_plots.h"

/* Whose plots they are, and how many points of a series lie at or before a time, s. */
typedef struct PlotStripSource {
    const Plot *plots; /* (count) at most SCENE_PANELS */
    size_t count;
    double tail; /* s, before the present: so much of each line is thick, so that the eye follows it; 0: nothing */
    Role now;    /* of the discs on present values; ROLE_PAPER: of their lines */
    const void *owner;
    size_t (*until)(const void *owner, size_t plot, size_t series, double time);
} PlotStripSource;

typedef struct PlotStrip {
    PlotStripSource source;
    PlotCanvas *canvases[SCENE_PANELS]; /* (source.count) */
    const Layout *still;
    double unit; /* pixels a design point */
} PlotStrip;

/* Plots in the panels of a layout, both of which must outlive the strip; gives the painter their empty axes.
 * plot_strip_close releases it. */
void plot_strip_open(PlotStrip *strip, const PlotStripSource *source, const Layout *still, PaintGl *paint,
                     const Options *options);
void plot_strip_close(PlotStrip *strip);

/* Draws on up to a time that is not before the last one, gives the painter what is new, and puts a disc on each present
 * value of a line. */
void plot_strip_show(PlotStrip *strip, double time, PaintGl *paint, Layout *moving);

/* Writes plot-NAME.png, .svg, .pdf and .csv to --out. False: said on standard error. */
bool plot_strip_write(const HousePlots *plots, const Options *options);
