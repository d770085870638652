/* The given of a house as a scene: walls, furniture, doors, exits, and their names. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"

void plan_scene_solids(Scene *scene, const House *house);

/* Labels, which choose their places in the order they come: tags of exits and toppled furniture early, names late. */
void plan_scene_tags(Scene *scene, const House *house);
void plan_scene_names(Scene *scene, const House *house);
