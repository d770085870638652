/* The doors that a track passes. */
#pragma once

#include "house/track.h"
#include "plan/plan.h"
#include "plan/profile.h"

/* Marks where the body first obstructs each door that must be opened for it, and again when it comes back. A door that
 * it only comes by stays shut. */
void track_doors_mark(Track *track, const Plan *plan, const Profile *profile);
