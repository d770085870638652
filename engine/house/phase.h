/* Phases of people in the moving house: waiting, moving, stuck, out. A person starts when the delay is over, leaves
 * across an open exit, gives up when stalled for too long, and tries again after others have left. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "house/world.h"

/* Starts people whose delay is over, lets blocked people try again after a departure, and ends the motion of chairs
 * that have been stalled for longer than the run's patience. Walkers give up by their own decision (walk.c). */
void phase_update(World *world);

/* Lets person i, who has moved from `before` to `after`, leave if that leads out by an open exit. Returns true then. */
bool phase_leave(World *world, size_t i, Vec2 before, Vec2 after);

/* Ends the motion of person i for a Reason. */
void phase_give_up(World *world, size_t i, int reason);

/* True if a person is waiting or moving, or a blocked person will try again after the last departure. */
bool phase_any_active(const World *world);
