/* Where a person is on the track, and what the track asks for there. */
#pragma once

#include <stddef.h>

#include "house/track.h"
#include "house/world.h"

/* m: a part of the path counts as done this near to its end. */
#define PLACE_ARRIVED 0.01
/* m/s: slowest target speed before the end of the path, so that no chair creeps for ever. */
#define PLACE_SLOWEST 0.03
/* m, assumed: how far a person backs off. */
#define PLACE_RETREAT 0.25

/* Position of a person relative to the track. */
typedef struct Place {
    const TrackPoint *here, *next; /* next == here at the end */
    Vec2 along;                    /* unit, the path's direction of travel */
    double heading;                /* rad, of the track */
    double curvature, bending;     /* rad/m and rad/m2, its first and second derivative by way */
    double even, even_bending;     /* the same, averaged over some 0.1 m either way (TrackPoint) */
    double speed;                  /* m/s, the track's limit */
    double hurry;                  /* m/s2, its change when it is driven */
} Place;

/* Returns the direction of the step that begins at a point; at the end that of the last one. */
int place_direction(const Track *track, size_t index);

/* Passes to the next point; a change between forwards and backwards takes its time. */
void place_pass(const Track *track, const Profile *profile, Drive *drive);

/* Advances along the track to the reference point, which moves at `speed` m/s, and measures the offset. */
Place place_find(const Track *track, const Profile *profile, Vec2 at, double speed, Drive *drive);
