/* Plots as files. The same plot gives the same bytes; files are written beside and renamed. All return 0, or errno:
 * EINVAL for sizes that no picture has. */
#pragma once

#include "draw/cairo_file.h"
#include "draw/plot.h"

/* A picture of width x height pixels; of a PDF, of 1/72 inch. A design point is at least 1 of them, and twice as large
 * as that of a house in a picture of this size: read from as far as a title. */
int plot_write_picture(CairoFileKind kind, const Plot *plot, const char *path, int width, int height, Theme theme);

/* CSV (RFC 4180): two columns a series, with a header `axis [unit]`, which names the series too when there are several;
 * a series that ends earlier has empty fields. What is no number is empty, too. */
int plot_write_csv(const Plot *plot, const char *path);
