/* Loci that were measured, as a table of comma-separated values (RFC 4180; also `;` or a tab between columns):
 *
 *     time [s],x [m],y [m],person
 *     0.00,1.20,3.40,p1
 *
 * The first row names the columns, in any order, with or without units; unknown columns are ignored. A place is that
 * of the body's centre. Without a column `person` all rows belong to one person. Rows may be in any order; each
 * has as many columns as the first. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"
#include "house/locus.h"

typedef struct ObservedLocus {
    const char *person; /* as in the file; "" without such a column */
    int line;           /* line of the first row, from 1 */
    Locus locus;
} ObservedLocus;

/* A zeroed value is empty; observed_free releases it. */
typedef struct ObservedLoci {
    const char *path;
    ObservedLocus *loci; /* (count) in file order */
    size_t count;
    Arena arena;
} ObservedLoci;

/* Returns false after errors with their places and leaves `loci` unchanged. */
bool observed_read(ObservedLoci *loci, const char *path, Fault *fault);
void observed_free(ObservedLoci *loci);
