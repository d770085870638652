/* Corridors: stretches of a way, between doors, that are less than 2 m wide for more than 1 m.
 *
 * The width at a place of a way is the distance from wall to wall through that place, at a right angle to the nearer
 * wall. Left out are places where no wall stands square to the way (at corners), those in a door's opening and 5 cm
 * beside it, and those whose line leads through another opening. A room with one door in which a way begins is no
 * corridor. Furniture does not count for a rule; the width between everything that stands there is told apart. Rails
 * are pieces of furniture with "rail" in their name or id: they are noted, for rules that mention them. */
#pragma once

#include "rules/ways.h"

#define CORRIDOR_WIDEST 2.0   /* m */
#define CORRIDOR_SHORTEST 1.0 /* m */

/* A width at a place. */
typedef struct CorridorWidth {
    Vec2 at;
    Vec2 from, to;   /* m, on the two walls */
    double width;    /* m */
    double rails[2]; /* m, by which a rail stands out from the wall at `from` and at `to`; 0: none does */
    double s;        /* m, along its way; each way begins at 0 */
} CorridorWidth;

typedef struct Corridor {
    CorridorWidth *widths; /* (count) */
    size_t count, capacity;
    size_t narrowest; /* index in widths, from wall to wall */
    double furnished; /* m, least width between everything that stands there, where that is less; or the width */
    size_t room;      /* in which the narrowest place lies; SIZE_MAX: none */
} Corridor;

typedef struct Corridors {
    Corridor *list; /* (count) in the order in which the ways meet them */
    size_t count, capacity;
    /* Which corridor covers a cell of the plan, from 1; 0: none. */
    int *covered; /* (ny x nx) */
    int nx, ny;
    double cell; /* m */
    Vec2 origin;
} Corridors;

/* Measures the corridors on the ways. `walls` is the outline of the walls alone: in that of the house, a wall has no
 * face where a piece stands against it. corridor_free_all releases the corridors. */
Corridors corridor_measure_all(const House *house, const Outline *walls, const RuleWays *ways);
void corridor_free_all(Corridors *corridors);

/* Returns the corridor that covers a place to about half a metre, or SIZE_MAX. */
size_t corridor_at(const Corridors *corridors, Vec2 at);

/* Returns the width at a place, m, between rails of which `allowed` m on either side do not count; 0: no rail counts.
 */
double corridor_width_between_rails(const CorridorWidth *width, double allowed);

/* Returns the index of the narrowest place by that width; the middle one of several. */
size_t corridor_narrowest_between_rails(const Corridor *corridor, double allowed);

/* Returns the length of the way, m, of the longest stretch that is narrower than `least` m by that width. */
double corridor_narrow_stretch(const Corridor *corridor, double least, double allowed);
