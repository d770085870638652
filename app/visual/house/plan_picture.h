/* A house as it is given, before anybody moves: walls, doors, furniture, exits, and everybody where they begin. Only
 * its plan and its outline are needed. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"

/* Fills an empty scene without words, for small pictures. */
void plan_picture_bare(Scene *scene, const House *house);

/* The same with names, and the house's own above. */
void plan_picture_make(Scene *scene, const House *house);
