/* Tests where the body of a person who does not get out is drawn. */
#include "check.h"

#include <string.h>

#include "case.h"
#include "visual/house/blockage_scene.h"
#include "visual/house/silhouette.h"

/* Checks that the first thing that the blockage of a person adds to a scene is the body at the start. */
static void check_stands_at_start(const char *what, const Furniture *under) {
    House house;
    case_house(&house, "closed-door", -1, NULL);
    Inhabitant *person = &house.people[0];
    person->under = under;
    PersonObservation observed = {.took_part = true, .reason = REASON_CANNOT_PASS, .blockage = {.at = person->at}};
    snprintf(observed.blockage.what, sizeof observed.blockage.what, "%s", what);
    Scene scene = {.bare = true}, own = {.bare = true};
    blockage_scene_add(&scene, &house, &(Observation){.people = &observed, .person_count = 1}, 0, &(Trail){0});
    Primitive *stands =
        silhouette_add(&own, ROLE_ERROR, person->profile, (Pose){.at = person->at, .heading = person->heading});
    const Primitive *drawn = &scene.primitives[0];
    CHECK(drawn->count == stands->count &&
          memcmp(drawn->points, stands->points, stands->count * sizeof *stands->points) == 0);
    scene_clear(&scene);
    scene_clear(&own);
    person->under = NULL;
    house_free(&house);
}

TEST(who_is_caught_or_has_no_room_at_the_start_is_drawn_there) {
    check_stands_at_start("under cupboard (f1)", &(Furniture){.id = "f1"});
    check_stands_at_start("start, inside wall w1", NULL);
}
