/* Elements of machine drawings, as primitives of a scene, m. */
#pragma once

#include "draw/scene.h"

/* Adds a zigzag from one end to the other, `half` to either side. */
void machine_pieces_spring(Scene *scene, Vec2 from, Vec2 to, double half);

/* Adds a spiral round a place: a torsional spring. */
void machine_pieces_spiral(Scene *scene, Vec2 middle, double radius);

/* Adds a piston in a cylinder. */
void machine_pieces_dashpot(Scene *scene, Vec2 from, Vec2 to, double half);

/* Adds ground: a thick line, and hatches `depth` behind it, upwards if that is positive. */
void machine_pieces_ground(Scene *scene, Vec2 left, Vec2 right, double depth);

Primitive *machine_pieces_block(Scene *scene, Role fill, Box box);

/* Adds an arrow from its foot to its point, its shaft `half` to either side; an arrow shorter than its head has no
 * shaft. */
void machine_pieces_arrow(Scene *scene, Role role, Vec2 foot, Vec2 point, double half);

/* Adds the star of a contact. */
void machine_pieces_star(Scene *scene, Vec2 at, double radius);
