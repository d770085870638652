/* The panes of plots: drawn incrementally into pictures, with the present moment marked, a cursor that sets a
 * parameter, a read-out of the nearest point, and axes that can be zoomed. Chosen axes stay until they are reset. */
#pragma once

#include "paint/paint_gl_screen.h"
#include "plot/plot_canvas.h"
#include "laboratory/laboratory.h"
#include "widgets/ui.h"

enum { PLOT_PANES_MOST = 8, PLOT_PANES_VIEWS_MOST = 16, PLOT_PANES_TEXT = 160 };

/* The ranges of the axes that are shown. */
typedef struct PlotPaneAxes {
    double x[2], y[2];
} PlotPaneAxes;

/* A zoom box that is chosen by keys: one corner, then the other. */
typedef struct PlotPaneBox {
    int corner;    /* 0: none is chosen, 1: the first moves, 2: the other */
    Vec2 from, to; /* 0 to 1 of the axes */
} PlotPaneBox;

typedef struct PlotPane {
    LaboratoryPlot source;
    Plot shown; /* source.plot with the axes that are shown */
    PlotCanvas *canvas;
    ScreenTexture texture;
    int width, height;
    double unit;
    Theme theme;
    double time;                               /* s, drawn last */
    char note[PLOT_PANES_TEXT];                /* drawn last */
    PlotPaneAxes views[PLOT_PANES_VIEWS_MOST]; /* (view_count) the last is shown; none: the plot's own */
    size_t view_count;
    PlotPaneBox box;
    Box place; /* design points of the window */
} PlotPane;

typedef struct PlotPanes {
    PlotPane panes[PLOT_PANES_MOST]; /* (count) */
    size_t count;
} PlotPanes;

/* Chooses the plots with the given names, separated by commas, in that order. Panes that stay keep their pictures and
 * axes. */
void plot_panes_choose(PlotPanes *panes, const Laboratory *laboratory, void *session, const char *names,
                       PaintGlScreen *screen);
void plot_panes_clear(PlotPanes *panes, PaintGlScreen *screen);

/* Returns the plot that has the focus; NULL: none has. */
PlotPane *plot_panes_focused(PlotPanes *panes, const Ui *ui);

/* Draws a plot in its place, design points of `unit` pixels. */
void plot_panes_show(PlotPane *pane, const Laboratory *laboratory, const void *session, size_t index, double time,
                     Box place, double unit, Theme theme, PaintGlScreen *screen, Ui *ui);

/* Finds the values at a point of the window; false: it is outside of the axes. */
bool plot_panes_value(const PlotPane *pane, Vec2 at, Vec2 *value);

/* Formats the point of a series nearest to a point of the window, "x 0.12 mm, y 0.3 m/s", or, if
 * `brief`, "0.12 mm, 0.3 m/s"; false: none is near. */
bool plot_panes_read(const PlotPane *pane, const Laboratory *laboratory, const void *session, size_t index, double time,
                     Vec2 at, bool brief, Vec2 *nearest, char text[PLOT_PANES_TEXT]);

/* Zoom to the box between two points (values); go back to the previous axes; go back to the plot's own axes. */
void plot_panes_zoom(PlotPane *pane, Vec2 from, Vec2 to);
void plot_panes_zoom_back(PlotPane *pane);
void plot_panes_fit(PlotPane *pane);

/* Returns the box within the axes, design points of the window. */
Box plot_panes_frame(const PlotPane *pane);

/* Returns the axes shown, whether chosen or the plot's own. */
PlotPaneAxes plot_panes_axes(const PlotPane *pane);

/* Returns the place at a share of a frame, from 0 to 1 to the right and up. */
Vec2 plot_panes_place(Box frame, Vec2 part);
