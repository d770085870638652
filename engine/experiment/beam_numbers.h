/* Access to the rows of a beam's table as numbers, and comparison of beams. */
#pragma once

#include "beam/rig.h"

/* Sets a number. Returns false, with an error and the beam unchanged, if the value is invalid. */
bool beam_numbers_set(const Parameter *row, Beam *beam, double value, Fault *fault);

/* True if the beams share a rig except for drive and clearance. */
bool beam_numbers_same_rig(const Beam *a, const Beam *b);

/* True if the rig's cells are short enough for the drive; otherwise rig_build gives the reason. */
bool beam_numbers_followed(const Beam *beam, const Rig *rig);

/* True if all numbers of the beams are equal. */
bool beam_numbers_same(const Beam *a, const Beam *b);
