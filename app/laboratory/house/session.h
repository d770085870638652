/* The House laboratory: see laboratory.h. A house is read, planned and run to its end on a thread, the same way as
 * `clearance run` does it, and played from what is recorded; a change of a parameter is another run. */
#pragma once

#include "laboratory/house_items.h"
#include "laboratory/laboratory.h"

/* Returns the digest of all states of the displayed run; 0 while this or another run is in work. */
uint64_t house_session_digest(void *session);
