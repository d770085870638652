/* Follows the orbit of a running beam along its orbit diagram. */
#pragma once

#include "laboratory/machine/lines.h"

/* Follows the orbit that a motion from `state` (count; none: from rest) settles on, over a parameter from `from` to
 * `to`. Returns false if it was stopped; `lines` receives the rest, with the reason where no orbit was found. */
bool beam_lines_follow(const Machine *machine, const double *state, size_t count, const char *name, double from,
                       double to, MachineLines *lines, const Stop *stop);
