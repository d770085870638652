/* The motion of the beam's tip in its clearance: exact within a regime, from switch to switch.
 *
 *        lower contact      |<-- 2 clearance -->|      upper contact       deflection d of the tip, up
 *      LOWER, LOWER_LEAVING        OPEN               UPPER, UPPER_LEAVING
 *
 * Contact: the force k (d - g) + c d' pushes the tip back. Released at zero force, the spring has not yet recovered:
 * the tip flies free inside the wall (LEAVING) until it is out of it, or is touched again. Released at the gap, it is
 * OPEN at once. Switches are roots of sums of exponentials and a sinusoid: bracketed by cells of a quarter of the
 * shortest period of any mode (shorter ones after a switch, where something decays faster), with the extrema inside
 * them when the rate changes sign, then Newton's to 1e-15 s.
 *
 * A motion can carry tangent vectors: deviations of the state, to first order. At a switch whose force jumps by c d',
 * one jumps by S = I -+ [0; c b] [b'/Omega, 0] (saltation; its determinant is 1), elsewhere by nothing. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "beam/rig.h"

typedef enum MotionPlace {
    MOTION_OPEN,
    MOTION_UPPER,
    MOTION_LOWER,
    MOTION_UPPER_LEAVING,
    MOTION_LOWER_LEAVING,
    MOTION_PLACES,
} MotionPlace;

typedef enum MotionStatus {
    MOTION_GOOD,
    MOTION_CHATTERS, /* more than MOTION_SWITCHES_MOST switches in one cycle: the motion stands there */
    MOTION_DIVERGED, /* a number is not finite */
} MotionStatus;

enum { MOTION_SWITCHES_MOST = 1000 /* in a cycle of the drive: a beam that impacts makes some ten */ };

/* What is read at one moment. */
typedef struct MotionReading {
    double sine, cosine;                          /* of omega phase */
    double value[REGIME_ROWS], rate[REGIME_ROWS]; /* of the rows that matter in the place */
} MotionReading;

/* What changes. One memory, so that it can be copied whole. */
typedef struct Motion {
    const Rig *rig;
    MotionPlace place;
    MotionStatus status;
    size_t cycle; /* of the drive, since the start */
    double phase; /* s, in the cycle */
    double since; /* s, since the last switch */
    MotionReading now;
    RegimeVector z;       /* (blocks) without the steady part */
    RegimeVector tangent; /* (tangents x blocks) */
    size_t tangents;

    size_t switches, cycle_switches; /* since the start; in this cycle */
    size_t grazes;                   /* extrema within MOTION_GRAZE of the wall, counted since the start */
    double contact_time;             /* s, in contact since the start */
    double peak[2]; /* N, largest force on the upper and on the lower contact since they were last set to 0 */
    bool unwatched; /* peaks are not looked for, which saves time */

    RegimeVector next, factor, trial;
    double *memory;
    size_t memory_size; /* doubles */
} Motion;

#define MOTION_GRAZE 1e-6 /* of the clearance: nearer than this to the wall without touching, or as deep in it */

/* A motion that rests at phase 0, with room for tangents (count). */
Motion motion_create(const Rig *rig, size_t tangents);
void motion_destroy(Motion *motion);

/* Makes `to`, of the same rig and number of tangents, what `from` is. */
void motion_copy(Motion *to, const Motion *from);

/* The state (omega q, q') (2 n), sqrt(J). Setting one begins a cycle, at phase 0, in the place that the state tells. */
void motion_state(const Motion *motion, double *state);
void motion_set_state(Motion *motion, const double *state);

/* A motion at phase 0, but for its tangents and for what it counts, as numbers (motion_saved_size of its rig):
 * restored, it goes on with the same bits, which a state, being computed from it, does not promise. A cycle begins. */
size_t motion_saved_size(const Rig *rig);
void motion_save(const Motion *motion, double *saved);
void motion_restore(Motion *motion, const double *saved);

/* Tangent vector `index`, as a state. */
void motion_tangent(const Motion *motion, size_t index, double *tangent);
void motion_set_tangent(Motion *motion, size_t index, const double *tangent);

/* Makes tangent i the i-th unit vector. */
void motion_unit_tangents(Motion *motion);

/* Goes on to the next switch, to the end of a cell or by `longest` s, whichever is first; returns the time gone on.
 * Switches, when there is one, at its end. */
double motion_step(Motion *motion, double longest);

/* As motion_step by a whole cell, whose end, if nothing switches before, is known: its blocks in `next`, and `end`. */
double motion_step_known(Motion *motion, MotionReading *end);

/* Goes on to the end of the cycle, phase 0. */
MotionStatus motion_cycle(Motion *motion);

/* Begins the next cycle, when steps have made a whole one. */
MotionStatus motion_end_cycle(Motion *motion);

/* m, m/s of the tip. */
double motion_deflection(const Motion *motion);
double motion_velocity(const Motion *motion);

/* N, of the joint on the tip: negative at the upper contact. */
double motion_force(const Motion *motion);

static inline bool motion_in_contact(MotionPlace place) {
    return place == MOTION_UPPER || place == MOTION_LOWER;
}

/* Of the wall that is in contact: 1 the upper one, -1 the lower one, 0 none. */
static inline double motion_side(MotionPlace place) {
    return place == MOTION_UPPER ? 1 : place == MOTION_LOWER ? -1 : 0;
}
