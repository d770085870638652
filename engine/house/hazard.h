/* Dangerous points: places where bodies come near, touch hard or lose time, ranked.
 *
 * Every chair's path is cut into stretches; each stores its least clearance, hardest contact and lost time. Data of
 * walkers are collected by squares of the floor instead, and their clearance is that from obstacles. A stretch that
 * exceeds a threshold (run.clearance_warning, run.force_warning, run.loss_warning) is dangerous, and its score is
 *
 *     (threshold - clearance) / threshold, at least 0  +  peak force / threshold  +  lost time / threshold
 *
 * Nearby stretches of all people form one hazard. */
#pragma once

#include <stddef.h>

#include "base/vec2.h"
#include "house/house.h"

/* m: length of a stretch, and largest distance of stretches in one hazard. */
#define HAZARD_STRETCH 0.25
#define HAZARD_RADIUS 0.75

enum {
    HAZARDS_MOST = 9,  /* number of hazards in the ranking */
    HAZARD_ALONE = -2, /* in place of a person: a chair had nothing near it */
};

/* Data of one chair on one stretch, or of all walkers on one square. */
typedef struct Stretch {
    Vec2 at;           /* m, where the body was nearest to an obstacle or a person */
    int other;         /* the nearest person; -1: an obstacle; or HAZARD_ALONE */
    double clearance;  /* m */
    double peak_force; /* N */
    double lost_time;  /* s */
    double impact;     /* m/s, fastest contact begun, of a chair */
    double energy;     /* J, of all of them */
} Stretch;

typedef struct Hazard {
    Vec2 at;           /* m */
    char what[96];     /* "door d2", "wardrobe (f3)", "wall w1", "person p2", "free space" */
    double score;      /* 1 */
    double clearance;  /* m, least; infinite: nothing came near */
    double peak_force; /* N, largest contact */
    double lost_time;  /* s, lost here by all people together */
    double impact;     /* m/s, fastest contact begun, of a chair */
    double energy;     /* J, of all of them */
} Hazard;

/* Ranks the hazards among `count` stretches, worst first; returns their number, at most HAZARDS_MOST. */
size_t hazard_rank(Hazard hazards[HAZARDS_MOST], const Stretch *stretches, size_t count, const House *house);
