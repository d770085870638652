/* The directory of --out. */
#pragma once

#include <stdbool.h>

#include "options/options.h"
#include "draw/scene.h"

enum {
    OUTPUT_PATH = 4096, /* room for a path there: as much as the system takes */
    OUTPUT_NAME = 64,   /* of it for the names of files */
};

/* Makes the directory and those above it, before the work is done; says so on standard error when that cannot be. */
bool output_directory(const char *path);

/* Writes plan.png, plan.svg and plan.pdf there. False: said on standard error. */
bool output_stills(const Scene *scene, const Options *options);

/* Says on standard error, when Ctrl-C came while pictures were made, that not all of them are there; `told`: it came
 * before and that was said. */
void output_tell_interrupted(bool told);

/* Says on standard error that a file cannot be written, and why. */
void output_failed(const char *path, int error);
