/* A recording: named columns with units, one row per sample. Every plot, CSV file and database is made from a trace. */
#pragma once

#include <stddef.h>

typedef struct TraceColumn {
    const char *name;
    const char *unit; /* "1" for pure numbers */
} TraceColumn;

typedef struct Trace {
    const TraceColumn *columns; /* (width), not owned */
    size_t width, rows, capacity;
    double *values; /* (rows x width) */
} Trace;

void trace_init(Trace *trace, const TraceColumn *columns, size_t width);
void trace_clear(Trace *trace);

/* Adds a row of `width` values. */
void trace_add(Trace *trace, const double *values);

static inline const double *trace_row(const Trace *trace, size_t row) {
    return trace->values + row * trace->width;
}

/* Writes CSV (RFC 4180) with a header `name [unit]` and NAN as an empty cell, to a temporary file that is then renamed.
 * Returns 0 or errno. */
int trace_write_csv(const Trace *trace, const char *path);
