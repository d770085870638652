/* What the last cycles of a beam's record show. */
#pragma once

#include "laboratory/beam/tape.h"
#include "laboratory/machine/answer.h"

MachineLately beam_lately_look(const BeamTape *tape);

/* Returns the reason why the record has ended, with a remedy, in the arena. */
const char *beam_lately_error(const BeamTape *tape, Arena *arena);
