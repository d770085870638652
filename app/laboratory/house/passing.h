/* How many people a second pass a door or an exit at a time: a mean over the last seconds, as in the plot of exits. */
#pragma once

#include "visual/house/trail.h"

#define PASSING_WINDOW 10.0 /* s */

/* Returns how many people a second went through a door, either way; the trails are those of all people (count). */
double passing_door(const Plan *plan, const Door *door, const Trail *trails, size_t count, double time);

/* Returns how many people a second left by an exit. */
double passing_exit(const Observation *observation, size_t exit, double time);
