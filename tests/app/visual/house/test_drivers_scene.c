/* Tests the heat of touches on a plan: discs for bodies, dashed rings for hands, of one scale. */
#include "visual/house/drivers_scene.h"

#include <math.h>
#include <string.h>

#include "case.h"
#include "check.h"
#include "house/world.h"

static Touch touch_at(double x, int part, double speed) {
    return (Touch){.at = {x, 0.5}, .part = part, .other = -1, .speed = speed, .mass = 80, .energy = 1};
}

static size_t count_labels(const Scene *scene, const char *text, Vec2 *at) {
    size_t count = 0;
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *label = &scene->primitives[i];
        if (label->kind != PRIMITIVE_LABEL || strcmp(label->text, text) != 0)
            continue;
        *at = label->points[0];
        count++;
    }
    return count;
}

/* Of four drivers one touches with a side, and three have a hand that meets something at the same place. */
TEST(hands_are_rings_of_the_share_of_drivers_over_whose_discs_nothing_lies) {
    House house;
    json_t *plan = case_corridor(1);
    case_add_person(plan, "manual-chair", 1, 0, 0);
    case_made(&house, plan, -1, NULL);
    Touch first[] = {touch_at(4, PART_SIDE, 0.05), touch_at(4, PART_HAND, 0.2)};
    Touch second[] = {touch_at(4, PART_HAND, 0.2)}, third[] = {touch_at(4, PART_HAND, 0.1)};
    Touch *touches[] = {first, second, third, NULL};
    size_t counts[] = {2, 1, 1, 0};
    DriverRun runs[4];
    for (size_t k = 0; k < 4; k++)
        runs[k] = (DriverRun){.varies = true, .hands = true};
    Drivers drivers = {.count = 4, .person_count = 1, .runs = runs, .touches = touches, .touch_counts = counts};
    Scene scene = {0};
    drivers_scene_add(&scene, &house, &drivers);
    const Primitive *ring = NULL, *disc = NULL;
    for (size_t i = 0; i < scene.count; i++) {
        const Primitive *primitive = &scene.primitives[i];
        if (primitive->kind == PRIMITIVE_LINE)
            ring = primitive;
        if (primitive->kind == PRIMITIVE_DISC)
            disc = primitive;
    }
    CHECK(ring && disc && ring < disc && ring->style == LINE_DASHED);
    CHECK_NEAR(vec2_distance(ring->points[0], first[0].at), 0.5 * sqrt(0.75), 1e-9);
    CHECK_NEAR(vec2_distance(ring->points[ring->count - 1], ring->points[0]), 0, 1e-9);
    CHECK_NEAR(disc->radius, 0.5 * sqrt(0.25), 1e-9);
    CHECK(ring->edge == ROLE_DANGER_MIDDLE && disc->fill == ROLE_DANGER_LOW);
    Vec2 hand = {0, 0}, side = {0, 0};
    CHECK(count_labels(&scene, "H", &hand) == 1 && count_labels(&scene, "S", &side) == 1);
    CHECK(vec2_distance(hand, side) > 0.4);
    scene_clear(&scene);
    house_free(&house);
}
