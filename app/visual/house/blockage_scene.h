/* What stops somebody, as a scene: the body that does not pass, where, and how much is missing. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"
#include "visual/house/trail.h"

/* Is there a place where this person is stopped? */
bool blockage_scene_has(const PersonObservation *observed);

void blockage_scene_add(Scene *scene, const House *house, const Observation *observation, size_t person,
                        const Trail *trail);
void blockage_scene_label(Scene *scene, const Blockage *blockage);

/* "needs at least 0.80 m, has 0.75 m"; "" when it is not the width that stops somebody. */
const char *blockage_scene_widths(Scene *scene, const Blockage *blockage);
