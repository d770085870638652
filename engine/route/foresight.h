/* The passage ahead of a driver and behind, for the planning of a path and for the drive along it: see foresight.c. */
#pragma once

#include <stddef.h>

#include "plan/profile.h"

/* m, assumed: a door's leaf or a corner slows a driver this far before and after it. */
#define FORESIGHT_REACH 0.2

/* Numbers of the places along a path, `count` of them; borrowed. */
typedef struct Foresight {
    const double *left, *right; /* m, room on either side of the body's middle */
    const double *heading;      /* rad, of the body */
    const double *step;         /* m, to the next place; 0 where the path turns on the spot or changes its direction */
    const double *edge;         /* 1, the part of that step at which the room becomes that of the next place */
    size_t count;
} Foresight;

/* Returns the width of the passage, m, after a part of the step from one place to the next, 0 to 1. */
typedef double (*ForesightWidth)(const void *context, double part);

/* Returns the part of a step at which the passage becomes that of the next place, from the widths at both ends, m. */
double foresight_edge(double here, double next, ForesightWidth width, const void *context);

/* Returns the width of the passage at a place, m: the least within FORESIGHT_REACH, and where the body's axis stays
 * parallel to 20 degrees the least room on the left and the least on the right together: across a thin wall no ray of a
 * body that passes askew meets both jambs of a door. */
double foresight_width(const Foresight *foresight, size_t place);

/* Returns the speed, m/s, up to `free`, that the passage allows at a place, from where a driver can slow down by
 * `braking` m/s2, or has sped up by `starting` m/s2, between the edges of what is narrower and the reach. */
double foresight_speed(const Foresight *foresight, size_t place, const Profile *profile, double free, double starting,
                       double braking);
