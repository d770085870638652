/* Measured times of routes, as a table of comma-separated values (RFC 4180; also `;` or a tab between columns):
 *
 *     route,time [s],deviation [s]
 *     A,13.1,0.5
 *
 * The first row names the columns, in any order; `deviation`, the standard deviation of this time, may be left out or
 * empty. One row is one run, with as many columns as the first row; unknown columns are ignored. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/memory.h"

typedef struct TimedRun {
    const char *route;
    double time;      /* s */
    double deviation; /* s; NAN: not given */
    const char *path; /* of its file */
    int line;         /* from 1 */
} TimedRun;

/* A zeroed value is empty; timed_free releases it. */
typedef struct Timed {
    TimedRun *runs; /* (count) in file order */
    size_t count, capacity;
    Arena arena;
} Timed;

/* Adds the runs of a file. Returns false after errors with their places, with no run added. */
bool timed_read(Timed *timed, const char *path, Fault *fault);
void timed_free(Timed *timed);
