/* Giving way to people: a driver swerves round people who come the other way or stand in it, and brakes before and
 * behind them. Walls are part of the plan, people are seen. */
#pragma once

#include <stddef.h>

#include "house/world.h"

/* Returns the speed, at most `speed` m/s (negative: back off), that the people ahead allow person i, who travels along
 * the unit vector `travel`; advances the swerve (drive->aside, drive->swerve) by one step. */
double yield_speed(const World *world, size_t i, Drive *drive, Vec2 travel, double speed);

/* True if there is only free space between two people. People and their personal spaces behind a wall are ignored. */
bool yield_sees(const World *world, size_t i, size_t j);
