/* Files of what is seen now: a view or a plot as PNG, SVG, PDF or CSV, with a note beside them that says what it is.
 * See export.h for where, and for names that are free. */
#pragma once

#include <stddef.h>

#include "base/fault.h"
#include "draw/palette.h"
#include "plot/plot.h"
#include "draw/scene.h"

enum { SNAPSHOT_PNG = 1, SNAPSHOT_SVG = 2, SNAPSHOT_PDF = 4, SNAPSHOT_CSV = 8 };

/* What stands in NAME.json beside the pictures. */
typedef struct SnapshotNote {
    const char *shows;          /* a sentence or a title */
    const char *const *command; /* (command_count) that makes it, or none */
    size_t command_count;
    double time;        /* s, shown; NAN: none */
    const char *digest; /* of the run, or NULL */
} SnapshotNote;

/* A view: layers painted over each other; `added` holds all that was ever added. The raised view can be written as PNG
 * only, and of pixels. */
typedef struct SnapshotView {
    const Scene *still, *added, *moving; /* `added` and `moving` may be NULL */
    int width, height;                   /* pixels */
    Theme theme;
    const unsigned char *pixels; /* as shown, for the PNG: (width x height x 4) rows from the top; NULL: painted */
} SnapshotView;

/* Write FOLDER/NAME.png, .svg, .pdf (SNAPSHOT_..., added up) and .json. Returns the path without ending, for
 * memory_free; NULL: a fault says why not. The plot may also be written as CSV. */
char *snapshot_view(const SnapshotView *view, int kinds, const char *folder, const char *name, const SnapshotNote *note,
                    Fault *fault);
char *snapshot_plot(const Plot *plot, int width, int height, Theme theme, int kinds, const char *folder,
                    const char *name, const SnapshotNote *note, Fault *fault);

/* A picture of pixels alone, as the whole window: to exactly this path. 0, or errno. */
int snapshot_pixels(const char *path, const unsigned char *pixels, int width, int height);
