/* Positions that follow from a plan's numbers: the ends of doors and the corners of furniture. */
#pragma once

#include "plan/plan.h"

/* Fills in the end points of a door on its wall's centre line, in the direction from the wall's start to its end. */
void plan_geometry_door_ends(const Plan *plan, const Door *door, Vec2 *from, Vec2 *to);

/* Fills in the four corners of a piece of furniture as it stands or lies, counter-clockwise. */
void plan_geometry_corners(const Furniture *piece, Vec2 corners[4]);
