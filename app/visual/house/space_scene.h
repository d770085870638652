/* The personal space of somebody as it is at a moment: a ring round the body that obstacles and others press in. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"
#include "route/route.h"

/* Who stands or moves where. */
typedef struct Standing {
    const Profile *profile;
    Pose pose;
    size_t person; /* index into House.people */
    size_t group;  /* people of other groups are not there for one another: they run alone */
} Standing;

/* The ring of all[own] with the reach of its profile, an outline without a line; door_open: (doors of the plan) which
 * are open now, or NULL: all that can be. */
Primitive *space_scene_add(Scene *scene, const House *house, const bool *door_open, const Standing *all, size_t count,
                           size_t own);

/* Discs along the body that cover it, as simpler methods take it; contact here knows the outline itself. */
void space_scene_add_circles(Scene *scene, const Profile *profile, Pose pose);
