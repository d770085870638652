/* A plot that is drawn bit by bit, in pixels: the live strip beside a film. What stays is painted once; a new segment
 * costs microseconds. What comes in pieces looks as if drawn at once, but for single pixels at the edges of a line. */
#pragma once

#include "plot/plot.h"

typedef struct PlotCanvas PlotCanvas;

/* A part of a canvas, in whole pixels from its upper left corner; nothing when the width is 0. */
typedef struct PlotPixels {
    int x, y, width, height;
} PlotPixels;

/* A canvas of width x height pixels, `unit` of them a design point, with the axes fitted to what the series hold now;
 * nothing of them is drawn. The plot must outlive it; its series may get more points, and other arrays, later.
 * plot_canvas_destroy releases it. */
PlotCanvas *plot_canvas_create(const Plot *plot, int width, int height, double unit, Theme theme);
void plot_canvas_destroy(PlotCanvas *canvas);

/* Draws the first `count` points of a series, as far as that has not been done; fewer than before change nothing. What
 * ends within a half pixel across may wait for the next points. Returns the pixels that may have changed. */
PlotPixels plot_canvas_advance(PlotCanvas *canvas, size_t series, size_t count);

/* Back to nothing drawn. */
void plot_canvas_restart(PlotCanvas *canvas);

/* All of it. */
PlotPixels plot_canvas_all(const PlotCanvas *canvas);

/* 32-bit words 0x00RRGGBB of this machine's byte order, row after row from the top, `plot_canvas_stride` bytes each. */
const unsigned char *plot_canvas_pixels(const PlotCanvas *canvas);
int plot_canvas_stride(const PlotCanvas *canvas);

/* Where a value is, in pixels. */
Vec2 plot_canvas_place(const PlotCanvas *canvas, Vec2 value);

/* What the axes enclose, in pixels, y down; and the value that is there. */
Box plot_canvas_frame(const PlotCanvas *canvas);
Vec2 plot_canvas_value(const PlotCanvas *canvas, Vec2 place);
