/* Many earthquakes as one picture: each piece of furniture coloured by how often it stops somebody, the place where it
 * would fall, and for all people how often they leave. */
#pragma once

#include "draw/scene.h"
#include "result/shake_findings.h"

/* Fills an empty scene; scene_clear releases it. */
void shake_scene_make(Scene *scene, const ShakeFindings *findings);
