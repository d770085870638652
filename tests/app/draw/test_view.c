/* Tests that cameras project as the formulas say and fit the view. */

#include "draw/view.h"

#include "check.h"

static const Box HOUSE = {{-1, -2}, {9, 5}};
static const Box PLACE = {{20, 90}, {900, 660}};
#define TOP 2.4

TEST(the_plan_is_upright_and_to_scale) {
    View view = view_plan(50, vec2(100, 600));
    Vec2 at = view_point(&view, vec2(3, 4), 1.7);
    CHECK_NEAR(at.x, 250, 1e-12);
    CHECK_NEAR(at.y, 400, 1e-12);
    CHECK_NEAR(view_scale(&view, vec2(7, 7), 2), 50, 1e-12);
}

/* All eight corners lie in the view, some on its edges: it cannot be larger. */
static void check_fit(Camera camera) {
    View view = view_raised(camera, HOUSE, TOP, PLACE);
    Box seen = box_empty();
    for (int corner = 0; corner < 8; corner++)
        seen = box_include(
            seen,
            view_point(&view, vec2(corner & 1 ? HOUSE.high.x : HOUSE.low.x, corner & 2 ? HOUSE.high.y : HOUSE.low.y),
                       corner & 4 ? TOP : 0));
    CHECK(seen.low.x >= PLACE.low.x - 1e-9 && seen.high.x <= PLACE.high.x + 1e-9);
    CHECK(seen.low.y >= PLACE.low.y - 1e-9 && seen.high.y <= PLACE.high.y + 1e-9);
    double spare_x = (PLACE.high.x - PLACE.low.x) - (seen.high.x - seen.low.x);
    double spare_y = (PLACE.high.y - PLACE.low.y) - (seen.high.y - seen.low.y);
    CHECK_NEAR(fmin(spare_x, spare_y), 0, 1e-9);
    CHECK_NEAR(seen.low.x + seen.high.x, PLACE.low.x + PLACE.high.x, 1e-9);
    CHECK_NEAR(seen.low.y + seen.high.y, PLACE.low.y + PLACE.high.y, 1e-9);
}

TEST(the_raised_view_fits_from_everywhere) {
    for (double azimuth = -180; azimuth < 180; azimuth += 30)
        for (double elevation = 5; elevation <= 90; elevation += 17)
            check_fit((Camera){.kind = VIEW_RAISED, .azimuth = azimuth, .elevation = elevation, .zoom = 1});
}

/* Seen from the front, right stays right, and farther or higher points are farther up. */
TEST(the_raised_view_looks_up_the_plan) {
    View view = view_raised((Camera){.kind = VIEW_RAISED, .azimuth = 0, .elevation = 40, .zoom = 1}, HOUSE, TOP, PLACE);
    Vec2 here = view_point(&view, vec2(4, 1), 0);
    CHECK(view_point(&view, vec2(5, 1), 0).x > here.x);
    CHECK(view_point(&view, vec2(4, 2), 0).y < here.y);
    CHECK(view_point(&view, vec2(4, 1), 1).y < here.y);
    CHECK_NEAR(view_point(&view, vec2(4, 1), 1).x, here.x, 1e-9); /* the middle of the house does not lean */
    View right =
        view_raised((Camera){.kind = VIEW_RAISED, .azimuth = 90, .elevation = 40, .zoom = 1}, HOUSE, TOP, PLACE);
    here = view_point(&right, vec2(4, 1), 0);
    CHECK(view_point(&right, vec2(4, 2), 0).x > here.x);
    CHECK(view_point(&right, vec2(3, 1), 0).y < here.y);
}

TEST(the_scale_is_the_slope_across) {
    Camera camera = {.kind = VIEW_RAISED, .azimuth = 0, .elevation = 35, .zoom = 1.5};
    View view = view_raised(camera, HOUSE, TOP, PLACE);
    for (double y = -2; y <= 5; y += 1.4) {
        double step = 1e-4;
        Vec2 left = view_point(&view, vec2(2 - step / 2, y), 0.5),
             right = view_point(&view, vec2(2 + step / 2, y), 0.5);
        CHECK_NEAR(vec2_distance(left, right) / step, view_scale(&view, vec2(2, y), 0.5), 1e-4);
    }
    CHECK(view_scale(&view, vec2(2, -2), 0) > view_scale(&view, vec2(2, 5), 0)); /* nearer points are larger */
}

TEST(zoom_enlarges_about_the_middle) {
    View one = view_raised((Camera){.kind = VIEW_RAISED, .azimuth = 30, .elevation = 50, .zoom = 1}, HOUSE, TOP, PLACE);
    View two = view_raised((Camera){.kind = VIEW_RAISED, .azimuth = 30, .elevation = 50, .zoom = 2}, HOUSE, TOP, PLACE);
    Vec2 middle = vec2_scale(vec2_add(PLACE.low, PLACE.high), 0.5);
    Vec2 a = vec2_sub(view_point(&one, vec2(0, 0), 1), middle), b = vec2_sub(view_point(&two, vec2(0, 0), 1), middle);
    CHECK_NEAR(b.x, 2 * a.x, 1e-9);
    CHECK_NEAR(b.y, 2 * a.y, 1e-9);
}
