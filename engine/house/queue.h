/* Which exit a person on foot chooses when people queue at the nearest one.
 *
 * The time to leave by an exit is the longer one of the time to walk there and the time that the people who go there
 * and are nearer to it need to pass it; see queue.c. People compare only exits that they see, since they do not know a
 * queue out of sight, and people with a route do not choose. */
#pragma once

#include "base/stop.h"
#include "house/journey.h"
#include "house/world.h"

/* Lets every third of the people on foot who move and have no route, in turn, compare the exits that they see, and
 * leads those who save time to another one. `journeys` are those of the world. To be called every REPLAN_PERIOD, on one
 * thread; `jobs` threads compute the fields that are missing. Once `stop` is set nobody turns. */
void queue_weigh(World *world, Journeys *journeys, int jobs, const Stop *stop);
