/* Furniture for placing: sizes and heights of usual pieces, each with its source, read from assets/furniture, one file
 * per style of living. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "plan/plan.h"

typedef struct CatalogueItem {
    const char *group; /* group of its file: "Japanese" */
    const char *name;
    Vec2 size;              /* m, along its own x and y; its back is +y */
    double height;          /* m */
    int topples;            /* ToppleFace */
    double probability;     /* 1, probability of toppling in a shake */
    const char *provenance; /* source of its sizes: `literature: source` or `assumed` */
} CatalogueItem;

/* A zeroed catalogue is empty; catalogue_free releases it. */
typedef struct Catalogue {
    CatalogueItem *items; /* (count) in the order of the files' names */
    size_t count, capacity;
    Arena arena;
} Catalogue;

/* Adds the pieces of a file. Returns false after an error, with the catalogue unchanged. */
bool catalogue_read(Catalogue *catalogue, const char *path, Fault *fault);

/* Does the same with every .json file of a folder; valid files are added even if others are not valid. */
bool catalogue_read_folder(Catalogue *catalogue, const char *folder, Fault *fault);
void catalogue_free(Catalogue *catalogue);
