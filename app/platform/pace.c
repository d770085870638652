#include "platform/pace.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/order.h"
#include "base/text.h"
#include "platform/sdl_window.h"

#define MILLI 1000.0

double pace_wait(Pace *pace, bool hurried) {
    double now = clock_now(), due = pace->last + 1 / PACE_RATE;
    if (!hurried && now < due)
        sdl_window_sleep(due - now);
    now = clock_now();
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

/* s, for which this process has been there; by the system's ticks, of 10 ms mostly. */
static double process_age(void) {
    enum { STARTED = 22 /* field of /proc/self/stat */ };
    size_t size;
    char *text = text_read_file("/proc/self/stat", 4096, &size), *at = text ? strrchr(text, ')') : NULL;
    double ticks = 0;
    for (int field = 2; at && field < STARTED; field++)
        at = strchr(at + 1, ' ');
    if (at)
        ticks = strtod(at, NULL);
    memory_free(text);
    struct timespec now;
    clock_gettime(CLOCK_BOOTTIME, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec - ticks / (double)sysconf(_SC_CLK_TCK);
}

void pace_note_first(Pace *pace) {
    if (pace->first <= 0)
        pace->first = process_age();
}

void pace_count(Pace *pace) {
    pace->counting = true;
    pace->count = 0;
    pace->worked = 0;
    pace->begun = clock_now();
}

void pace_print(Pace *pace, const char *what, int width, int height) {
    double passed = clock_now() - pace->begun;
    if (!pace->count)
        return;
    qsort(pace->times, pace->count, sizeof *pace->times, order_rising);
    printf("%s, %d x %d: first picture after %.2f s, %.1f frames/s, a frame takes %.1f ms (median), %.1f ms (99 of "
           "100), simulating is %.1f %%\n",
           what, width, height, pace->first, (double)pace->count / passed, MILLI * pace->times[pace->count / 2],
           MILLI * pace->times[pace->count * 99 / 100], 100 * pace->worked / passed);
}

void pace_clear(Pace *pace) {
    memory_free(pace->times);
    *pace = (Pace){0};
}
