/* A plan as a scene: walls, furniture, doors, exits, and their names. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"
#include "visual/house/furniture_fall.h"
#include "visual/house/plan_walls.h"

/* m: the raised view cuts walls and leaves at this height, so that the rooms are visible. */
#define PLAN_SCENE_CUT 0.9

/* m: the raised view cuts furniture at this height, a storey's: nothing as high as the camera would be visible. */
#define PLAN_SCENE_STOREY 2.4

void plan_scene_solids(Scene *scene, const House *house);

/* Adds the plan without the doors that can be opened, and those doors at a time: door_opened is as in an Observation.
 * `kept` keeps the outlines of the walls for the next scene; or NULL. Exits that are shut at that time are grey. */
void plan_scene_still(Scene *scene, const House *house, PlanWalls *kept);
void plan_scene_moving(Scene *scene, const House *house, const double *door_opened, double time);

/* Adds a falling piece of furniture, seen from above or from the side; and the place of such a piece, which labels
 * avoid. */
void plan_scene_falling(Scene *scene, const FurnitureFall *fall, bool raised);
void plan_scene_place(Scene *scene, const Furniture *piece);

/* Adds labels, which claim their places in this order: signs of exits, and after them tags of toppled furniture, early,
 * names of rooms and furniture late; a name without room in its outline is left out. `left` (exit_count) holds how many
 * people left by each exit, or is NULL. */
void plan_scene_signs(Scene *scene, const House *house, const size_t *left);
void plan_scene_tags(Scene *scene, const House *house, const size_t *left);
void plan_scene_names(Scene *scene, const House *house);

/* Adds the same names, and shows each: one too long for its piece stands next to it, with a line to it. */
void plan_scene_all_names(Scene *scene, const House *house);
