/* The slider crank as a machine of the laboratories, see laboratory/machine/machine.h. */
#pragma once

#include "laboratory/machine/machine.h"

extern const MachineKind crank_machine;
