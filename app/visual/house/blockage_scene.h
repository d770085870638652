/* The blockage of a person as a scene: the body that does not pass, its place, and the missing width. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"
#include "visual/house/trail.h"

/* True if the person is stopped at a known place. */
bool blockage_scene_has(const PersonObservation *observed);

void blockage_scene_add(Scene *scene, const House *house, const Observation *observation, size_t person,
                        const Trail *trail);

/* Labels each place that stops people once, with what the largest of them needs. */
void blockage_scene_labels(Scene *scene, const House *house, const Observation *observation);

/* Returns "needs at least 0.80 m, has 0.75 m"; "" if the person is not stopped by the width. */
const char *blockage_scene_widths(Scene *scene, const Blockage *blockage);
