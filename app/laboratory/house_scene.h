/* The still picture of a house after a run: the answer in words, the plan, the ways, and the list beside them; or a
 * detail of it, without words around it. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"

/* Fills an empty scene; scene_clear releases it. House and observation belong together and may go before the scene. */
void house_scene_make(Scene *scene, const House *house, const Observation *observation);

/* The same, of a part of the plan (m): what lies elsewhere is left out, and so are answer and list. */
void house_scene_make_detail(Scene *scene, const House *house, const Observation *observation, Box box);
