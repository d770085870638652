/* The answer of a running beam: at once by the last returns of the tip, later by the verdict from rest. */
#pragma once

#include "laboratory/beam/tape.h"
#include "laboratory/beam/verdict.h"
#include "laboratory/laboratory.h"

enum { BEAM_ANSWER_LATELY = 128 /* cycles that are looked at */ };

/* Facts of the last cycles of the last part. */
typedef struct BeamLately {
    size_t cycles;      /* since the last change */
    int period;         /* as section_period */
    SectionPeaks peaks; /* of the later half of the cycles that are looked at */
} BeamLately;

BeamLately beam_answer_look(const BeamTape *tape);

typedef struct BeamAnswer {
    char title[64], detail[240], doing[80];
    Result result;
    PanelRow *rows; /* (row_count) */
    size_t row_count, row_capacity;
    Arena arena; /* their words */
} BeamAnswer;

/* `verdict`: of this very beam, or NULL. */
void beam_answer_write(BeamAnswer *answer, const BeamTape *tape, const Beam *beam, const BeamLately *lately,
                       const BeamVerdict *verdict);
void beam_answer_clear(BeamAnswer *answer);

/* Why the record has ended, with what would help; as long as the arena lives. */
const char *beam_answer_trouble(const BeamTape *tape, Arena *arena);
