/* The plots of --plots: growing beside a film, and as files. */
#pragma once

#include "command/command.h"
#include "draw/layout.h"
#include "draw/paint_gl.h"
#include "draw/plot_canvas.h"
#include "laboratory/house_plots.h"

typedef struct PlotStrip {
    HousePlots plots;
    PlotCanvas *canvases[HOUSE_PLOTS_KNOWN]; /* (plots.choice.count) */
    const Layout *still;
    double unit; /* pixels a design point */
} PlotStrip;

/* Plots in the panels of a layout, which must outlive the strip; gives the painter their empty axes. plot_strip_close
 * releases strip and plots. */
void plot_strip_open(PlotStrip *strip, HousePlots plots, const Layout *still, PaintGl *paint, const Options *options);
void plot_strip_close(PlotStrip *strip);

/* Draws on up to a time that is not before the last one, gives the painter what is new, and puts a disc on each present
 * value. */
void plot_strip_show(PlotStrip *strip, double time, PaintGl *paint, Layout *moving);

/* Writes plot-NAME.png, .svg, .pdf and .csv to --out. False: said on standard error. */
bool plot_strip_write(const HousePlots *plots, const Options *options);
