/* The motion of a beam from rest, as `clearance run` prints it: the verdict first, then the type and advice. */
#pragma once

#include "base/text.h"
#include "beam/response.h"
#include "result/beam.h"
#include "study/types.h"

typedef struct BeamVerdict {
    Beam beam; /* of which it is; its texts are another one's */
    ResponseVerdict verdict;
    size_t period; /* cycles; 0: not periodic */
    SectionPeaks peaks;
    ChaosExponent exponent;
    ResultTable motion, forces; /* the facts; empty until the verdict is known */
    bool typed;                 /* the type is known */
    TypesKind type;
    char *advice; /* sentences, each on a line; NULL: none; beam_verdict_clear releases it, and the facts */
} BeamVerdict;

/* Runs the beam. False: it was stopped, or a fault. */
bool beam_verdict_tell(BeamVerdict *verdict, const Beam *beam, const volatile sig_atomic_t *stop);

/* Tells the type, too; progress as in TypesTask. False: it was stopped, or a fault, and the verdict is as it was. */
bool beam_verdict_tell_type(BeamVerdict *verdict, int jobs, const volatile sig_atomic_t *stop,
                            void (*progress)(void *context, size_t done, size_t all), void *context);

/* Returns a copy with rows and advice of its own. */
BeamVerdict beam_verdict_copy(const BeamVerdict *verdict);

void beam_verdict_clear(BeamVerdict *verdict);
