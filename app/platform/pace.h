/* How quickly pictures come: what --benchmark-window prints, and what keeps them apart. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#define PACE_RATE 60.0 /* pictures a s, at most */

typedef struct Pace {
    double last;   /* s on the wall, when the last picture was begun */
    double *times; /* (count) s, that the pictures took, when they are being counted */
    size_t count, capacity;
    bool counting;
    double begun, worked; /* s: when counting began; that simulating took since */
    double first;         /* s, from the program's beginning to the first picture; 0: there has been none */
} Pace;

/* Waits until the next picture is due, unless nobody waits for it (`hurried`); returns the s on the wall since the
 * last.
 */
double pace_wait(Pace *pace, bool hurried);

/* A picture took so many s, of them so many for simulating. */
void pace_note(Pace *pace, double seconds, double simulating);

/* The first picture is shown now. */
void pace_note_first(Pace *pace);

void pace_count(Pace *pace);

/* Prints pictures a s, median and 99th percentile, and the share of simulating; `what` is measured. */
void pace_print(Pace *pace, const char *what, int width, int height);
void pace_clear(Pace *pace);
