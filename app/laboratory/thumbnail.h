/* A small picture of a house, a beam or a crank, from its file alone, without a run: its name, one line about it, and a
 * scene without texts for a picture of a few hundred pixels. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"
#include "draw/scene.h"

/* A zeroed thumbnail is empty; thumbnail_clear releases it. */
typedef struct Thumbnail {
    const char *name; /* name in the file, or the file's own name without extension */
    const char *line; /* first sentence of the note, shortened; or "" */
    size_t people;    /* of a house, with its crowds */
    Scene scene;
    Arena arena;
} Thumbnail;

enum { THUMBNAIL_LINE = 100 /* at most this many characters of the line, plus a required suffix */ };

/* Read a file. False: faults give the reasons, and the thumbnail is empty. */
bool thumbnail_read_house(Thumbnail *thumbnail, const char *path, Fault *fault);
bool thumbnail_read_beam(Thumbnail *thumbnail, const char *path, Fault *fault);
bool thumbnail_read_crank(Thumbnail *thumbnail, const char *path, Fault *fault);
void thumbnail_clear(Thumbnail *thumbnail);

/* Returns the file's own name without folder and extension, in the arena. */
const char *thumbnail_name_of(const char *path, Arena *arena);
