/* Exits that close while people are on the way to them: who was, turns to another. */
#pragma once

#include <signal.h>

#include "house/journey.h"
#include "house/world.h"

/* s, when the next exit closes after `time`; infinite: none. */
double replan_next(const World *world, double time);

/* Plans anew for everybody who is on the way, or has not started, to an exit that has closed by now. `journeys` are the
 * world's. */
void replan_journeys(World *world, Journeys *journeys, int jobs, const volatile sig_atomic_t *stop);
