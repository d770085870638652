/* Does chaos last? Many motions are started on a motion that looks chaotic, at its own states moved by a millionth,
 * and watched for thousands of cycles. If some settle on a stable orbit, what looked like chaos was a transient; the
 * orbits are certified as any others, and half_life.h says how long it lasts. What they do until then says how many
 * cycles a largest peak rests on. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "cycle/extreme.h"
#include "cycle/half_life.h"
#include "cycle/section.h"

/* Motions that are watched, and cycles of each, where thousands of cycles cost next to nothing. */
enum { SURVIVAL_LANES = 64, SURVIVAL_CYCLES = 20000 };

enum { SURVIVAL_ATTRACTORS_MOST = 8, SURVIVAL_AHEAD = 1000000 };

/* An orbit that lanes settle on. An orbit and its mirror image, whose peaks are the same, are one. */
typedef struct SurvivalAttractor {
    size_t period;
    double peak;    /* N, the largest; 0: without contact */
    double largest; /* |multiplier| */
    size_t lanes;   /* that reach it */
} SurvivalAttractor;

/* How many cycles until a lane's largest peak is within a share of the largest of all lanes. */
typedef struct SurvivalWait {
    double median, most;   /* cycles, of the lanes; most: 95 % of them; HUGE_VAL: they did not within their cycles */
    size_t reached, lanes; /* lanes that did, of so many that did not settle */
} SurvivalWait;

typedef struct Survival {
    size_t lanes, cycles;   /*0 lanes: not run */
    size_t settled, failed; /* lanes; failed: chattered or diverged */
    double risk;            /* cycles after lane_apart during which lanes could settle, of all lanes */
    HalfLife half_life;
    SurvivalAttractor attractors[SURVIVAL_ATTRACTORS_MOST];
    size_t attractor_count;
    double largest;         /* N, of all lanes before they settled */
    SurvivalWait within[2]; /* 5 % and 1 % of it */
    Extreme extreme;        /* largest in SURVIVAL_AHEAD cycles */
    bool whole;             /* false: interrupted, and nothing is known */
} Survival;

typedef struct SurvivalTask {
    size_t lanes, cycles;
    int jobs; /* the result does not depend on it */
    const Stop *stop;
} SurvivalTask;

enum { SURVIVAL_USUAL = -1 /* number of lanes: the kind's */ };

/* Returns the task of watching so many lanes, or SURVIVAL_USUAL, for as long as the kind does. */
SurvivalTask survival_task(const CycleKind *kind, int lanes, int jobs, const Stop *stop);

/* Watches lanes that start at the states of a section. */
Survival survival_run(Cycle cycle, const Section *section, const SurvivalTask *task);
