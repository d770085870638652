/* How quickly pictures come: what --benchmark-window prints, and what keeps them apart. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#define FRAME_TIMER_RATE 60.0 /* pictures a s, at most */

typedef struct FrameTimer {
    double last;   /* s on the wall, when the last picture was begun */
    double *times; /* (count) s, that the pictures took, when they are being counted */
    size_t count, capacity;
    bool counting;
    double begun, worked; /* s: when counting began; that simulating took since */
    double first;         /* s, from the program's beginning to the first picture; 0: there has been none */
} FrameTimer;

/* Waits until the next picture is due, unless nobody waits for it (`hurried`); returns the s on the wall since the
 * last.
 */
double frame_timer_wait(FrameTimer *timer, bool hurried);

/* A picture took so many s, of them so many for simulating. */
void frame_timer_note(FrameTimer *timer, double seconds, double simulating);

/* The first picture is shown now. */
void frame_timer_note_first(FrameTimer *timer);

void frame_timer_count(FrameTimer *timer);

/* Prints pictures a s, median and 99th percentile, and the share of simulating; `what` is measured. */
void frame_timer_print(FrameTimer *timer, const char *what, int width, int height);
void frame_timer_clear(FrameTimer *timer);
