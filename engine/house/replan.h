/* Plans paths again during a run: when an exit has closed, people who were on their way to it turn to another exit;
 * when a crowd has pushed a chair off its path, the chair plans a new one from its position. Once `stop` is set no path
 * is found or taken, and the world must not move any more. */
#pragma once

#include "base/stop.h"
#include "house/journey.h"
#include "house/world.h"

/* Returns the time, s, when the next exit closes after `time`; infinite: none. */
double replan_next(const World *world, double time);

#define REPLAN_PERIOD 1.0 /* s, period of the search for chairs that have been pushed off their path */

/* Plans again for stalled chairs that are more than a body's width off their path, or touch something. */
void replan_strays(World *world, Journeys *journeys, int jobs, const Stop *stop);

/* Returns the index of the next of the route's points of person i. */
size_t replan_next_point(const World *world, size_t i);

/* Starts person i on the new journey. Without a path the person stays; a chair that was pushed off its path keeps its
 * former journey, and backs off and tries again. */
void replan_set_out(World *world, size_t i, bool strayed);

/* Plans again for all people, moving or not started, whose exit has closed by now or whose way a closed exit bars.
 * `journeys` are those of the world.
 */
void replan_journeys(World *world, Journeys *journeys, int jobs, const Stop *stop);
