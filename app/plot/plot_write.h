/* Plots as files. The same plot gives the same bytes; files are written to a temporary file, then renamed. All
 * functions return 0, or errno: EINVAL for invalid sizes. */
#pragma once

#include "paint/cairo_file.h"
#include "plot/plot.h"

/* Size, theme and foot of a written plot. */
typedef struct PlotSheet {
    int width, height; /* pixels; in a PDF, 1/72 inch */
    Theme theme;
    const char *source; /* the origin of the numbers, a line at the foot of the picture; NULL: none */
} PlotSheet;

/* Writes a picture. A design point is at least 1 pixel, and twice as large as in a house picture of this size: legible
 * from as far away as a title. */
int plot_write_picture(CairoFileKind kind, const Plot *plot, const char *path, const PlotSheet *sheet);

/* Writes CSV (RFC 4180): for a raster, one row per cell with its middle and its value or the name of its class; for an
 * area three columns; for a series two, with a header `axis [unit]`, which includes the name of the series if there
 * are several. Shorter columns end with empty fields; values that are not numbers are empty, too. */
int plot_write_csv(const Plot *plot, const char *path);

enum { PLOT_WRITE_PATH = 4096 /* room for a path: the longest that the system allows */ };

/* Writes OUT/plot-NAME.png, .svg, .pdf and .csv. On an error, `path` is the file that could not be written. */
int plot_write_files(const Plot *plot, const char *name, const char *out, const PlotSheet *sheet,
                     char path[PLOT_WRITE_PATH]);
