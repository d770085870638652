/* The speeds along a way: what limits them at each of its stations, and what the way then costs. See speeds.c. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "plan/profile.h"
#include "route/pace.h"
#include "route/way.h"

/* A way and who takes it; everything is borrowed. */
typedef struct Course {
    const Way *way;
    const FreeSpace *space;
    const Rectangle *body;
    const Profile *profile;
    Agility agility; /* of the profile */
    double margin;   /* m, the least clearance that is allowed */
    double sight;    /* m: larger clearances are not measured */
    bool centring;   /* True if the personal space has its price */
} Course;

/* The numbers of each station; `time` and `cost` are those of the step to the next one. */
typedef struct Speeds {
    double *own;                  /* m, the clearance of the station */
    double *clearance;            /* m, the least of the station and the step after it */
    double *left, *right;         /* m, of the station, while centring */
    double *room_left;            /* m, of the passage at the station, where it can limit the speed */
    double *room_right;           /* m */
    double *length;               /* m, of the step to the next station of its piece */
    double *edge;                 /* 1, the part of that step at which the passage changes (foresight.h) */
    double *heading;              /* rad */
    double *bend;                 /* rad/m, only about what speeds_run was asked for */
    double *braking, *starting;   /* m/s2, that the driver plans with */
    double *limit, *back, *speed; /* m/s */
    double *time, *cost;          /* s */
} Speeds;

/* Return zeros for `count` stations, which speeds_free frees. */
Speeds speeds_make(size_t count);
void speeds_free(Speeds *speeds);

/* What changes where the stations begin to end have moved or turned. `from` holds the numbers from before, `to` gets
 * those that may be others now; the two may be the same where all stations are asked for.
 *
 * speeds_look fills in headings and clearances, and returns false if a clearance of these stations, or of a step from
 * or to one, is below the margin. speeds_run then computes the limits, and the speeds, times and costs as far as they
 * change: at the stations [*first, *last] and on the steps between them. speeds_take takes these over, if the change
 * is to stay. */
bool speeds_look(const Course *course, const Speeds *from, Speeds *to, size_t begin, size_t end);
void speeds_run(const Course *course, const Speeds *from, Speeds *to, size_t begin, size_t end, size_t *first,
                size_t *last);
void speeds_take(const Course *course, Speeds *to, const Speeds *from, size_t first, size_t last);

/* Returns the turn from one station to a later one of the same piece, rad. */
double speeds_turn(const Speeds *speeds, size_t a, size_t b);

/* Returns the time that the joint before piece k costs, s: turns on the spot and a change of direction. */
double speeds_at_joint(const Course *course, size_t k);

/* Returns the sum of the times or costs of the steps between the stations low and high, s. */
double speeds_sum(const double *steps, size_t low, size_t high);
