/* A number as a person types it: a comma is a point, a unit of the same kind may follow (250cm, 2500 mm, 8 ft 2 in),
 * and numbers may be added and subtracted (1.2+0.91). */
#pragma once

#include <stdbool.h>

enum { QUANTITY_REASON = 96 };

/* Reads `words` as a number of `unit`, which a number without one has; "" or NULL is a pure number. False: it is none,
 * `reason` says why, and the value is as it was. */
bool quantity_read(const char *words, const char *unit, double *value, char reason[QUANTITY_REASON]);
