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
    CHECK_NEAR(route.blockage.has, 0.62, 1e-6);
    route_free(&route);
    rooms_free(&fixture);
}

TEST(the_width_that_a_door_needs_for_a_disc_is_tried) {
    for (int door = 55; door <= 63; door++) {
        Rooms fixture;
        rooms_make_two(&fixture, 0.63, door / 100.0, DOOR_OPEN);
        Route route = route_round(&fixture.query);
        CHECK(route.answer == ROUTE_CANNOT_PASS && !route.blockage.estimated);
        CHECK_NEAR(route.blockage.has, door / 100.0, 1e-6);
        CHECK(route.blockage.needs > 0.63 && route.blockage.needs < 0.66);
        double needs = route.blockage.needs;
        route_free(&route);
        rooms_free(&fixture);
        for (int less = 0; less <= 1; less++) {
            rooms_make_two(&fixture, 0.63, needs - less * 0.01, DOOR_OPEN);
            route = route_round(&fixture.query);
            CHECK((route.answer == ROUTE_FOUND) == !less);
            route_free(&route);
            rooms_free(&fixture);
        }
    }
}

/* Returns the blockage of a disc of 0.63 m in two rooms with a door, where one can walk round the exit's line. */
static Blockage blockage_before_line(double door, int state, Vec2 from, Vec2 to) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, door, state);
    fixture.exits[0].from = from;
    fixture.exits[0].to = to;
    Route route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    Blockage blockage = route.blockage;
    route_free(&route);
    rooms_free(&fixture);
    return blockage;
}

TEST(the_place_is_found_also_before_an_exit_that_can_be_walked_round) {
    for (int x = 0; x < 6; x++)
        for (int y = 0; y < 9; y++) {
            Vec2 low = {3.9 + 0.31 * x, 0.2 + 0.25 * y}, high = vec2_add(low, vec2(0, 0.5));
            Blockage narrow = blockage_before_line(0.6, DOOR_OPEN, low, high);
            CHECK_TEXT(narrow.what, "door d1");
            CHECK_NEAR(narrow.has, 0.6, 1e-6);
            Blockage locked = blockage_before_line(0.9, DOOR_LOCKED, high, low);
            CHECK_TEXT(locked.what, "locked door d1");
            CHECK_NEAR(locked.at.x, 3, 0.1);
            CHECK_NEAR(locked.at.y, 1.5, 0.5);
        }
}

/* Returns the route of a disc of 0.63 m that meets two pieces of furniture `gap` m apart, in rooms that are turned by
 * `angle` and shifted; the place of its blockage in the rooms as they were. */
static Route route_between_pieces(double gap, double angle, Vec2 shift) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 1.2, DOOR_OPEN);
    rooms_free(&fixture);
    Vec2 axis = vec2_heading(angle);
    for (size_t i = 0; i < 16; i++)
        fixture.points[i] = vec2_add(vec2_turn(fixture.points[i], axis), shift);
    fixture.exits[0].from = vec2_add(vec2_turn(fixture.exits[0].from, axis), shift);
    fixture.exits[0].to = vec2_add(vec2_turn(fixture.exits[0].to, axis), shift);
    double depth = (3 - 0.12 - gap) / 2; /* of two pieces that stand against the walls */
    for (int k = 0; k < 2; k++) {
        Vec2 centre = vec2(4, k ? 2.94 - depth / 2 : 0.06 + depth / 2);
        fixture.furniture[k] = (Furniture){.id = k ? "b" : "a",
                                           .name = "piece",
                                           .centre = vec2_add(vec2_turn(centre, axis), shift),
                                           .size = {0.4, depth},
                                           .angle = degrees(angle)};
    }
    fixture.plan.furniture_count = 2;
    fixture.query.at = vec2_add(vec2_turn(vec2(1, 1.5), axis), shift);
    rooms_build(&fixture);
    Route route = route_round(&fixture.query);
    route.blockage.at = vec2_unturn(vec2_sub(route.blockage.at, shift), axis);
    rooms_free(&fixture);
    return route;
}

TEST(the_width_of_a_refused_disc_is_that_of_a_tape) {
    static const double gaps[] = {0.11, 0.2, 0.451, 0.6, 0.615}, angles[] = {0, 0.13, 0.5, M_PI_4, 1.4};
    for (size_t g = 0; g < sizeof gaps / sizeof *gaps; g++)
        for (size_t a = 0; a < sizeof angles / sizeof *angles; a++) {
            Route route = route_between_pieces(gaps[g], angles[a], vec2(0.017 * (double)a, -3.301));
            Blockage blockage = route.blockage;
            CHECK(route.answer == ROUTE_CANNOT_PASS);
            route_free(&route);
            CHECK_NEAR(blockage.has, gaps[g], 1e-3);
            CHECK(blockage.estimated);
            CHECK_NEAR(blockage.needs, 0.63, 1e-12);
            CHECK_NEAR(blockage.at.x, 4, 0.25);
            CHECK_NEAR(blockage.at.y, 1.5, 5e-3);
        }
}

TEST(a_disc_passes_a_gap_hardly_wider_however_it_lies) {
    static const double gaps[] = {0.628, 0.632, 0.635, 0.64, 0.645}, angles[] = {0, 0.13, 0.5, M_PI_4, 1.4};
    for (size_t g = 0; g < sizeof gaps / sizeof *gaps; g++)
        for (size_t a = 0; a < sizeof angles / sizeof *angles; a++) {
            Route route =
                route_between_pieces(gaps[g], angles[a], vec2(0.017 * (double)a, -3.301 + 0.0071 * (double)g));
            CHECK((route.answer == ROUTE_FOUND) == (gaps[g] > 0.63));
            CHECK(route.answer != ROUTE_FOUND || route.narrowest >= 0);
            route_free(&route);
        }
}
