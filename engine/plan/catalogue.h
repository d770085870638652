/* Furniture to be placed: sizes and heights of usual pieces, each with where they come from, read from
 * assets/furniture, a file for each way of living. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "plan/plan.h"

typedef struct CatalogueItem {
    const char *group; /* of its file: "Japanese" */
    const char *name;
    Vec2 size;              /* m, along its own x and y; its back is +y */
    double height;          /* m */
    int topples;            /* ToppleFace */
    double probability;     /* 1, of toppling in a shake */
    const char *provenance; /* of its sizes: `literature: source` or `assumed` */
} CatalogueItem;

/* Zero is empty; catalogue_free releases what a reader filled. */
typedef struct Catalogue {
    CatalogueItem *items; /* (count) in the order of the files' names */
    size_t count, capacity;
    Arena arena;
} Catalogue;

/* Adds the pieces of a file. False: faults say what is wrong, and the catalogue is as it was. */
bool catalogue_read(Catalogue *catalogue, const char *path, Fault *fault);

/* The same of every .json file of a folder; those that are good are there although others are not. */
bool catalogue_read_folder(Catalogue *catalogue, const char *folder, Fault *fault);
void catalogue_free(Catalogue *catalogue);
