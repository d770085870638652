/* Writes the present view or plot as PNG, SVG, PDF or CSV, with a note in the same folder that describes it. See
 * export.h for the folder and for unused names. */
#pragma once

#include <stddef.h>

#include "base/fault.h"
#include "draw/palette.h"
#include "plot/plot_write.h"
#include "draw/scene.h"

enum { SNAPSHOT_PNG = 1, SNAPSHOT_SVG = 2, SNAPSHOT_PDF = 4, SNAPSHOT_CSV = 8 };

/* The contents of NAME.json, in the same folder as the pictures. */
typedef struct SnapshotNote {
    const char *shows;          /* a sentence or a title */
    const char *const *command; /* (command_count) that produces it, or none */
    size_t command_count;
    double time;        /* s, shown; NAN: none */
    const char *digest; /* of the run, or NULL */
} SnapshotNote;

/* A view: layers painted over each other; `added` holds everything added so far. The raised view can only be written as
 * PNG, from `pixels`. */
typedef struct SnapshotView {
    const Scene *still, *added, *moving; /* `added` and `moving` may be NULL */
    int width, height;                   /* pixels */
    Theme theme;
    const unsigned char *pixels; /* as shown, for the PNG: (width x height x 4) rows from the top; NULL: painted */
} SnapshotView;

/* Write FOLDER/NAME.png, .svg, .pdf (`kinds`: a sum of SNAPSHOT_...) and .json. Return the path without ending, to be
 * released by memory_free; NULL: a fault says why not. A plot may also be written as CSV. */
char *snapshot_view(const SnapshotView *view, int kinds, const char *folder, const char *name, const SnapshotNote *note,
                    Fault *fault);
char *snapshot_plot(const Plot *plot, const PlotSheet *sheet, int kinds, const char *folder, const char *name,
                    const SnapshotNote *note, Fault *fault);

/* Writes pixels as a picture to exactly this path. Returns 0 or errno. */
int snapshot_pixels(const char *path, const unsigned char *pixels, int width, int height);
