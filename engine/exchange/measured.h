/* Points that somebody has measured, as a table of comma-separated values (RFC 4180; also `;` or a tab between
 * columns):
 *
 *     drive.frequency [Hz],peak_max [N]
 *     290,1032
 *
 * The first row names the columns by parameter or observable, in any order; of a parameter what follows its last dot
 * will do. Without a unit a column is in that of the quantity; with m, k or u before it (mm, kHz) it is brought there.
 * Columns that name nothing known are passed over, unless a letter is missing; an empty cell was not measured. Each row
 * has as many columns as the first. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"

/* A quantity that can be measured. */
typedef struct MeasuredKind {
    const char *name;
    const char *other; /* alternative name, or NULL */
    const char *unit;  /* "1" for pure numbers */
} MeasuredKind;

typedef struct MeasuredColumn {
    const char *name; /* name of the kind */
    double *values;   /* (count) in the unit of the kind; NAN: not measured */
    size_t capacity;
} MeasuredColumn;

/* A zeroed value is empty; measured_free releases it. */
typedef struct Measured {
    const char *path;
    MeasuredColumn *columns; /* (column_count) two or more */
    size_t column_count, count;
    Arena arena;
} Measured;

/* Reads a file with columns of these kinds (count, at most MEASURED_KINDS). Returns false after errors with their
 * places and leaves `measured` unchanged. */
enum { MEASURED_KINDS = 64 };
bool measured_read(Measured *measured, const char *path, const MeasuredKind *kinds, size_t kind_count, Fault *fault);
void measured_free(Measured *measured);

/* Returns the values (count) of that name, or NULL. */
const double *measured_find(const Measured *measured, const char *name);
