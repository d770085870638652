#include "visual/house/plan_picture.h"

#include "result/source_line.h"
#include "visual/house/house_scene.h"
#include "visual/house/plan_scene.h"

#define PERSON 0.35     /* m, radius of a person at the start */
#define TEXT_SIZE 16.0  /* design points */
#define KEEP_PERSON 4.0 /* weight against being covered by names */

enum { PICTURE_PEOPLE = 25 /* more people are not named */ };
#define CROWD_OPACITY 0.12 /* of each crowd: several may stand in one place */

/* Adds all people where they begin, and the areas of crowds. */
static void add_people(Scene *scene, const Plan *plan) {
    for (size_t i = 0; i < plan->crowd_count; i++) {
        const Points *area = &plan->crowds[i].area;
        scene_add_polygon(scene, ROLE_WALKER, area->at, area->count)->fill_opacity = CROWD_OPACITY;
    }
    for (size_t i = 0; i < plan->person_count; i++)
        scene_add_discs(scene, ROLE_CHAIR, PERSON, &plan->people[i].at, 1)->keep_clear = KEEP_PERSON;
}

void plan_picture_bare(Scene *scene, const House *house) {
    scene->box = box_expand(house->outline.box, HOUSE_SCENE_MARGIN);
    add_people(scene, &house->plan);
    plan_scene_solids(scene, house);
}

void plan_picture_make(Scene *scene, const House *house, bool all_names) {
    plan_picture_bare(scene, house);
    scene->grid = HOUSE_SCENE_GRID;
    scene->title_role = ROLE_TEXT;
    scene->title = scene_text(scene, "%s", house->plan.name);
    scene->note = source_line_is_assumed(&house->plan) ? scene_text(scene, "%s", house->plan.note) : "";
    for (size_t i = 0; i < house->plan.person_count && i < PICTURE_PEOPLE; i++)
        scene_add_label(scene, ROLE_CHAIR, TEXT_SIZE, house->plan.people[i].at, house->plan.people[i].id)->bold = true;
    plan_scene_tags(scene, house, NULL);
    (all_names ? plan_scene_all_names : plan_scene_names)(scene, house);
}
