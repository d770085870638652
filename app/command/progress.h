/* Ctrl-C and progress, for whatever takes time. */
#pragma once

#include <signal.h>
#include <stdbool.h>

#include "options/options.h"

/* Set by Ctrl-C. A second Ctrl-C ends the program at once. */
extern volatile sig_atomic_t progress_interrupted;

/* Handles Ctrl-C and SIGTERM from here on. */
void progress_catch_signals(void);

/* True if progress is printed to standard error: when that is a terminal and --quiet is not given, or when
 * $CLEARANCE_PROGRESS is set, as by a window that shows how far its export is. Each message begins with a carriage
 * return and holds no line break. */
bool progress_is_shown(const Options *options);
