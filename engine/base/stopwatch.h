/* Measures real time, for progress, responsiveness and how often a disk is asked to write. No result depends on it. */
#pragma once

/* Returns the time of a monotonic clock, s; its zero has no meaning. */
double stopwatch_now(void);
