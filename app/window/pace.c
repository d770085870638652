#include "window/pace.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "window/glass.h"

#define MILLI 1000.0

double pace_wait(Pace *pace) {
    double now = glass_now(), due = pace->last + 1 / PACE_RATE;
    if (!pace->counting && now < due)
        glass_sleep(due - now);
    now = glass_now();
    double since = pace->last > 0 ? now - pace->last : 0;
    pace->last = now;
    return since;
}

void pace_note(Pace *pace, double seconds, double simulating) {
    if (!pace->counting)
        return;
    pace->times = memory_reserve(pace->times, &pace->capacity, pace->count + 1, sizeof *pace->times);
    pace->times[pace->count++] = seconds;
    pace->worked += simulating;
}

void pace_count(Pace *pace) {
    pace->counting = true;
    pace->count = 0;
    pace->worked = 0;
    pace->begun = glass_now();
}

static int by_size(const void *a, const void *b) {
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

void pace_print(Pace *pace, const char *what, int width, int height) {
    double passed = glass_now() - pace->begun;
    if (!pace->count)
        return;
    qsort(pace->times, pace->count, sizeof *pace->times, by_size);
    printf("%s, %d x %d: %.1f frames/s, a frame takes %.1f ms (median), %.1f ms (99 of 100), simulating is %.1f %%\n",
           what, width, height, (double)pace->count / passed, MILLI * pace->times[pace->count / 2],
           MILLI * pace->times[pace->count * 99 / 100], 100 * pace->worked / passed);
}

void pace_clear(Pace *pace) {
    memory_free(pace->times);
    *pace = (Pace){0};
}
