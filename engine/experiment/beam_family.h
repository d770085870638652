/* A beam as a family of cycles, for orbits that are followed as one of its numbers changes (follow.h). */
#pragma once

#include "beam/beam.h"
#include "beam/rig.h"
#include "cycle/follow.h"

typedef struct BeamFamily {
    Beam beam;            /* as it was opened; its texts belong to another beam */
    const Parameter *row; /* of the number that changes */
    Rig rig, own;         /* of the beam as it was opened, and of the value that was asked for last */
    bool shares, built;   /* what `own` is: rig_share of `rig`, or built; neither: nothing */
    FollowFamily follow;
} BeamFamily;

/* Opens the family of a beam, which must outlive it, over a number from `from` to `to` with the same natural modes.
 * `place` begins its errors. The family must not be moved. beam_family_close releases it. */
bool beam_family_open(BeamFamily *family, const Beam *beam, const char *name, double from, double to, const char *place,
                      Fault *fault);

/* Sets another number of the beam, from then on. False: it cannot have this value, and nothing has changed. */
bool beam_family_set(BeamFamily *family, const Parameter *row, double value);

void beam_family_close(BeamFamily *family);

/* Returns the value that the beam has as it was opened. */
double beam_family_value(const BeamFamily *family);
