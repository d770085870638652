/* Phases of people in the moving house: waiting, moving, stuck, out. A person starts when the delay is over, leaves
 * across an open exit, gives up when stalled for too long, and tries again after others have left. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "house/world.h"

/* Starts people whose delay is over, lets blocked people try again after a departure, and ends the motion of chairs
 * that have been stalled for longer than the run's patience. Walkers give up by their own decision (walk.c). */
void phase_update(World *world);

/* Assumed: the line of an exit that is not open holds like a shut door. The middle of a person on foot, or the
 * reference point of a chair, that would move from `before` across it goes along it instead, with the part of the
 * velocity that is along it: others behind cannot press it out. No force is told. Returns true if it is held. */
bool phase_hold(const World *world, Vec2 before, Vec2 *after, Vec2 *velocity);

/* Lets person i, who has moved from `before` to `after`, leave if that leads out by an open exit. Returns true then. */
bool phase_leave(World *world, size_t i, Vec2 before, Vec2 after);

/* Ends the motion of person i for a Reason. */
void phase_give_up(World *world, size_t i, int reason);

/* True if a person is waiting or moving, or a blocked person will try again after the last departure. */
bool phase_any_active(const World *world);
