/* Tests that fallen furniture differs from furniture that stands by its hatch, its rim and its old place. */
#include "visual/house/plan_scene.h"

#include "case.h"
#include "check.h"
#include "draw/palette.h"

/* Returns the number of polygons of furniture with this edge, hatch and style. */
static int count_bodies(const Scene *scene, Role edge, bool hatched, LineStyle style) {
    int count = 0;
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *body = &scene->primitives[i];
        count += body->kind == PRIMITIVE_POLYGON && body->fill == ROLE_FURNITURE && body->edge == edge &&
                 body->hatched == hatched && body->style == style;
    }
    return count;
}

TEST(fallen_pieces_have_a_red_rim_a_hatch_and_a_dashed_old_place) {
    House house;
    Scene scene = {0};
    case_house(&house, "bedroom-after-earthquake", -1, NULL);
    int fallen = 0, pieces = (int)house.plan.furniture_count;
    for (int i = 0; i < pieces; i++)
        fallen += house.plan.furniture[i].toppled;
    plan_scene_solids(&scene, &house);
    CHECK(fallen > 0);
    CHECK(count_bodies(&scene, ROLE_ERROR, true, LINE_SOLID) == fallen);
    CHECK(count_bodies(&scene, ROLE_ERROR, false, LINE_DASHED) == fallen);
    CHECK(count_bodies(&scene, ROLE_FURNITURE_LINE, false, LINE_SOLID) == pieces - fallen);
    scene_clear(&scene);
    house_free(&house);
}

TEST(the_rim_of_a_fallen_piece_is_seen_on_floor_and_furniture) {
    for (Theme theme = 0; theme < THEME_COUNT; theme++) {
        Colour rim = palette_colour(theme, ROLE_ERROR);
        CHECK(palette_contrast(rim, palette_colour(theme, ROLE_PAPER)) >= 4.5);
        CHECK(palette_contrast(rim, palette_colour(theme, ROLE_FURNITURE)) >= 4.5);
    }
}
