/* The observation of a house with many people as a scene: people have no names; the scene shows where they go, how
 * many leave by each exit and what stops the others. People on foot are a grey that darkens with the use of a place;
 * chairs stand out by a colour and a line style per profile. */
#pragma once

#include "draw/scene.h"
#include "result/census.h"
#include "visual/house/people_scene.h"

enum {
    CROWD_SCENE_HOLDS = 5,     /* markers of the holds with the most people */
    CROWD_SCENE_PROFILES = 12, /* rows of the list */
};

/* Returns the look of a profile: walkers are alike, each profile of chairs has its own. */
LocusLook crowd_scene_look(const House *house, const Profile *profile);

/* True if the plan shows so much that chairs are too small for a likeness. */
bool crowd_scene_is_large(Box box);

/* Adds a chair as a sign, in its own size or the smallest that is visible on a plan of the box. */
Primitive *crowd_scene_chair(Scene *scene, Box box, const Profile *profile, Pose pose, Role role);

/* In painting order; the scene's box must be set. The labels must be added behind all other primitives. */
void crowd_scene_ways(Scene *scene, const House *house, const Observation *observation, const Census *census);
void crowd_scene_labels(Scene *scene, const House *house, const Observation *observation, const Census *census);

/* Adds the key: a row per profile, with its symbol, its line and how many of its people are out. */
void crowd_scene_list(Scene *scene, const House *house, const Census *census);
