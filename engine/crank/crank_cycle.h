/* A slider crank's motion as something that repeats, see cycle/cycle.h: `given` is its Tree, a motion a Turn with the
 * neighbours that are its tangents.
 *
 * A state here is what the turn's state has beside the ideal mechanism's at the beginning of a revolution, each number
 * in the scale of its error (0.1 mm for lengths): lengths of such states have a meaning, and small ones are not lost
 * beside the places of the parts. A tangent is a neighbour that runs beside the motion with switches of its own, so
 * that what switches do to it is in it: one neighbour for a single tangent, one to either side for several. */
#pragma once

#include "crank/turn.h"
#include "cycle/cycle.h"

/* Columns of the trace. With a motor, times are those of the drive's speed. */
typedef enum CrankColumn {
    CRANK_TIME,       /* s */
    CRANK_ANGLE,      /* deg, of the crank */
    CRANK_ALONG,      /* m, of the ball in its socket, along the coupler */
    CRANK_ALONG_RATE, /* m/s */
    CRANK_ACROSS,     /* m, level across the coupler */
    CRANK_UP,         /* m, across the coupler, upwards */
    CRANK_FORCE,      /* N, of the joint, at least 0 */
    CRANK_SLIDER,     /* m, place of the slider */
    CRANK_SLIDER_OFF, /* m, beside that of the ideal mechanism */
    CRANK_COLUMNS,
} CrankColumn;

enum { CRANK_SAMPLES = 1440 /* rows of the trace per revolution: 4 per degree */ };

/* Part of the clearance below which a motion counts as rest. */
#define CRANK_REST 1e-2

/* Motions that are watched to confirm one, and revolutions of each: a revolution costs some 5 ms, and so many are
 * enough to exclude (95 %) a half-life below 1,000 revolutions when none settles. */
enum { CRANK_LANES = 16, CRANK_LANE_CYCLES = 400 };

/* Evaluations of the right side in a revolution above which it is dear: it usually takes 40,000 to 60,000. */
enum { CRANK_DEAR = 100000 };

extern const CycleKind crank_cycle;

/* Returns the cycle of a tree, which must outlive it. */
Cycle crank_cycle_of(const Tree *tree);

/* Computes the place (m) and velocity (m/s) of the ball in its socket, along the coupler. */
void crank_cycle_tip(const Turn *turn, double tip[2]);

/* A state of the cycle (2 x coordinates) of a turn at the beginning of a revolution; setting one begins a revolution.
 */
void crank_cycle_state(const Turn *turn, double *state);
void crank_cycle_set_state(Turn *turn, const double *state);

/* Returns the largest force, N, in a revolution of the same mechanism without clearance, after it has settled; NAN:
 * it cannot be followed, or was stopped. `stop` NULL: never. */
double crank_cycle_ideal_force(const Crank *crank, const Stop *stop);
