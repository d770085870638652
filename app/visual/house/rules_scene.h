/* The plan of a house with what rules have measured: a line for each dimension, with a tick where it passes and a cross
 * where it does not, next to it the share of drivers who get through there, and where chairs are stopped. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"
#include "rules/inspection.h"

/* Fills an empty scene; scene_clear releases it. `title` is the answer, `detail` one
 * more line about it. */
void rules_scene_make(Scene *scene, const House *house, const Inspection *inspection, const char *title,
                      const char *detail);
