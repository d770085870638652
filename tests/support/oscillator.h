/* Rigs for tests of the beam: one mass behind a gap, and the shipped beams. */
#pragma once

#include "beam/motion.h"

/* A mass (1 kg) on a soft spring of natural frequency omega (rad/s) and damping ratio, whose tip and shaker are itself.
 * The drive has 0.01 Hz and no force. */
typedef struct Oscillator {
    double omega, damping_ratio;
    double clearance, stiffness, damping; /* of the joint */
    int release;
} Oscillator;

Rig oscillator_rig(const Oscillator *oscillator);

/* Reads assets/beams/NAME.json with the setting (or NULL), which must be valid. */
Beam oscillator_beam(const char *name, const char *setting);
Rig oscillator_beam_rig(const char *name, const char *setting);

/* Returns an initial state: `which` 0 is rest, others excite every mode. */
void oscillator_start(const Rig *rig, unsigned which, double *state);
