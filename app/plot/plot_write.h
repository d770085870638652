/* Plots as files. The same plot gives the same bytes; files are written to a temporary file, then renamed. All
 * functions return 0, or errno: EINVAL for invalid sizes. */
#pragma once

#include "paint/cairo_file.h"
#include "plot/plot.h"

/* Writes a picture of width x height pixels; in a PDF, of 1/72 inch. A design point is at least 1 of them, and twice
 * as large as in a house picture of this size: legible from as far away as a title. */
int plot_write_picture(CairoFileKind kind, const Plot *plot, const char *path, int width, int height, Theme theme);

/* Writes CSV (RFC 4180): for a raster, one row per cell with its middle and its value or the name of its class; for an
 * area three columns; for a series two, with a header `axis [unit]`, which includes the name of the series if there
 * are several. Shorter columns end with empty fields; values that are not numbers are empty, too. */
int plot_write_csv(const Plot *plot, const char *path);

enum { PLOT_WRITE_PATH = 4096 /* room for a path: the longest that the system allows */ };

/* Writes OUT/plot-NAME.png, .svg, .pdf and .csv. On an error, `path` is the file that could not be written. */
int plot_write_files(const Plot *plot, const char *name, const char *out, int width, int height, Theme theme,
                     char path[PLOT_WRITE_PATH]);
