/* How people look, from above and raised: a wheelchair with its driver, and people on foot. What is drawn inside the
 * body's outline is a likeness; the outline itself is what the simulation knows, exact. */
#pragma once

#include "draw/scene.h"
#include "plan/profile.h"
#include "route/route.h"

/* The body's outline in `role`, and in it wheels, seat and driver; a round body has them as large as fit into it. */
void figure_add_chair(Scene *scene, const Profile *profile, Pose pose, Role role);

/* Many people of one profile on foot: two primitives for all, and for up to FIGURE_HEADINGS of them one each for where
 * they look. */
void figure_add_walkers(Scene *scene, const Profile *profile, const Pose *poses, size_t count);

enum { FIGURE_HEADINGS = 1500 };
