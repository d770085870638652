/* The star that tells of a touch. */
#pragma once

#include "draw/scene.h"

/* With an edge; its width, height and the rest are the caller's. */
Primitive *burst_add(Scene *scene, Vec2 at, double radius);
