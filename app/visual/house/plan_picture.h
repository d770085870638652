/* A house before anybody moves: walls, doors, furniture, exits, and all people where they begin. Only its plan and its
 * outline are needed. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"

/* Fills an empty scene without texts, for small pictures. */
void plan_picture_bare(Scene *scene, const House *house);

/* Does the same with names, and the name of the house above; `all_names`: a name too long for its piece
 * stands next to it, with a line to it. */
void plan_picture_make(Scene *scene, const House *house, bool all_names);
