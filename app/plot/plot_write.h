/* Plots as files. The same plot gives the same bytes; files are written beside and renamed. All return 0, or errno:
 * EINVAL for sizes that no picture has. */
#pragma once

#include "paint/cairo_file.h"
#include "plot/plot.h"

/* A picture of width x height pixels; of a PDF, of 1/72 inch. A design point is at least 1 of them, and twice as large
 * as that of a house in a picture of this size: read from as far as a title. */
int plot_write_picture(CairoFileKind kind, const Plot *plot, const char *path, int width, int height, Theme theme);

/* CSV (RFC 4180): of a raster, a row a cell with its middle and its value or the name of its class; of an area three
 * columns; of a series two, with a header `axis [unit]`, which names the series too when there are several; what ends
 * earlier has empty fields. What is no number is empty, too. */
int plot_write_csv(const Plot *plot, const char *path);

enum { PLOT_WRITE_PATH = 4096 /* room for a path: as much as the system takes */ };

/* All of it: OUT/plot-NAME.png, .svg, .pdf and .csv. On an error, `path` is the file that could not be written. */
int plot_write_files(const Plot *plot, const char *name, const char *out, int width, int height, Theme theme,
                     char path[PLOT_WRITE_PATH]);
