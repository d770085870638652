/* Houses and beams that come with the program, each with a line and a small picture: drawn by the program itself from
 * the plan or the beam alone, without a run, by a thread, one after the other, and kept in $XDG_CACHE_HOME/clearance/
 * under the digest of the file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "draw/palette.h"

typedef struct Gallery Gallery;

enum { GALLERY_WIDTH = 320, GALLERY_HEIGHT = 200 }; /* pixels of a picture */

typedef struct GalleryItem {
    const char *path;
    const char *name;            /* as the file says; until it is read, the file's own name without ending */
    const char *line;            /* of the note, a line's worth; "" */
    size_t laboratory;           /* index among `laboratories` */
    const char *fault;           /* why there is no picture: it cannot be read, or NULL */
    const unsigned char *pixels; /* GALLERY_WIDTH x GALLERY_HEIGHT of cairo's RGB24, rows from the top; NULL: not yet */
    bool is_read;                /* it has been read: name, line and fault are final */
} GalleryItem;

/* Houses first, each kind in natural order of names. Returns at once; gallery_destroy ends the thread. */
Gallery *gallery_create(Theme theme);
void gallery_destroy(Gallery *gallery);

/* Draws them anew, in another theme. */
void gallery_set_theme(Gallery *gallery, Theme theme);

/* Takes over what has come; true: something has. */
bool gallery_update(Gallery *gallery);

/* Is all there, and taken over, that will come? */
bool gallery_complete(Gallery *gallery);

/* Good until the next gallery_update or gallery_set_theme. */
const GalleryItem *gallery_items(const Gallery *gallery, size_t *count);
