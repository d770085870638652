/* The still picture of a house after a run: the answer in words, the plan, the ways, and the list beside them; or a
 * detail of it, without words around it. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"
#include "visual/house/census.h"

#define HOUSE_SCENE_GRID 1.0   /* m, between the faint lines of a plan */
#define HOUSE_SCENE_MARGIN 0.4 /* m, round walls and ways: room for the exits' bands */

/* Fills an empty scene; scene_clear releases it. House and observation belong together and may go before the scene. */
void house_scene_make(Scene *scene, const House *house, const Observation *observation);

/* Does the plan's note say that it was assumed, not measured? */
bool house_scene_is_assumed(const Plan *plan);

/* What was before, in this house or in another one; nothing when `observation` is NULL. */
typedef struct Before {
    const House *house;
    const Observation *observation;
    const char *name; /* for it, where it is not "before"; or NULL */
} Before;

static inline const char *house_scene_before_name(Before before) {
    return before.name ? before.name : "before";
}

/* The same with what was before: its ways behind, its answer beside the own. */
void house_scene_make_compared(Scene *scene, const House *house, const Observation *observation, Before before);

/* The same for small pictures: no names but those of people, exits and places. */
void house_scene_make_small(Scene *scene, const House *house, const Observation *observation, Before before);

/* Adds that answer to a scene that has been begun. */
void house_scene_add_before(Scene *scene, Before before);

/* The same as house_scene_make, of a part of the plan (m), without what lies elsewhere, and without answer and list. */
void house_scene_make_detail(Scene *scene, const House *house, const Observation *observation, Box box);

/* What stills and films have in common: the answer and the list beside it; and with them what has to be seen. Is it a
 * crowd? */
bool house_scene_add_answer(Scene *scene, const House *house, const Observation *observation, const Census *census);
bool house_scene_begin(Scene *scene, const House *house, const Observation *observation, const Census *census);
