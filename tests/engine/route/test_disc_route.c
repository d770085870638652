#include "check.h"

#include <math.h>

#include "rooms.h"

/* Returns the length of the shortest path between two places around a circle about `middle`. */
static double string_length(Vec2 from, Vec2 middle, Vec2 to, double radius) {
    Vec2 one = vec2_sub(from, middle), other = vec2_sub(to, middle);
    double a = vec2_length(one), b = vec2_length(other), angle = 2 * M_PI - acos(vec2_dot(one, other) / (a * b));
    double arc = angle - acos(radius / a) - acos(radius / b);
    return sqrt(a * a - radius * radius) + sqrt(b * b - radius * radius) + radius * fmax(arc, 0);
}

TEST(a_disc_takes_the_short_way_round_a_corner) {
    Rooms fixture;
    rooms_make_corner(&fixture, 1.1, 0.63, 1.2, 1.2, false);
    Route route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND && route.fits && route.drivable && route.reversals == 0);
    Vec2 start = fixture.query.at, inner = vec2(1.2, 1.2), end = route.poses[route.count - 1].at;
    CHECK(route.length > string_length(start, inner, end, 0.315));
    CHECK(route.length < string_length(start, inner, end, 0.365) + 0.1);
    double least = HUGE_VAL, farthest = 0;
    for (size_t i = 0; i < route.count; i++) {
        double clearance = freespace_exact(&fixture.space, route.poses[i].at, 1, NULL) - 0.315;
        least = fmin(least, clearance);
        CHECK_NEAR(fmin(clearance, 0.5), route.poses[i].clearance, 1e-9);
        if (i > 0)
            farthest = fmax(farthest, vec2_distance(route.poses[i].at, route.poses[i - 1].at));
    }
    CHECK(least > 0.01); /* where it starts */
    CHECK(farthest < 0.0501);
    route_free(&route);
    rooms_free(&fixture);
}

TEST(a_disc_passes_a_door_a_centimetre_wider_and_no_narrower_one) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.64, DOOR_OPEN);
    Route route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND);
    CHECK(route.narrowest > 0 && route.narrowest <= 0.005 + 1e-9);
    route_free(&route);
    rooms_free(&fixture);
    rooms_make_two(&fixture, 0.63, 0.62, DOOR_OPEN);
    route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    CHECK_TEXT(route.blockage.what, "door d1");
    CHECK_NEAR(route.blockage.has, 0.62, 0.005);
    CHECK_NEAR(route.blockage.needs, 0.63, 0.01);
    route_free(&route);
    rooms_free(&fixture);
}
