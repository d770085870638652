/* The state that is carried from one beam to another: each natural mode's part of the tip's deflection and velocity,
 * at phase 0 of the drive. Additional modes start at rest. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "beam/modes.h"

/* A zeroed value holds no state. */
typedef struct BeamCarry {
    double *share; /* (modes x 2) m, m/s */
    size_t modes;  /* 0: no state */
} BeamCarry;

/* Takes the state; a state that is not finite gives none. */
void beam_carry_store(BeamCarry *carry, const Modes *modes, const double *state);

/* Converts to a state of other modes. Returns false, leaving `state` unchanged, if there is none. */
bool beam_carry_apply(const BeamCarry *carry, const Modes *modes, double *state);

void beam_carry_clear(BeamCarry *carry);
