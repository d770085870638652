/* Comparison of the numbers of beams. */
#pragma once

#include "beam/rig.h"

/* True if the beams share a rig except for drive and clearance. */
bool beam_numbers_same_rig(const Beam *a, const Beam *b);

/* True if the rig's cells are short enough for the drive; otherwise rig_build gives the reason. */
bool beam_numbers_followed(const Beam *beam, const Rig *rig);
