/* The House laboratory: see laboratory.h. A house is read, planned and run to its end on a thread, as by `clearance
 * run`, and played from the record; a change of a parameter starts another run. */
#pragma once

#include "laboratory/house_items.h"
#include "laboratory/laboratory.h"

/* Returns the digest of all states of the displayed run; 0 while a run is in progress. */
uint64_t house_session_digest(void *session);
