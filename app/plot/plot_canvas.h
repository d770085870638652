/* A plot that is drawn bit by bit, in pixels: the live strip next to a film. The fixed part is painted once; a new
 * segment costs microseconds. A plot drawn in pieces looks as if drawn at once, except for single pixels at the edges
 * of a line. */
#pragma once

#include "plot/plot_layout.h"

typedef struct PlotCanvas PlotCanvas;

/* A part of a canvas, in whole pixels from its upper left corner; empty if the width is 0. */
typedef struct PlotPixels {
    int x, y, width, height;
} PlotPixels;

/* Makes a canvas of width x height pixels, `unit` of them a design point, with axes fitted to the present values of
 * the series, none of which is drawn yet. The plot must outlive the canvas; its series may get more points, and other
 * arrays, later. plot_canvas_destroy releases it. */
PlotCanvas *plot_canvas_create(const Plot *plot, int width, int height, double unit, Theme theme);
void plot_canvas_destroy(PlotCanvas *canvas);

/* Draws the first `count` points of a series, as far as they are not drawn yet; fewer than before change nothing. The
 * end of the line may wait for the next points if it is within half a pixel across. Returns the pixels that may have
 * changed. */
PlotPixels plot_canvas_advance(PlotCanvas *canvas, size_t series, size_t count);

/* Erases all series. */
void plot_canvas_restart(PlotCanvas *canvas);

/* Returns the whole canvas. */
PlotPixels plot_canvas_all(const PlotCanvas *canvas);

/* Returns 32-bit words 0x00RRGGBB in this machine's byte order, row after row from the top, `plot_canvas_stride` bytes
 * each. */
const unsigned char *plot_canvas_pixels(const PlotCanvas *canvas);
int plot_canvas_stride(const PlotCanvas *canvas);

/* Returns where everything stands, in design points of the canvas. */
const PlotLayout *plot_canvas_layout(const PlotCanvas *canvas);

/* Returns the place of a value, in pixels. */
Vec2 plot_canvas_place(const PlotCanvas *canvas, Vec2 value);

/* Returns the box that the axes enclose, in pixels, y down; and the value at a place. */
Box plot_canvas_frame(const PlotCanvas *canvas);
Vec2 plot_canvas_value(const PlotCanvas *canvas, Vec2 place);
