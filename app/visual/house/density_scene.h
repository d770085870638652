/* How crowded a place is: people on a square metre, as colour, with its key. The density at a point is the number of
 * people whose reference point lies in the disc of 1 m2 round it; a cell of 0.5 m shows the mean of four points, and in
 * a box of more than 60 m one of 1 m the mean of sixteen. */
#pragma once

#include "draw/scene.h"

enum { DENSITY_SCENE_PEOPLE = 200 /* from so many people on, density is shown */ };

/* Adds the colours of the places of people (count), within the scene's box. */
void density_scene_add(Scene *scene, Box box, const Vec2 *places, size_t count);

/* Returns how much of a box, m2, has at least `least` people on a square metre. */
double density_scene_area(Box box, const Vec2 *places, size_t count, double least);

/* Adds the key below the scene's box, and extends the box by it. */
void density_scene_key(Scene *scene);
