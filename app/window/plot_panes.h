/* The plots beside the view: drawn bit by bit into pictures, with the present marked on them, a cursor that sets a
 * number, a read-out of the nearest point, and axes that can be zoomed. Axes that somebody has chosen stay until they
 * are let go. */
#pragma once

#include "paint/paint_gl_screen.h"
#include "plot/plot_canvas.h"
#include "laboratory/laboratory.h"
#include "widgets/ui.h"

enum { PLOT_PANES_MOST = 8, PLOT_PANES_VIEWS_MOST = 16, PLOT_PANES_TEXT = 160 };

/* What of the axes is shown. */
typedef struct PlotPaneAxes {
    double x[2], y[2];
} PlotPaneAxes;

/* A box that is being chosen by keys: a corner, then the other. */
typedef struct PlotPaneBox {
    int corner;    /* 0: none is chosen, 1: the first moves, 2: the other */
    Vec2 from, to; /* 0 to 1 of the axes */
} PlotPaneBox;

typedef struct PlotPane {
    LaboratoryPlot live;
    Plot shown; /* live.plot with the axes that are shown */
    PlotCanvas *canvas;
    ScreenTexture texture;
    int width, height;
    double unit;
    Theme theme;
    double time;                               /* s, drawn last */
    PlotPaneAxes views[PLOT_PANES_VIEWS_MOST]; /* (view_count) the last is shown; none: the plot's own */
    size_t view_count;
    PlotPaneBox box;
    double cursor; /* x, moved by keys and not yet used; NAN: none */
    Box place;     /* design points of the window */
} PlotPane;

typedef struct PlotPanes {
    PlotPane panes[PLOT_PANES_MOST]; /* (count) */
    size_t count;
} PlotPanes;

/* Makes the charts those of the laboratory's plots that are named, in that order, separated by commas. What was drawn
 * of one that stays, and its axes, stay. */
void plot_panes_choose(PlotPanes *panes, const Laboratory *kind, void *live, const char *names, PaintGlScreen *screen);
void plot_panes_clear(PlotPanes *panes, PaintGlScreen *screen);

/* Returns the plot that has the focus; NULL: none has. */
PlotPane *plot_panes_focused(PlotPanes *panes, const Ui *ui);

/* Draws a chart in its place, design points, of which `unit` pixels are one. */
void plot_panes_show(PlotPane *pane, const Laboratory *kind, const void *live, size_t index, double time, Box place,
                     double unit, Theme theme, PaintGlScreen *screen, Ui *ui);

/* The values at a point of the window; false: outside of the axes. */
bool plot_panes_value(const PlotPane *pane, Vec2 at, Vec2 *value);

/* "x 0.12 mm, y 0.3 m/s" of the point of a series that is nearest to a point of the window; false: none is near. */
bool plot_panes_read(const PlotPane *pane, const Laboratory *kind, const void *live, size_t index, double time, Vec2 at,
                     Vec2 *nearest, char text[PLOT_PANES_TEXT]);

/* Other axes: a box between two points (values); those before; the plot's own. */
void plot_panes_zoom(PlotPane *pane, Vec2 from, Vec2 to);
void plot_panes_zoom_back(PlotPane *pane);
void plot_panes_fit(PlotPane *pane);

/* The axes shown, whether chosen or the plot's own. */
PlotPaneAxes plot_panes_axes(const PlotPane *pane);

/* The place of a part of a frame, from 0 to 1 to the right and up. */
Vec2 plot_panes_place(Box frame, Vec2 part);
