/* Simulated time, counted in whole steps so that it never drifts. */
#pragma once

#include <stdint.h>

typedef struct Clock {
    uint64_t step;
    double dt; /* s */
} Clock;

/* s */
static inline double clock_time(const Clock *clock) {
    return (double)clock->step * clock->dt;
}
