/* The speeds along a way: what limits them at each of its stations, and what the way then costs. See speeds.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "plan/profile.h"
#include "route/way.h"

/* A way and who takes it; everything is borrowed. */
typedef struct Course {
    const Way *way;
    const FreeSpace *space;
    const Rectangle *body;
    const Profile *profile;
    double margin; /* m, the least clearance that is allowed */
    double sight;  /* m: larger clearances are not measured */
    bool centring; /* True if the personal space has its price */
} Course;

/* The numbers of each station; `cost` is that of the step to the next one. */
typedef struct Speeds {
    double *clearance;            /* m, the least of the station and the step after it */
    double *left, *right;         /* m, of the station, while centring */
    double *heading;              /* rad */
    double *braking, *starting;   /* m/s2, that the driver plans with */
    double *limit, *back, *speed; /* m/s */
    double *time, *cost;          /* s */
} Speeds;

/* Stations on either side of one over which its curvature is the mean. */
enum { SPEEDS_SPAN = 2 };

/* Return zeros for `count` stations, which speeds_free frees. */
Speeds speeds_make(size_t count);
void speeds_free(Speeds *speeds);

/* Fills in headings and clearances of the stations low to high. Returns false if one is below the margin. */
bool speeds_look(const Course *course, Speeds *to, size_t low, size_t high);

/* Computes the limits of the stations low to high, whose headings and clearances are known, and then the speeds, times
 * and costs as far as they change: in [*first, *last]. `from` holds the values elsewhere, and may be the same as `to`
 * where all stations are asked for. */
void speeds_run(const Course *course, const Speeds *from, Speeds *to, size_t low, size_t high, size_t *first,
                size_t *last);

/* Copies the numbers of the stations low to high. */
void speeds_copy(const Course *course, Speeds *to, const Speeds *from, size_t low, size_t high);

/* Returns the turn from one station to a later one of the same piece, rad. */
double speeds_turn(const Speeds *speeds, size_t a, size_t b);

/* Returns the time that the joint before piece k costs, s: turns on the spot and a change of direction. */
double speeds_at_joint(const Course *course, size_t k);

/* Returns the sum of the times or costs of the steps between the stations low and high, s. */
double speeds_sum(const double *steps, size_t low, size_t high);
