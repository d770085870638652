/* Finds by trying how wide a door must be for a chair to be driven out: see widen.c. */
#pragma once

#include "route/route.h"
#include "route/search.h"

/* Returns the door whose own width is the matter at a blockage, or -1. */
int widen_door_at(const Blockage *blockage, const RouteQuery *query);

/* Replaces the estimated width that the door of a blockage needs by a tried one, in whole centimetres: with it there is
 * a way. The blockage stays an estimate if it is not at such a door, or if another width of this door does not help.
 * Returns false if interrupted. */
bool widen_door(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const Goal *goals,
                size_t goal_count);
