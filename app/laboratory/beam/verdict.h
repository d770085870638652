/* The motion of a beam from rest, as `clearance run` prints it: the verdict first, then the type and advice. */
#pragma once

#include "base/stop.h"
#include "base/text.h"
#include "beam/beam_cycle.h"
#include "result/beam.h"
#include "study/types.h"

typedef struct BeamVerdict {
    Beam beam; /* the beam that the verdict is for; its texts belong to another beam */
    ResponseVerdict verdict;
    size_t period; /* cycles; 0: not periodic */
    SectionPeaks peaks;
    ChaosExponent exponent;
    ResultTable motion, forces; /* the facts; empty until the verdict is known */
    bool typed;                 /* the type is known */
    TypesKind type;
    char *advice; /* sentences, one per line; NULL: none; beam_verdict_clear releases the advice and the facts */
} BeamVerdict;

/* Runs the beam and fills the verdict. False: the run was stopped, or a fault. */
bool beam_verdict_decide(BeamVerdict *verdict, const Beam *beam, const Stop *stop);

/* Also determines the type; progress as in TypesTask. False: the search was stopped, or a fault, and the verdict is
 * unchanged. */
bool beam_verdict_tell_type(BeamVerdict *verdict, int jobs, const Stop *stop,
                            void (*progress)(void *context, size_t done, size_t all), void *context);

/* Returns a copy with its own rows and advice. */
BeamVerdict beam_verdict_copy(const BeamVerdict *verdict);

void beam_verdict_clear(BeamVerdict *verdict);
