/* The personal space of a person at a moment: a ring round the body, pressed in by obstacles and other people. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"
#include "route/route.h"

/* A person's place and pose. */
typedef struct Standing {
    const Profile *profile;
    Pose pose;
    size_t person; /* index into House.people */
    size_t group;  /* people of different groups run alone and ignore each other */
} Standing;

/* Adds the ring of all[own] with the reach of its profile, an outline without a line; door_open: (doors of the plan)
 * which are open now, or NULL: all that can be opened. */
Primitive *space_scene_add(Scene *scene, const House *house, const bool *door_open, const Standing *all, size_t count,
                           size_t own);

/* Adds discs that cover the body, as simpler methods use; contact here uses the outline itself. */
void space_scene_add_circles(Scene *scene, const Profile *profile, Pose pose);
