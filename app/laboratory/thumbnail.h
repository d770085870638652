/* A house or a beam in little, from its file alone, without a run: its name, a line about it, and a scene without words
 * for a picture of a few hundred pixels. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"
#include "draw/scene.h"

/* Zero is empty; thumbnail_clear releases it. */
typedef struct Thumbnail {
    const char *name; /* as the file says, or its own without ending */
    const char *line; /* the first sentence of the note, shortened; "" */
    Scene scene;
    Arena arena;
} Thumbnail;

enum { THUMBNAIL_LINE = 100 /* characters of the line, at most, and what must be said behind it */ };

/* False: faults say why, and the thumbnail is empty. */
bool thumbnail_read_house(Thumbnail *thumbnail, const char *path, Fault *fault);
bool thumbnail_read_beam(Thumbnail *thumbnail, const char *path, Fault *fault);
void thumbnail_clear(Thumbnail *thumbnail);

/* The file's own name without folder and ending, in the arena. */
const char *thumbnail_name_of(const char *path, Arena *arena);
