/* The beam as a machine of the laboratories, see laboratory/machine/machine.h. */
#pragma once

#include "laboratory/machine/machine.h"

enum {
    BEAM_SWEEP_STEPS = 481,         /* values of an orbit diagram from rest */
    BEAM_SWEEP_COARSE = 16,         /* steps between the first values */
    BEAM_SWEEP_CARRIED_STEPS = 241, /* values of each pass, upwards and downwards */
};

extern const MachineKind beam_machine;
