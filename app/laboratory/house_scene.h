/* The still picture of a house after a run: the answer in words, the plan, the ways, and the list beside them. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"
#include "laboratory/census.h"

/* Fills an empty scene; scene_clear releases it. House and observation belong together and may go before the scene. */
void house_scene_make(Scene *scene, const House *house, const Observation *observation);

/* What stills and films have in common: the answer, what has to be seen, and the list beside it. Is it a crowd? */
bool house_scene_begin(Scene *scene, const House *house, const Observation *observation, const Census *census);
