/* Dangerous points: places where bodies come near, touch hard or lose time, ranked.
 *
 * Every chair's way is cut into stretches; each keeps its least clearance, hardest contact and lost time. What happens
 * to people on foot is put together by squares of the floor instead, and their clearance is that from obstacles. What
 * that exceeds a threshold (run.clearance_warning, run.force_warning, run.loss_warning) is dangerous, and its score is
 *
 *     (threshold - clearance) / threshold, at least 0  +  peak force / threshold  +  lost time / threshold
 *
 * Stretches of all people near one another make one hazard. */
#pragma once

#include <stddef.h>

#include "base/vec2.h"
#include "house/house.h"

/* m: length of a stretch, and how far apart stretches of one hazard may be. */
#define HAZARD_STRETCH 0.25
#define HAZARD_RADIUS 0.75

enum { HAZARDS_MOST = 9 /* ranked; the rest would not be read */ };

/* What one chair met on one stretch, or all walkers on one square. */
typedef struct Stretch {
    Vec2 at;           /* m, where the body was nearest to something */
    int other;         /* the person it was nearest to, or -1: an obstacle */
    double clearance;  /* m */
    double peak_force; /* N */
    double lost_time;  /* s */
} Stretch;

typedef struct Hazard {
    Vec2 at;           /* m */
    char what[96];     /* "door d2", "wardrobe (f3)", "wall w1", "person p2" */
    double score;      /* 1 */
    double clearance;  /* m, least; infinite: nobody was near to anything */
    double peak_force; /* N, largest contact */
    double lost_time;  /* s, lost around here, by all together */
} Hazard;

/* Ranks the hazards among `count` stretches, worst first; returns how many, at most HAZARDS_MOST. */
size_t hazard_rank(Hazard hazards[HAZARDS_MOST], const Stretch *stretches, size_t count, const House *house);
