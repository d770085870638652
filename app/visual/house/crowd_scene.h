/* The observed of a house with many people as a scene: nobody has a name, what counts is where they go, how many leave
 * by each exit and what keeps in those who stay. People on foot are a grey that is the darker the more use a place has;
 * chairs stand out of it, in a colour and a line for each of their profiles. */
#pragma once

#include "draw/scene.h"
#include "visual/house/census.h"
#include "visual/house/people_scene.h"

enum {
    CROWD_SCENE_HOLDS = 5,     /* markers of those that keep in most */
    CROWD_SCENE_PROFILES = 12, /* rows of the list */
};

/* Walkers are alike; chairs have a look for each profile. */
LocusLook crowd_scene_look(const House *house, const Profile *profile);

/* Is so much on a plan that chairs are too small for a likeness? */
bool crowd_scene_is_large(Box box);

/* A chair as a sign, as large as it is or as can be seen on a plan of what is in the box. */
Primitive *crowd_scene_chair(Scene *scene, Box box, const Profile *profile, Pose pose, Role role);

/* Title and detail: all are out, or how many are not and why. */
void crowd_scene_answer(Scene *scene, const House *house, const Observation *observation, const Census *census);

/* In painting order; the scene's box must be set. The labels belong behind all other primitives. */
void crowd_scene_ways(Scene *scene, const House *house, const Observation *observation, const Census *census);
void crowd_scene_labels(Scene *scene, const Observation *observation, const Census *census);

/* The key: a row a profile, with its symbol, its line and how many of its people are out. */
void crowd_scene_list(Scene *scene, const House *house, const Census *census);
