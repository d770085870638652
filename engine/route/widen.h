/* Finds by trying how wide a door must be for somebody to get out: see widen.c. */
#pragma once

#include "route/route.h"
#include "route/search.h"

/* Returns the door whose own width is the matter at a blockage, or -1. */
int widen_door_at(const Blockage *blockage, const RouteQuery *query);

/* Replace the estimated width that the door of a blockage needs by a tried one, in whole centimetres: with it the body
 * can be driven through all goals in order, or a disc of `radius` m goes through them. The blockage stays an estimate
 * if it is not at such a door, or if another width of this door does not help. Return false if interrupted. */
bool widen_to_drive(Blockage *blockage, const RouteQuery *query, const Rectangle *body, const Goal *goals,
                    size_t goal_count);
bool widen_to_go(Blockage *blockage, const RouteQuery *query, double radius, const Goal *goals, size_t goal_count);
