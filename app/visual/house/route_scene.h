/* The planned routes, and the widths of the passages at their corners. */
#pragma once

#include "base/stop.h"
#include "draw/scene.h"
#include "house/observation.h"

/* Plans the routes that chairs in the run intended at the start, until `stop` (may be NULL) is set. */
void route_scene_add(Scene *scene, const House *house, const Observation *observation, bool routes, bool widths,
                     const Stop *stop);
