/* The classes of motion in words, which are the same wherever a motion is told: in answers, tables, maps and the
 * window. */
#pragma once

#include <stdbool.h>

#include "cycle/response.h"

typedef enum MotionClass {
    MOTION_CLASS_FREE, /* without contact */
    MOTION_CLASS_PERIODIC,
    MOTION_CLASS_QUASI_PERIODIC,
    MOTION_CLASS_CHAOTIC,
    MOTION_CLASS_TRANSIENT,
    MOTION_CLASS_UNDETERMINED,
    MOTION_CLASS_CHATTERS,
    MOTION_CLASS_DIVERGED,
    MOTION_CLASS_NOT_PERIODIC, /* of quick runs, which do not tell what it is instead */
    MOTION_CLASSES,
} MotionClass;

/* (MOTION_CLASSES) "without contact", "periodic", ... */
extern const char *const motion_class_names[MOTION_CLASSES];

/* Returns the class of a response. One that is interrupted or too stiff is undetermined. */
MotionClass motion_class_of(const Response *response);

/* Largest relative variation of the peaks of a quasi-periodic motion that counts as regular. */
#define MOTION_CLASS_EVEN 0.1

/* Cycles: a transient of a longer half-life counts as irregular. */
#define MOTION_CLASS_LASTS 1000.0

/* Returns the half-life of a transient, or what is known to be below it, in cycles. */
double motion_class_life(const Response *response);

/* True if a motion counts as regular where a design's type is asked: periodic, on a torus with peaks that hardly vary,
 * or a transient that is soon over. */
bool motion_class_is_regular(const Response *response);

/* Returns the period of the orbit that a motion is on, or that most of the motions started on it settle on, with its
 * largest force (N; NAN: none); 0: none. */
size_t motion_class_attractor(const Response *response, double *peak);

/* Returns the class of a motion from its record alone: `period` as from section_period, `touches` if there was contact.
 */
MotionClass motion_class_of_record(CycleStatus status, int period, bool touches);
