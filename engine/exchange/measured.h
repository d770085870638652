/* Points that somebody has measured, as a table of comma-separated values (RFC 4180; also `;` or a tab between
 * columns):
 *
 *     drive.frequency [Hz],peak_max [N]
 *     290,1032
 *
 * The first row names the columns by parameter or observable, in any order; of a parameter what follows its last dot
 * will do. Without a unit a column is in that of the quantity; with m, k or u before it (mm, kHz) it is brought there.
 * Columns that name nothing known are passed over, unless a letter is missing; an empty cell was not measured. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"

/* A quantity that may be measured. */
typedef struct MeasuredKind {
    const char *name;
    const char *other; /* is understood, too; or NULL */
    const char *unit;  /* "1" for pure numbers */
} MeasuredKind;

typedef struct MeasuredColumn {
    const char *name; /* of the kind */
    double *values;   /* (count) in the unit of the kind; NAN: not measured */
    size_t capacity;
} MeasuredColumn;

/* Zero is empty; measured_free releases it. */
typedef struct Measured {
    const char *path;
    MeasuredColumn *columns; /* (column_count) two or more */
    size_t column_count, count;
    Arena arena;
} Measured;

/* Reads a file whose columns are of such kinds (count), at most MEASURED_KINDS. False: faults say where and what, and
 * the points are as they were. */
enum { MEASURED_KINDS = 64 };
bool measured_read(Measured *measured, const char *path, const MeasuredKind *kinds, size_t kind_count, Fault *fault);
void measured_free(Measured *measured);

/* The values (count) of that name; NULL: there are none. */
const double *measured_find(const Measured *measured, const char *name);
