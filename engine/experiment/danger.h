/* Where bodies and hands touch something, and how hard: the touches of one run, or of many drivers, place by place.
 *
 * A place gathers touches that are nearer to each other than DANGER_NEAR, those of hands apart from those of bodies.
 * Speed, energy and squeeze rank, not the force that the contact law makes of them: places stand by the energy that a
 * run is expected to have there (the sum over all drivers, divided by their number), then by the share of drivers who
 * touch, then by the speed that 95 % of those stay below. Hands follow, ranked alike: what clamps them is a hazard of
 * its own. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "experiment/drivers.h"
#include "study/montecarlo.h"

#define DANGER_NEAR 0.4 /* m */

typedef struct DangerPlace {
    Vec2 at;        /* m, of its fastest touch */
    char what[96];  /* "door d2" */
    int part;       /* BodyPart, of the fastest touch */
    Share share;    /* of the drivers who touch here */
    double speed95; /* m/s, of the fastest touch of each of them */
    double fastest; /* m/s */
    double mass;    /* kg, the effective mass of the fastest touch */
    double energy;  /* J, expected in a run */
    double impulse; /* N s, greatest of a touch */
    double squeeze; /* N, greatest */
    bool *by;       /* (number of drivers) True for the drivers, of whichever person, who touch here */
} DangerPlace;

typedef struct Danger {
    DangerPlace *places; /* (count) worst first */
    size_t count;
    size_t drivers;
    Share hands; /* of the drivers who have a hand space that meets something, where they have hands at the rims */
} Danger;

/* The places of the drivers of one person; SIZE_MAX: of all people, each driver of each person counting. danger_free
 * releases the result. */
Danger danger_of_drivers(const House *house, const Drivers *drivers, size_t person);

/* The places of a person in one run. */
Danger danger_of_run(const House *house, const Observation *observation, size_t person);

void danger_free(Danger *danger);

/* Limits ---------------------------------------------------------------------------------------------------------- */

#define DANGER_KNOCK 0.1 /* m/s, assumed: from here on a touch is a knock, */
#define DANGER_BLOW 0.3  /* m/s, assumed: and a blow */

/* Returns "touch", "knock" or "blow". */
const char *danger_word(double speed);

/* The pain limits of a part of the body, of healthy adults beside robots. */
typedef struct DangerLimit {
    const char *part;     /* "hand", "forearm" */
    double still, impact; /* N, clamped and in an impact */
    double stiffness;     /* N/m */
    const char *status;   /* "read second-hand" */
    const char *source;
} DangerLimit;

enum { DANGER_LIMITS = 4 };
extern const DangerLimit danger_limits[DANGER_LIMITS];

/* Returns the speed, m/s, at which a chair of a mass, kg, presses a clamped part with a force, N: m v^2 = F^2 / k. */
double danger_clamp_speed(double force, double mass, double stiffness);

/* The sentence that stands beside the limits wherever they are shown. */
extern const char danger_caveat[];
