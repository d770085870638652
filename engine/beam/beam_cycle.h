/* The motion of a beam as something that repeats: one cycle is a period of the drive, from phase 0 to phase 0. */
#pragma once

#include "base/stop.h"
#include "beam/beam.h"
#include "beam/motion.h"
#include "cycle/cycle.h"
#include "cycle/response.h"

/* Columns of a recording. */
typedef enum BeamColumn {
    BEAM_TIME,
    BEAM_DEFLECTION, /* m, of the tip */
    BEAM_VELOCITY,
    BEAM_FORCE, /* N, of the joint on the tip */
} BeamColumn;

enum { BEAM_SAMPLES = 200 /* rows of a recording per cycle of the drive */ };

/* Cycles after the transient on which a verdict rests: the least, and the most before it is given up. */
enum { BEAM_CYCLES_LEAST = 2000, BEAM_CYCLES_MOST = 16000 };

extern const CycleKind beam_cycle; /* `given` is a Rig */

/* The rig as a cycle; it must outlive it. */
Cycle beam_cycle_of(const Rig *rig);

/* A motion as one of its rig's cycle, which keeps belonging to the caller. */
CycleMotion beam_cycle_motion(Motion *motion);

/* Runs the beam of the rig from `start` (a state, or NULL: at rest) for the beam's cycles: see response_run. */
void beam_cycle_respond(Response *response, const Rig *rig, const Beam *beam, const double *start, const Stop *stop);

/* Returns the theoretical sum of the exponents, 1/s, for release at zero force: the trace of the damping, -2 sum
 * zeta omega - c (phi phi) times the fraction of time in contact. */
double beam_cycle_exponent_sum(const Rig *rig, double contact_share);
