/* The House laboratory at work: see live.h. A house is read, planned and run to its end on a thread, the same way as
 * `clearance run` does it, and played from what is recorded; a change of a parameter is another run. */
#pragma once

#include "laboratory/house_items.h"
#include "laboratory/laboratory.h"

/* Of all states of the run that is shown; 0 while it, or another one that has been asked for, is in work. */
uint64_t house_session_digest(void *live);
