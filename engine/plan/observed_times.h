/* The measured runs of a route: the mean, the deviation and the number of runs that its file gives, or those of the
 * times of the runs. Where a file gives both, they must agree to OBSERVED_ROUNDING, since a mean is rounded. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "plan/plan.h"

#define OBSERVED_ROUNDING 0.05 /* s: half of a tenth, to which a mean is often rounded */

typedef struct ObservedTimes {
    double mean;      /* s; 0: not measured */
    double deviation; /* s, with n - 1; 0: unknown */
    int runs;         /* 0: not measured */
} ObservedTimes;

ObservedTimes observed_times_of(const Observed *observed);

/* Checks that the numbers fit together. Returns false with the reason, a part of a sentence, in `fault` (size). */
bool observed_times_check(const Observed *observed, char *fault, size_t size);

/* Returns the number of the person who drove run i, from 0 in the order in which they first drove. `i` is less than the
 * number of drivers. */
size_t observed_times_person(const Observed *observed, size_t i);
