/* Turns by 180 degrees: a way that leads along a wall, round its end and back along its other side.
 *
 * Measured are the width of the path before the turn and after it, from wall to wall at a right angle to the wall that
 * is gone round, over the last 1.5 m beside it; and the width at the turn, from the end of that wall, at the middle of
 * its thickness, to the wall opposite. Left out are turns round furniture and turns through the opening of a door. */
#pragma once

#include "rules/ways.h"

/* A width from one wall to another. */
typedef struct TurnWidth {
    double width;  /* m, at most TURNROUND_WIDEST */
    Vec2 from, to; /* m, its ends */
} TurnWidth;

#define TURNROUND_WIDEST 3.0 /* m */

enum { TURN_BEFORE, TURN_AT, TURN_AFTER, TURN_PARTS };

typedef struct TurnRound {
    Vec2 end;                    /* m, the end of the obstacle */
    double narrow;               /* m, width of the obstacle */
    TurnWidth parts[TURN_PARTS]; /* least widths of all ways that turn here, in either direction */
} TurnRound;

typedef struct TurnRounds {
    TurnRound *list; /* (count) in the order in which the ways meet them */
    size_t count, capacity;
} TurnRounds;

/* Finds the turns round obstacles that are narrower than `narrower` m, in the outline of the walls alone. memory_free
 * releases the list. */
TurnRounds turnround_find(const House *house, const Outline *walls, const RuleWays *ways, double narrower);
