/* Ctrl-C and progress, for whatever takes time. */
#pragma once

#include <stdbool.h>

#include "base/stop.h"
#include "options/options.h"

/* Ctrl-C requests this stop. A second Ctrl-C ends the program at once; signals that come within
 * 0.3 s of the first one count as one, since a whole group of processes is often sent the same signal twice. */
extern Stop progress_stop;

/* True after Ctrl-C. */
bool progress_interrupted(void);

/* Handles Ctrl-C and SIGTERM from here on. */
void progress_catch_signals(void);

/* True if progress is printed to standard error: when that is a terminal and --quiet is not given, or when
 * $CLEARANCE_PROGRESS is set, as by a window that shows how far its export is. Each message begins with a carriage
 * return and holds no line break. */
bool progress_is_shown(const Options *options);
