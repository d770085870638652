/* What a beam does from rest, told as `clearance run` tells it: the verdict first, then the type and advice. */
#pragma once

#include "base/text.h"
#include "beam/response.h"
#include "study/types.h"

enum { BEAM_VERDICT_FREQUENCIES = 6 /* natural ones that are told */ };

typedef struct BeamVerdict {
    Beam beam; /* of which it is; its texts are another one's */
    ResponseVerdict verdict;
    size_t period; /* cycles; 0: not periodic */
    SectionPeaks peaks;
    ChaosExponent exponent;
    double zero_one, multiplier;
    size_t cycles; /* on which it rests */
    bool settled;
    double free_amplitude;                    /* m, of the tip without the joint */
    double natural[BEAM_VERDICT_FREQUENCIES]; /* Hz (natural_count) */
    size_t natural_count;
    bool typed; /* the type is told */
    TypesKind type;
    char *advice; /* sentences, each on a line; NULL: none; beam_verdict_clear releases it */
} BeamVerdict;

/* Runs the beam. False: it was stopped, or a fault. */
bool beam_verdict_tell(BeamVerdict *verdict, const Beam *beam, const volatile sig_atomic_t *stop);

/* Tells the type, too; progress as in TypesTask. False: it was stopped, or a fault, and the verdict is as it was. */
bool beam_verdict_tell_type(BeamVerdict *verdict, int jobs, const volatile sig_atomic_t *stop,
                            void (*progress)(void *context, size_t done, size_t all), void *context);

void beam_verdict_clear(BeamVerdict *verdict);
