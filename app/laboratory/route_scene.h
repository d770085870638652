/* The planned ways, and the widths of the passages round whose corners they lead. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"

/* Plans anew what chairs that took part intended at the start. */
void route_scene_add(Scene *scene, const House *house, const Observation *observation, bool routes, bool widths);
