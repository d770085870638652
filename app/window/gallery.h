/* The lessons, houses and machines that come with the program, each with a line and a small picture. A thread draws the
 * pictures from the files alone, without a run, and caches them in $XDG_CACHE_HOME/clearance/ under the digest of the
 * file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "draw/palette.h"

typedef struct Gallery Gallery;

enum { GALLERY_WIDTH = 320, GALLERY_HEIGHT = 200 }; /* pixels of a picture */

typedef struct GalleryItem {
    const char *path;
    const char *name;            /* from the file; the file's name without ending until it is read */
    const char *line;            /* the beginning of the note, or "" */
    bool lesson;                 /* `path` is a lesson, */
    const char *drawn;           /* and this its house or machine; otherwise the file itself */
    size_t laboratory;           /* index among `laboratories` */
    const char *about;           /* of a lesson, its minutes and level; otherwise NULL */
    size_t people;               /* of a house, once it is read */
    const char *fault;           /* why there is no picture, or NULL */
    const unsigned char *pixels; /* GALLERY_WIDTH x GALLERY_HEIGHT of cairo's RGB24, rows from the top; NULL: not yet */
    bool is_read;                /* name, line and fault are final */
} GalleryItem;

/* Creates the gallery, in the order of the laboratories and in natural order of names, and returns at once;
 * gallery_destroy ends the thread. */
Gallery *gallery_create(Theme theme);
void gallery_destroy(Gallery *gallery);

/* Redraws the pictures in another theme. */
void gallery_set_theme(Gallery *gallery, Theme theme);

/* Takes over what the thread has finished; true if there was anything. */
bool gallery_update(Gallery *gallery);

/* True if everything is read and drawn, and taken over. */
bool gallery_complete(Gallery *gallery);

/* Returns the items, valid until the next gallery_update or gallery_set_theme. */
const GalleryItem *gallery_items(const Gallery *gallery, size_t *count);
