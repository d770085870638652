/* Chairs among people: what obstacles and others do to bodies that have a shape. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "space/gap.h"

enum { RIDE_SLIPS = 10 /* gaps between two bodies at once: a corner of one, or a side, for each of the other's */ };

/* A chair and somebody near it: `a` drives; where both do, a < b. */
typedef struct RidePair {
    uint32_t a, b; /* people */
    int slip_count;
    Slip slips[RIDE_SLIPS];
} RidePair;

typedef struct Rides {
    RidePair *pairs; /* (count) by a, as the slots of b come */
    size_t count, capacity;
    RidePair *old; /* of the lists before these */
    size_t old_capacity;
    double widest; /* m, largest distance of a body's edge from its mass centre */
    double sight;  /* m, farthest that anybody looks for gaps */
} Rides;

struct World;

void ride_init(Rides *rides, const struct World *world);
void ride_copy(Rides *to, const Rides *from);
void ride_clear(Rides *rides);

/* Lists anew who is near which chair. */
void ride_list(struct World *world);

/* Fills force, moment, ring, ring_moment and sense of every chair, and what they do to walkers in walkers.push; senses
 * of walkers are felt into when `senses`. */
void ride_gather_forces(struct World *world, bool senses);
