/* Derives from a plan's numbers the ends of doors, the corners of furniture, and who is out. */
#pragma once

#include "plan/plan.h"

/* Fills in the end points of a door on its wall's centre line, in the direction from the wall's start to its end. */
void plan_geometry_door_ends(const Plan *plan, const Door *door, Vec2 *from, Vec2 *to);

/* Fills in the four corners of a piece of furniture as it stands or lies, counter-clockwise. */
void plan_geometry_corners(const Furniture *piece, Vec2 corners[4]);

/* True if the exit can be passed at a time, s: from when it opens until it closes. */
bool plan_geometry_is_open(const Exit *exit, double time);

/* True if an exit bars the way at a time: it is not open, and no exit that is open lies on the same line. */
bool plan_geometry_bars(const Plan *plan, size_t exit, double time);

/* True if the whole line of an exit lies on that of another one, which is another time of the same door. */
bool plan_geometry_covers(const Exit *other, const Exit *exit);

/* Returns 1 to the left of the exit's line, -1 to the right of it, 0 on it. */
int plan_geometry_side(const Exit *exit, Vec2 at);

/* True if a straight motion leads out: it crosses the exit's line, or one of its ends lies on the line and the other
 * one beside it. The line belongs to neither side, so it matters neither on which side a motion begins nor in which
 * direction the line is drawn. A motion along the line does not lead out, nor does a turn on the spot. */
bool plan_geometry_leads_out(const Exit *exit, Vec2 from, Vec2 to);
