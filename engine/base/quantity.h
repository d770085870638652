/* A number as a user types it: a comma counts as a point, a unit of the same kind may follow (250cm, 2500 mm, 8 ft 2
 * in), and numbers may be added and subtracted (1.2+0.91). */
#pragma once

#include <stdbool.h>

enum { QUANTITY_REASON = 96 };

/* Reads `words` as a number in `unit`, which is assumed where none is written; "" or NULL means a pure number. Returns
 * false, with the reason in `reason` and the value unchanged, if it is not a number. */
bool quantity_read(const char *words, const char *unit, double *value, char reason[QUANTITY_REASON]);
