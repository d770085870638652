/* Many earthquakes as one picture: on the plan each piece of furniture by how often it stops somebody, where it would
 * fall, and everybody with how often they get out. */
#pragma once

#include "draw/scene.h"
#include "visual/house/shake_findings.h"

/* Fills an empty scene; scene_clear releases it. */
void shake_scene_make(Scene *scene, const ShakeFindings *findings);
