/* The directory of --out, and standard output. */
#pragma once

#include <stdbool.h>

#include "base/text.h"
#include "options/options.h"
#include "draw/scene.h"
#include "plot/plot_write.h"

enum {
    OUTPUT_PATH = 4096, /* bytes of a path in it, as many as the system allows */
    OUTPUT_NAME = 64,   /* bytes of these for the names of files */
};

/* Prints on standard error that no font is installed, if that is so, before pictures are made. */
void output_warn_of_fonts(void);

/* Prints a text, which may be empty, on standard output. */
void output_text(const Text *text);

/* Makes the directory and those above it, before the work begins, and after the input is read: wrong input leaves none
 * behind, and to remove one would take it from another program that writes there. NULL: there is none to make. False:
 * an error was printed. */
bool output_directory(const char *path);

/* Writes plan.png, plan.svg and plan.pdf to it. False: an error was printed. */
bool output_stills(const Scene *scene, const Options *options);

/* Returns the sheet of a plot, with the origin of its numbers (NULL: none). */
PlotSheet output_sheet(const Options *options, const char *source);

/* Prints on standard error that pictures are missing if Ctrl-C interrupted them, unless `told`, an earlier interruption
 * that has been reported. Returns whether there was an interruption. */
bool output_tell_interrupted(bool told);

/* Prints on standard error that a file cannot be written, and why. */
void output_failed(const char *path, int error);
