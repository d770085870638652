/* How hard a touch is, whatever the contact law makes of it.
 *
 * A chair that cannot slip sideways moves along its axis or turns about its axle. Where the normal n meets it at r from
 * the axle, an impulse along n changes the speed there as if the mass were
 *
 *     1 / m_e = (n . axis)^2 / m + (r x n)^2 / I_axle,    I_axle = m (k^2 + c^2)
 *
 * with k the radius of gyration and c the distance of the mass centre from the axle. Two people who meet move as one
 * body of the mass 1 / (1 / m_a + 1 / m_b) would against a wall. The energy of an impact at the normal speed v is
 * m_e v^2 / 2: what the springs between them take up. */
#pragma once

#include "base/vec2.h"
#include "house/world.h"

/* Returns the effective mass, kg, at a point `arm` m from the mass centre, for a unit normal. */
double touch_mass(const Profile *profile, Vec2 axis, Vec2 arm, Vec2 normal);

/* Adds to a sense a contact that begins: `rate` (m/s) is the speed along the normal, negative when approaching;
 * `against` (kg) the effective mass of the other person, HUGE_VAL for a wall. */
void touch_begin(Sense *sense, const Profile *profile, Vec2 axis, Vec2 arm, Vec2 normal, double rate, double against);

/* Returns "front", "side", "tail" or "hand". */
const char *touch_part(int part);
