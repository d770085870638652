#include "plan/observed_times.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static ObservedTimes of_times(const NumberList *times) {
    ObservedTimes found = {.runs = (int)times->count};
    double squares = 0;
    for (size_t i = 0; i < times->count; i++)
        found.mean += times->at[i] / (double)times->count;
    for (size_t i = 0; i < times->count; i++)
        squares += (times->at[i] - found.mean) * (times->at[i] - found.mean);
    found.deviation = times->count > 1 ? sqrt(squares / (double)(times->count - 1)) : 0;
    return found;
}

ObservedTimes observed_times_of(const Observed *observed) {
    if (observed->times.count)
        return of_times(&observed->times);
    bool measured = observed->mean > 0;
    return measured ? (ObservedTimes){observed->mean, observed->deviation, observed->runs} : (ObservedTimes){0, 0, 0};
}

static bool contradicts(double given, double found) {
    return given > 0 && fabs(given - found) > OBSERVED_ROUNDING + 1e-9;
}

bool observed_times_check(const Observed *observed, char *fault, size_t size) {
    ObservedTimes found = observed_times_of(observed);
    size_t times = observed->times.count, drivers = observed->drivers.count;
    bool given =
        observed->mean > 0 || observed->deviation > 0 || observed->runs > 1 || drivers || observed->touches >= 0;
    *fault = 0;
    if (given && !found.runs)
        snprintf(fault, size, "observed has neither \"mean\" nor \"times\", must have one of them");
    else if (times && contradicts(observed->mean, found.mean))
        snprintf(fault, size, "observed has the mean %g s, must be that of its times, %.3f s", observed->mean,
                 found.mean);
    else if (times > 1 && contradicts(observed->deviation, found.deviation))
        snprintf(fault, size, "observed has the deviation %g s, must be that of its times, %.3f s", observed->deviation,
                 found.deviation);
    else if (times && observed->runs > 1 && (size_t)observed->runs != times)
        snprintf(fault, size, "observed has %d runs and %zu times, must be the same number", observed->runs, times);
    else if (drivers && drivers != times)
        snprintf(fault, size, "observed has %zu drivers and %zu times, must be the same number", drivers, times);
    else if (observed->touches > found.runs)
        snprintf(fault, size, "observed has %d touches, must be at most its %d runs", observed->touches, found.runs);
    return !*fault;
}

/* Returns the first run of the same person. */
static size_t first_run(const Ids *drivers, size_t i) {
    size_t first = 0;
    while (strcmp(drivers->at[first], drivers->at[i]) != 0)
        first++;
    return first;
}

size_t observed_times_person(const Observed *observed, size_t i) {
    size_t person = 0, first = first_run(&observed->drivers, i);
    for (size_t k = 0; k < first; k++)
        person += first_run(&observed->drivers, k) == k;
    return person;
}
