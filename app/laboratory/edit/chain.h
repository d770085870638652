/* Draws chains of points: walls, exits, outlines of rooms, routes, measured distances. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Begins the chain of the present tool. */
void edit_chain_begin(Editor *edit, bool keys);

/* Makes a room of the walls round the pointer, as one step. False: they do not enclose it. */
bool edit_chain_room_here(Editor *edit);

/* Releases the points of the chain. */
void edit_chain_clear(Editor *edit);

/* Returns the id of the person whose route is drawn, valid until the plan changes; NULL: the plan has no people. */
const char *edit_chain_route_person(const Editor *edit);
