/* Giving way to people: whoever drives swerves round those who come the other way or stand in it, and brakes before and
 * behind them. Walls are planned for, people are seen. */
#pragma once

#include <stddef.h>

#include "house/world.h"

/* The speed, at most `speed` m/s (negative: back off), that the people ahead leave to person i who travels along the
 * unit vector `travel`; moves the swerve (drive->aside, drive->swerve) on by one step. */
double yield_speed(const World *world, size_t i, Drive *drive, Vec2 travel, double speed);

/* Is there nothing but free space between two people? Through a wall nobody is minded, nor is their personal space. */
bool yield_sees(const World *world, size_t i, size_t j);
