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
#include "cycle/cycle.h"

typedef enum MotionPlace {
    MOTION_OPEN,
    MOTION_UPPER,
    MOTION_LOWER,
    MOTION_UPPER_LEAVING,
    MOTION_LOWER_LEAVING,
    MOTION_PLACES,
} MotionPlace;

enum { MOTION_SWITCHES_MOST = 1000 /* per cycle of the drive, else it chatters; an impacting beam makes about ten */ };

/* Quantities at one instant. */
typedef struct MotionReading {
    double sine, cosine;                          /* of omega times phase */
    double value[REGIME_ROWS], rate[REGIME_ROWS]; /* of the rows needed in the place */
} MotionReading;

/* The variable part of a motion, in one block of memory so that it can be copied whole. */
typedef struct Motion {
    const Rig *rig;
    MotionPlace place;
    CycleStatus status;
    size_t cycle; /* cycles of the drive since the start */
    double phase; /* s, within the cycle */
    double since; /* s, since the last switch */
    MotionReading now;
    RegimeVector z;       /* (blocks) without the steady part */
    RegimeVector tangent; /* (tangents x blocks) */
    size_t tangents;

    size_t switches, cycle_switches; /* since the start; in this cycle */
    size_t grazes;                   /* extrema within MOTION_GRAZE of the wall since the start */
    double contact_time;             /* s, contact time since the start */
    double peak[2]; /* N, largest force on the upper and the lower contact since they were last reset */
    bool unwatched; /* peaks are not recorded, which saves time */

    RegimeVector next, factor, trial;
    double *memory;
    size_t memory_size; /* number of doubles */
} Motion;

#define MOTION_GRAZE 1e-6 /* fraction of the clearance: an extremum this close to the wall is a graze */

/* Creates a motion at rest at phase 0 with `tangents` tangent vectors. */
Motion motion_create(const Rig *rig, size_t tangents);
void motion_destroy(Motion *motion);

/* Copies `from` to `to`, which must have the same rig and number of tangents. */
void motion_copy(Motion *to, const Motion *from);

/* The state (omega q, q') (2 n), sqrt(J). Setting a state begins a cycle at phase 0, in the place that the state
 * determines. */
void motion_state(const Motion *motion, double *state);
void motion_set_state(Motion *motion, const double *state);

/* A motion at phase 0, without tangents and counters, as motion_saved_size numbers. A restored motion continues with
 * the same bits; setting a state does not promise that, since a state is computed from the blocks. A cycle begins. */
size_t motion_saved_size(const Rig *rig);
void motion_save(const Motion *motion, double *saved);
void motion_restore(Motion *motion, const double *saved);

/* Returns tangent vector `index` as a state. */
void motion_tangent(const Motion *motion, size_t index, double *tangent);
void motion_set_tangent(Motion *motion, size_t index, const double *tangent);

/* Sets tangent i to the i-th unit vector. */
void motion_unit_tangents(Motion *motion);

/* Advances to the next switch, to the end of a cell or by `longest` s, whichever is first; returns the elapsed time.
 * A switch takes place at the end of the step. */
double motion_step(Motion *motion, double longest);

/* Like motion_step over a whole cell whose end without a switch is known: blocks in `next`, and `end`. */
double motion_step_known(Motion *motion, MotionReading *end);

/* Advances to the end of the cycle, phase 0. */
CycleStatus motion_cycle(Motion *motion);

/* Begins the next cycle once the steps have completed one. */
CycleStatus motion_end_cycle(Motion *motion);

/* Deflection and velocity of the tip, m, m/s. */
double motion_deflection(const Motion *motion);
double motion_velocity(const Motion *motion);

/* Returns the force of the joint on the tip, N: negative at the upper contact. */
double motion_force(const Motion *motion);

static inline bool motion_in_contact(MotionPlace place) {
    return place == MOTION_UPPER || place == MOTION_LOWER;
}

/* Returns 1 for the upper contact, -1 for the lower one, 0 without contact. */
static inline double motion_side(MotionPlace place) {
    return place == MOTION_UPPER ? 1 : place == MOTION_LOWER ? -1 : 0;
}
