/* What a motion takes along from one beam to another: each natural mode's share of the tip's deflection and velocity,
 * at phase 0 of the drive. Modes that there were not rest. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "beam/modes.h"

/* Zero is nothing. */
typedef struct BeamCarry {
    double *share; /* (modes x 2) m, m/s */
    size_t modes;  /* 0: there is none */
} BeamCarry;

/* Takes it from a state; of one that is lost (not finite) there is none. */
void beam_carry_take(BeamCarry *carry, const Modes *modes, const double *state);

/* Makes a state of it. False: there is none, and the state is as it was. */
bool beam_carry_give(const BeamCarry *carry, const Modes *modes, double *state);

void beam_carry_clear(BeamCarry *carry);
