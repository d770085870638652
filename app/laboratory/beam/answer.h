/* The answer of a running beam: at once from the last returns of the tip, later from the verdict on the motion from
 * rest. */
#pragma once

#include "laboratory/beam/tape.h"
#include "laboratory/beam/verdict.h"
#include "laboratory/laboratory.h"

enum { BEAM_ANSWER_LATELY = 128 /* cycles that are examined */ };

/* Facts of the last cycles of the last part. */
typedef struct BeamLately {
    size_t cycles;      /* cycles since the last change */
    int period;         /* period as returned by section_period */
    SectionPeaks peaks; /* peaks of the later half of the examined cycles */
} BeamLately;

BeamLately beam_answer_look(const BeamTape *tape);

typedef struct BeamAnswer {
    char title[64], doing[80];
    Result result;
    PanelRow *rows; /* (row_count) */
    size_t row_count, row_capacity;
    Arena arena; /* holds the detail and the texts of the rows */
} BeamAnswer;

/* Writes the answer; `verdict` must belong to the present beam, or be NULL. */
void beam_answer_write(BeamAnswer *answer, const BeamTape *tape, const Beam *beam, const BeamLately *lately,
                       const BeamVerdict *verdict);
void beam_answer_clear(BeamAnswer *answer);

/* Returns the reason why the record has ended, with a remedy, in the arena. */
const char *beam_answer_error(const BeamTape *tape, Arena *arena);
