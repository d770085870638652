/* The body of the person that the person tool places: its outline on the floor, and what it would touch. */
#pragma once

#include "laboratory/edit/editor_state.h"

enum { BODY_POINTS = 24 };

/* Writes the outline of the chosen profile at a place, m, with a heading, degree. Returns the number of points; 0: the
 * profile cannot be read. */
size_t edit_body_outline(Editor *edit, Vec2 at, double heading, Vec2 points[BODY_POINTS]);

/* Writes the name of the first wall or piece of furniture that the body would touch there. False: none. */
bool edit_body_touches(Editor *edit, const Plan *plan, Vec2 at, double heading, char name[EDIT_NAME]);

void edit_body_clear(Editor *edit);
