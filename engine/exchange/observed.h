/* Loci that somebody has measured, as a table of comma-separated values (RFC 4180; also `;` or a tab between columns):
 *
 *     time [s],x [m],y [m],person
 *     0.00,1.20,3.40,p1
 *
 * The first row names the columns, in any order and with or without units; further ones are passed over. A place is
 * that of the body's middle. Without a column `person` all rows are of one. Rows may stand in any order. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"
#include "house/locus.h"

typedef struct ObservedLocus {
    const char *person; /* as the file names them; "" without such a column */
    int line;           /* of the file, where they come first, from 1 */
    Locus locus;
} ObservedLocus;

/* Zero is empty; observed_free releases it. */
typedef struct ObservedLoci {
    const char *path;
    ObservedLocus *loci; /* (count) in the order of the file */
    size_t count;
    Arena arena;
} ObservedLoci;

/* False: faults say where and what, and the loci are as they were. */
bool observed_read(ObservedLoci *loci, const char *path, Fault *fault);
void observed_free(ObservedLoci *loci);
