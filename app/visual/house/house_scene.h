/* The still picture of a house after a run: the answer, the plan, the loci, and the list next to them; or a detail of
 * it without texts around it. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"
#include "inquiry/grade.h"
#include "result/census.h"

#define HOUSE_SCENE_GRID 1.0   /* m, between the faint lines of a plan */
#define HOUSE_SCENE_MARGIN 0.4 /* m, round walls and loci: room for the bands of the exits */

/* Fills an empty scene; scene_clear releases it. House and observation belong together and need not outlive the scene.
 */
void house_scene_make(Scene *scene, const House *house, const Observation *observation);

/* The comparison, of this house or of another one; none if `observation` is NULL. */
typedef struct Before {
    const House *house;
    const Observation *observation;
    const char *name;     /* its name, if not "before"; or NULL */
    const Grade *letters; /* (house->person_count) of its grades, or NULL */
} Before;

static inline const char *house_scene_before_name(Before before) {
    return before.name ? before.name : "before";
}

/* Does the same with a comparison: its loci behind, its answer next to that of the run. */
void house_scene_make_compared(Scene *scene, const House *house, const Observation *observation, Before before);

/* Does the same for small pictures: only people, exits and places are named. */
void house_scene_make_small(Scene *scene, const House *house, const Observation *observation, Before before);

/* Adds the comparison's answer to a scene with an answer. */
void house_scene_add_before(Scene *scene, Before before);

/* Makes the scene of a part of the plan (m), clipped to it, and without answer and list. */
void house_scene_make_detail(Scene *scene, const House *house, const Observation *observation, Box box);

/* Adds the part common to stills and films: the answer, the list next to the plan, and the box that must be visible.
 * True if the people are a crowd. */
bool house_scene_add_answer(Scene *scene, const House *house, const Observation *observation, const Census *census);
bool house_scene_begin(Scene *scene, const House *house, const Observation *observation, const Census *census);
