/* The given of a house as a scene: walls, furniture, doors, exits, and their names. */
#pragma once

#include "draw/scene.h"
#include "house/house.h"
#include "visual/house/furniture_fall.h"

/* m: walls and leaves are cut at this height in the raised view, so that one sees into the rooms. */
#define PLAN_SCENE_CUT 0.9

/* m: and furniture at this one, a storey's: what is as high as the camera could not be seen at all. */
#define PLAN_SCENE_STOREY 2.4

void plan_scene_solids(Scene *scene, const House *house);

/* The same without the doors that can be opened, and those doors at a time: door_opened is as in an Observation. */
void plan_scene_still(Scene *scene, const House *house);
void plan_scene_moving(Scene *scene, const House *house, const double *door_opened, double time);

/* A piece of furniture on its way from standing to lying, seen from above or from the side; and the place of one that
 * is drawn so, which labels avoid. */
void plan_scene_falling(Scene *scene, const FurnitureFall *fall, bool raised);
void plan_scene_place(Scene *scene, const Furniture *piece);

enum { PLAN_SCENE_NAMES = 25 /* more pieces of furniture, or doors, have no names */ };

/* Labels, which choose their places in the order they come: tags of exits and toppled furniture early, names late.
 * `left` (exit_count) tells how many left by each exit, or is NULL. Where names are not `needed`, those that find no
 * room are left out. */
void plan_scene_tags(Scene *scene, const House *house, const size_t *left);

/* The same for pictures in which somebody moves: signs stand fixed at the ends of the exits, beside the way of those
 * who leave. And one such sign with words of its own. */
void plan_scene_signs(Scene *scene, const House *house);
void plan_scene_sign(Scene *scene, const House *house, const Exit *exit, const char *text);
void plan_scene_names(Scene *scene, const House *house, bool needed);
