#include "report/report_density.h"

#include <math.h>

#include "base/memory.h"
#include "report/report_pictures.h"
#include "visual/house/density_scene.h"
#include "visual/house/house_scene.h"
#include "visual/house/plan_scene.h"
#include "visual/house/trail.h"

#define STEP 1.0  /* s, between the moments that are compared */
#define FOOT 0.05 /* of the width, below the key, for the scale */
#define FULL 2.0  /* 1/m2, of a place that counts as full */

/* Writes the places of the people who are inside at a time; returns their number. */
static size_t places_at(const Reported *run, const Trail *trails, double time, Vec2 *places) {
    size_t count = 0;
    for (size_t i = 0; i < run->house->person_count; i++) {
        const PersonObservation *person = &run->observation->people[i];
        if (trails[i].count && person->took_part && !(person->completed && time > person->time))
            places[count++] = trail_pose(&trails[i], time).at;
    }
    return count;
}

void report_density_add(Document *document, const Reported *run) {
    const House *house = run->house;
    if (house->person_count < DENSITY_SCENE_PEOPLE)
        return;
    Scene scene = {.box = box_expand(house->outline.box, HOUSE_SCENE_MARGIN)};
    Box box = scene.box;
    Trail *trails = trail_list(run->observation);
    Vec2 *places = memory_zeroed(house->person_count, sizeof *places);
    double fullest = 0, most = 0;
    for (double time = 0; time <= run->observation->time; time += STEP) {
        double area = density_scene_area(box, places, places_at(run, trails, time, places), FULL);
        if (area > most) {
            most = area;
            fullest = time;
        }
    }
    density_scene_key(&scene);
    scene.box.low.y -= FOOT * box_width(box);
    density_scene_add(&scene, box, places, places_at(run, trails, fullest, places));
    plan_scene_solids(&scene, house);
    plan_scene_tags(&scene, house, NULL);
    const char *caption = document_text(
        document,
        "People on a square metre after %.0f s, when the most of the plan, %.0f m\u00b2, has %g or more: means "
        "over a disc of 1 m\u00b2, of moments a second apart.",
        fullest, most, FULL);
    report_pictures_add(document, &scene, caption, caption);
    memory_free(places);
    trail_free_list(trails);
}
