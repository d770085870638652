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

/* Returns the class of a response. An interrupted one is undetermined. */
MotionClass motion_class_of(const Response *response);

/* Returns the class of a motion from its record alone: `period` as from section_period, `touches` if there was contact.
 */
MotionClass motion_class_of_record(CycleStatus status, int period, bool touches);
