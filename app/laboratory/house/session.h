/* The House laboratory at work: see live.h. A house is read, planned and run to its end on a thread, the same way as
 * `clearance run` does it, and played from what is recorded; a change of a parameter is another run. */
#pragma once

#include "laboratory/laboratory.h"

/* What can be selected, in the order in which they follow one another. */
typedef enum HouseItem {
    HOUSE_NOTHING,
    HOUSE_PERSON,
    HOUSE_HAZARD,
    HOUSE_DOOR,
    HOUSE_FURNITURE,
    HOUSE_WALL,
    HOUSE_EXIT,
    HOUSE_STOP, /* where a person is stopped; not among those that follow one another */
    HOUSE_THINGS,
} HouseItem;

/* Of all states of the run that is shown; 0 while it, or another one that has been asked for, is in work. */
uint64_t house_session_digest(const void *live);
