/* Doors as rules see them: the clear width of the opening, and the free spaces before it. All is measured in the
 * outline of the house with its doors open, not taken from the numbers of the file. */
#pragma once

#include "rules/rule_set.h"
#include "rules/ways.h"

/* A manoeuvring space: on one side of the door, as wide as the opening and `beyond` more. */
typedef struct DoorwaySpace {
    double depth; /* m, free before the opening and what is beyond it, up to what was asked for */
    double
        beyond; /* m, free beside the opening over the whole depth that was asked for; negative: not even before it */
    Vec2 from, to; /* m, the line that was measured: of the depth, or beside the opening where the depth is enough */
} DoorwaySpace;

/* The one who comes: from which side of the wall's direction, and how. */
typedef struct DoorwayUse {
    int side;     /* +1 from the left of the wall's direction, -1 from the right */
    int approach; /* RuleApproach: front from within 30 degrees of the normal, 1 m before the door or, on the side to
                     which its leaf opens, 1 m and the leaf's length; else from the side of the hinge or of the latch */
} DoorwayUse;

enum { DOORWAY_USES = 6 };

typedef struct Doorway {
    size_t door;
    double clear;     /* m, the clear width */
    Vec2 from, to;    /* m, on the two jambs */
    size_t rooms[2];  /* to the left and to the right of the wall's direction; SIZE_MAX: none */
    double spaces[2]; /* m, from the wall's face to the first wall before the door, as above; up to DOORWAY_DEEPEST */
    bool entrance;    /* True within DOORWAY_ENTRANCE of an exit */
    DoorwayUse uses[DOORWAY_USES]; /* (use_count) how the ways come to this door */
    size_t use_count;
} Doorway;

#define DOORWAY_DEEPEST 5.0   /* m */
#define DOORWAY_ENTRANCE 0.75 /* m */

/* Measures one door with the ways that lead through it. */
Doorway doorway_measure(const House *house, const RuleWays *ways, size_t door);

/* True if a person who comes from this side pulls. */
bool doorway_pulls(const Door *door, int side);

/* Measures the space before the door on a side: `depth` deep, `beyond` wide beside the latch, or beside the hinge. */
DoorwaySpace doorway_space(const House *house, const Doorway *doorway, int side, double depth, double beyond,
                           bool at_hinge);
