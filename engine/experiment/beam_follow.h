/* An orbit of a beam with the orbits that begin at its flips and pitchforks (follow.h), and the curves of folds,
 * flips, pitchforks and Neimark-Sacker points over a second number (follow_curve.h). */
#pragma once

#include "cycle/follow_curve.h"
#include "cycle/response.h"
#include "experiment/beam_family.h"

enum { BEAM_FOLLOW_BRANCHES = 4, BEAM_FOLLOW_CURVES = 24, BEAM_FOLLOW_STEPS = 10000 /* of a second number */ };

/* Largest step along a curve, as a share of its range. */
#define BEAM_FOLLOW_STEP 0.02

typedef struct BeamFollow {
    FollowBranch branches[BEAM_FOLLOW_BRANCHES]; /* (count) the orbit, then those that begin on it */
    size_t count;
    FollowCurve curves[BEAM_FOLLOW_CURVES]; /* (curve_count) */
    size_t curve_count;
    size_t left_out; /* located points whose curves do not fit into `curves` */
    bool interrupted;
} BeamFollow;

/* Follows the orbit of `period` cycles through `point` at the value that the family was opened with. Returns false if
 * it cannot be followed; beam_follow_clear releases the result in either case. */
bool beam_follow_run(BeamFollow *follow, BeamFamily *family, const double *point, size_t period, const Stop *stop);

/* The second number of a plane of curves. */
typedef struct BeamPlane {
    const char *name;
    double least, most;
    size_t steps;
} BeamPlane;

/* Adds an error unless the beam of the family can have both ends of the second number, which is another one. */
bool beam_follow_check(const BeamFamily *family, const BeamPlane *plane, const char *place, Fault *fault);

/* Adds the curves of the folds, flips, pitchforks and Neimark-Sacker points of all branches over the plane of the
 * family's number and another one, and over frequency and clearance the end of the motion without contact, which is
 * known in closed form (kind touching, of period 1). The result does not depend on the number of jobs. */
void beam_follow_curves(BeamFollow *follow, const BeamFamily *family, const BeamPlane *plane, int jobs,
                        const Stop *stop);

void beam_follow_clear(BeamFollow *follow);
