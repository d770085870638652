/* Makes a searched track easy to drive: see smooth.c. */
#pragma once

#include "route/search.h"

/* Replaces the poses of `track` by smooth ones about 5 cm apart, with their clearances filled in. The poses at the
 * indices `pins` (pin_count, rising), changes of direction and turns on the spot stay unchanged. */
void smooth_track(SearchTrack *track, const FreeSpace *space, const Rectangle *body, const size_t *pins,
                  size_t pin_count);

/* Returns a place between two poses of the same direction of travel, at the fraction `part` (0 to 1), on the cubic with
 * their headings as tangents. */
Vec2 smooth_between(const Pose *a, const Pose *b, int direction, double part);
