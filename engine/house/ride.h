/* Chairs among people: the forces of obstacles and people on bodies that have a shape. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "space/gap.h"

enum {
    RIDE_SLIPS = 10 /* simultaneous gaps between two bodies: one for each corner or side of one and of the other */
};

/* A chair and a nearby person: `a` is in a chair; if both are, a < b. */
typedef struct RidePair {
    uint32_t a, b; /* indices of people */
    int slip_count;
    Slip slips[RIDE_SLIPS];
} RidePair;

typedef struct Rides {
    RidePair *pairs; /* (count) ordered by a, then by the slot of b */
    size_t count, capacity;
    RidePair *old; /* pairs of the previous lists */
    size_t old_capacity;
    double widest; /* m, largest distance of a body's edge from its mass centre */
    double sight;  /* m, largest distance up to which a body's gaps are computed */
} Rides;

struct World;

void ride_init(Rides *rides, const struct World *world);
void ride_copy(Rides *to, const Rides *from);
void ride_clear(Rides *rides);

/* Lists again the people near each chair. */
void ride_list(struct World *world);

/* Fills in force, moment, ring, ring_moment and sense of every chair, and the forces on walkers in walkers.push;
 * `senses`: also updates the senses of walkers. */
void ride_gather_forces(struct World *world, bool senses);
