/* Planning anew while people are on the way: when an exit has closed, whoever was on the way to it turns to another;
 * when a crowd has pushed a chair off its way, it looks for a new one from where it is. Once `stop` is set nobody finds
 * or takes a way, and the world must not move any more. */
#pragma once

#include <signal.h>

#include "house/journey.h"
#include "house/world.h"

/* s, when the next exit closes after `time`; infinite: none. */
double replan_next(const World *world, double time);

#define REPLAN_PERIOD 1.0 /* s, between two looks for chairs that have been pushed off their way */

/* Plans anew for chairs that no longer get on and stand more than a body's width off their way. */
void replan_strays(World *world, Journeys *journeys, int jobs, const volatile sig_atomic_t *stop);

/* Of the route's points the next one of person i. */
size_t replan_next_point(const World *world, size_t i);

/* Person i starts on the new journey. Where there is none it stays; a chair that has strayed, pushed off its way, asks
 * again. */
void replan_set_out(World *world, size_t i, bool strayed);

/* Plans anew for everybody who is on the way, or has not started, to an exit that has closed by now. `journeys` are the
 * world's. */
void replan_journeys(World *world, Journeys *journeys, int jobs, const volatile sig_atomic_t *stop);
