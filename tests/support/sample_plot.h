/* Small plots for tests, and what their layouts, pixels and files hold. */
#pragma once

#include <cairo.h>

#include "paint/cairo_file.h"
#include "plot/plot.h"
#include "plot/plot_canvas.h"
#include "plot/plot_layout.h"

/* Fills a wave of `count` points over x from 0 to 10. */
void sample_fill_wave(double *x, double *y, size_t count);

PlotSeries sample_line(const char *name, const double *x, const double *y, size_t count);

/* Returns a plot of clearance over time. */
Plot sample_plot(PlotSeries *series, size_t count);

/* Checks that no texts overlap or leave the page, and that the frame keeps its height. */
void sample_check_layout(const PlotLayout *layout);
bool sample_has_text(const PlotLayout *layout, const char *text);

/* Paints at once, like plot_paint; `unit` pixels a design point. cairo_surface_destroy the result. */
cairo_surface_t *sample_painted(const Plot *plot, int width, int height, double unit);

/* Returns the difference of a pixel from the paper, of 255. */
int sample_ink(const PlotCanvas *canvas, Vec2 place);

enum { SAMPLE_CSV = CAIRO_FILE_PDF + 1 /* alongside CairoFileKind */ };

/* Writes a picture of 800 x 500, or a table, under /tmp and returns its bytes, ended by 0; memory_free them. */
char *sample_written(const Plot *plot, int kind, size_t *size);
