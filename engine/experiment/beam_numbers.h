/* The rows of a beam's table as numbers, and what beams that differ in some of them share. */
#pragma once

#include "beam/rig.h"

/* False: a fault says what would be right, and the beam is as it was. */
bool beam_numbers_set(const Parameter *row, Beam *beam, double value, Fault *fault);

/* Is a rig of the one a rig of the other, but for the drive and the clearance? */
bool beam_numbers_same_rig(const Beam *a, const Beam *b);

/* Is the drive fast enough for the rig's cells? Of one that is not, rig_build says why. */
bool beam_numbers_followed(const Beam *beam, const Rig *rig);

/* Are all their numbers the same? */
bool beam_numbers_same(const Beam *a, const Beam *b);
