#include "platform/frame_timer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "base/memory.h"
#include "base/order.h"
#include "base/text.h"
#include "platform/sdl_window.h"

#define MILLI 1000.0
#define WARM 3.0      /* s, before frames are counted; */
#define PATIENCE 60.0 /* s, if nothing moves */

double frame_timer_wait(FrameTimer *timer, bool hurried) {
    double now = stopwatch_now(), due = timer->last + 1 / FRAME_TIMER_RATE;
    if (!hurried && now < due)
        sdl_window_sleep(due - now);
    now = stopwatch_now();
    double since = timer->last > 0 ? now - timer->last : 0;
    timer->last = now;
    return since;
}

/* Returns the age of this process, s, to the system's tick (10 ms on most systems). */
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

/* Returns the processor time of all threads of this process so far, s. */
static double processor_time(void) {
    struct timespec used;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return (double)used.tv_sec + 1e-9 * (double)used.tv_nsec;
}

FrameMachine frame_timer_machine(const FrameTimer *timer) {
    FrameMachine machine = {.load = NAN, .processors = sysconf(_SC_NPROCESSORS_ONLN)};
    double passed = stopwatch_now() - timer->begun;
    machine.used = passed > 0 ? (processor_time() - timer->processor) / passed : NAN;
    if (getloadavg(&machine.load, 1) != 1)
        machine.load = NAN;
    return machine;
}

void frame_timer_note(FrameTimer *timer, double seconds, double simulating, bool moves) {
    if (timer->first <= 0)
        timer->first = process_age();
    if (timer->moving <= 0 && moves)
        timer->moving = process_age();
    if (!timer->counting)
        return;
    timer->worked += simulating;
    if (!moves) {
        timer->still_count++;
        timer->still_time += seconds;
        return;
    }
    timer->times = memory_reserve(timer->times, &timer->capacity, timer->count + 1, sizeof *timer->times);
    timer->times[timer->count++] = seconds;
}

void frame_timer_count(FrameTimer *timer) {
    timer->counting = true;
    timer->count = timer->still_count = 0;
    timer->worked = timer->still_time = 0;
    timer->begun = stopwatch_now();
    timer->processor = processor_time();
}

bool frame_timer_advance(FrameTimer *timer, double age, double seconds) {
    if (!timer->counting && age > (timer->moving > 0 ? WARM : PATIENCE))
        frame_timer_count(timer);
    return timer->counting && stopwatch_now() - timer->begun > seconds;
}

/* Prints the rate of the frames in which something moved, "while WHAT", and their durations. */
static void print_frames(FrameTimer *timer, const char *what) {
    double moved = 0;
    qsort(timer->times, timer->count, sizeof *timer->times, order_rising);
    for (size_t i = 0; i < timer->count; i++)
        moved += timer->times[i];
    if (timer->count)
        printf("%.1f frames/s while %s (%zu frames), a frame takes %.1f ms (median), %.1f ms (99 of 100), ",
               (double)timer->count / moved, what, timer->count, MILLI * timer->times[timer->count / 2],
               MILLI * timer->times[timer->count * 99 / 100]);
}

static void print_machine(const FrameTimer *timer) {
    double passed = stopwatch_now() - timer->begun;
    FrameMachine machine = frame_timer_machine(timer);
    printf("simulating is %.1f %%, used %.2f of %ld processors, load %.1f\n", 100 * timer->worked / passed,
           machine.used, machine.processors, machine.load);
}

void frame_timer_print(FrameTimer *timer, const char *what, int width, int height) {
    printf("%s, %d x %d: first picture after %.2f s, ", what, width, height, timer->first);
    if (timer->moving > 0)
        printf("the first that moves after %.2f s, ", timer->moving);
    print_frames(timer, "something moves");
    if (timer->still_count)
        printf("%.1f frames/s while nothing does (%zu), ", (double)timer->still_count / timer->still_time,
               timer->still_count);
    print_machine(timer);
}

void frame_timer_print_pans(FrameTimer *timer) {
    print_frames(timer, "the view is moved");
    print_machine(timer);
}

void frame_timer_clear(FrameTimer *timer) {
    memory_free(timer->times);
    *timer = (FrameTimer){0};
}
