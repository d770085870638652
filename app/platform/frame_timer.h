/* Times the frames of the window: waits until the next one is due, and measures them for --benchmark-window. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#define FRAME_TIMER_RATE 60.0 /* frames per second, at most */

typedef struct FrameTimer {
    double last;   /* s of wall time, when the last frame began */
    double *times; /* (count) s that each frame took, while they are counted */
    size_t count, capacity;
    bool counting;
    double begun, worked; /* s: when counting began; the time spent simulating since */
    double processor;     /* s: processor time of all threads when counting began */
    double still_time;    /* s, of the counted frames in which nothing moved, */
    size_t still_count;   /* and their number */
    double first, moving; /* s, from the start of the program to the first frame, and to the first one that moved on;
                             0: there has been none */
} FrameTimer;

/* Waits until the next frame is due, unless `hurried`, and returns the wall time since the last one, s. */
double frame_timer_wait(FrameTimer *timer, bool hurried);

/* Records the duration of a frame, s, the part of it spent simulating, s, and whether it shows another time than the
 * frame before. */
void frame_timer_note(FrameTimer *timer, double seconds, double simulating, bool moves);

void frame_timer_count(FrameTimer *timer);

/* Begins to count, `age` s after the first turn, once something moves or does not in a long time. True: frames have
 * been counted for `seconds`. */
bool frame_timer_advance(FrameTimer *timer, double age, double seconds);

/* How busy the machine is, without which a measured time says little. */
typedef struct FrameMachine {
    double load;     /* programs that want to run, mean of the last minute; NAN: unknown */
    double used;     /* processors that this process has used since counting began, 1 */
    long processors; /* of the machine */
} FrameMachine;

FrameMachine frame_timer_machine(const FrameTimer *timer);

/* Prints frames per second, median and 99th percentile of their durations (of those in which something moves), and the
 * share of simulating, and how busy the machine is; `what` is the title of what is shown. */
void frame_timer_print(FrameTimer *timer, const char *what, int width, int height);
/* Prints the frames per second and their durations while the view was moved. */
void frame_timer_print_pans(FrameTimer *timer);
void frame_timer_clear(FrameTimer *timer);
