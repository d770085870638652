#include "check.h"

#include <stdint.h>
#include <string.h>

#include "base/parallel.h"
#include "base/random.h"
#include "route/fit.h"
#include "route/route.h"

/* A house of a few walls and doors, and a chair in it. */
typedef struct Fixture {
    Vec2 points[16];
    Wall walls[4];
    Door doors[2];
    Exit exits[2];
    Furniture furniture[2];
    Plan plan;
    Outline outline;
    FreeSpace space;
    Profile profile;
    RouteQuery query;
} Fixture;

static Profile chair(double length, double width) {
    return (Profile){.name = "chair",
                     .length = length,
                     .width = width,
                     .axle = 0.28,
                     .free_speed = 0.69,
                     .minimum_speed = 0.3,
                     .steering_time = 0.4,
                     .acceleration = 0.5,
                     .deceleration = 1,
                     .lateral_acceleration = 0.6,
                     .turn_rate = 1,
                     .reversing_speed = 0.3,
                     .reversing_time = 1};
}

/* Called once the plan's parts are in place. */
static void fixture_build(Fixture *fixture) {
    Fault fault = {0};
    CHECK(outline_build(&fixture->outline, &fixture->plan, &fault));
    fault_clear(&fault);
    freespace_build(&fixture->space, &fixture->outline, 0.05);
    fixture->query.plan = &fixture->plan;
    fixture->query.space = &fixture->space;
    fixture->query.profile = &fixture->profile;
    fixture->query.exit = SIZE_MAX;
    fixture->query.most_reversals = 6;
}

static void fixture_free(Fixture *fixture) {
    freespace_free(&fixture->space);
    outline_free(&fixture->outline);
}

/* The largest growth on every side, m, with which the body still gets from the start to an exit. */
static double fits_margin(const RouteQuery *query) {
    Rectangle body = search_body(query->profile);
    Goal goal = field_exit_goal(query->plan, query->exit, query->time, query->open_first);
    FitPlace tightest;
    return fmin(fit_margin(query, &body, &goal, 1, &tightest) + FIT_BIAS, FIT_MOST);
}

/* A passage W1 wide comes down and turns left into one W2 wide; it is shut but for the exit's line in the second arm.
 *
 *      | W1 |
 *      |    |
 *      | v  +----------
 *      |          >   | W2
 *      +---------------  */
static void corner_make(Fixture *fixture, double length, double width, double w1, double w2, bool mirrored) {
    *fixture = (Fixture){.profile = chair(length, width)};
    double arm = 1.5 * length + 0.4, top = w2 + arm, side = w1 + arm, sign = mirrored ? -1 : 1;
    const Vec2 points[7] = {{0, top}, {0, 0}, {side, 0}, {side, w2}, {w1, w2}, {w1, top}, {0, top}};
    for (size_t i = 0; i < 7; i++)
        fixture->points[i] = vec2(sign * points[i].x, points[i].y);
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 7}, .thickness = 0};
    double line = side - length + 0.1;
    fixture->exits[0] = (Exit){.id = "e1", .from = {sign * line, 0}, .to = {sign * line, w2}, .closes = HUGE_VAL};
    fixture->plan =
        (Plan){.name = "corner", .walls = fixture->walls, .wall_count = 1, .exits = fixture->exits, .exit_count = 1};
    fixture->query.at = vec2(sign * w1 / 2, top - 0.28 - 0.05);
    fixture->query.heading = -M_PI_2;
    fixture_build(fixture);
}

/* Two rooms side by side, 3 m by 3 m each, a door between them in the wall "w2", and the exit in the second one. */
static void rooms_make(Fixture *fixture, double width, double door, int state) {
    *fixture = (Fixture){.profile = chair(1.1, width)};
    const Vec2 points[7] = {{0, 0}, {6, 0}, {6, 3}, {0, 3}, {0, 0}, {3, 0}, {3, 3}};
    memcpy(fixture->points, points, sizeof points);
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 5}, .thickness = 0.12};
    fixture->walls[1] = (Wall){.id = "w2", .points = {fixture->points + 5, 2}, .thickness = 0.12};
    fixture->doors[0] = (Door){.id = "d1",
                               .wall = "w2",
                               .at = 1.5,
                               .width = door,
                               .kind = state == DOOR_OPEN ? DOOR_OPENING : DOOR_SLIDING,
                               .state = state,
                               .opening_time = 3,
                               .wall_index = 1};
    fixture->exits[0] = (Exit){.id = "e1", .from = {5, 0}, .to = {5, 3}, .closes = HUGE_VAL};
    fixture->plan = (Plan){.name = "rooms",
                           .walls = fixture->walls,
                           .wall_count = 2,
                           .doors = fixture->doors,
                           .door_count = 1,
                           .exits = fixture->exits,
                           .exit_count = 1,
                           .furniture = fixture->furniture};
    fixture->query.at = vec2(1, 1.5);
    fixture_build(fixture);
}

/* Returns the longest rectangle of a width that turns from W1 into W2. */
static double longest(double width, double w1, double w2) {
    double least = HUGE_VAL;
    for (int i = 1; i < 4000; i++) {
        double t = M_PI_2 * i / 4000;
        least = fmin(least, (w1 * cos(t) + w2 * sin(t) - width) / (sin(t) * cos(t)));
    }
    return least;
}

/* Checks that every pose is free, and every motion between poses is along the heading or a turn on the spot. */
static void check_path(const Fixture *fixture, const Route *route) {
    const Profile *profile = &fixture->profile;
    double least = HUGE_VAL, slip = 0, farthest = 0, turned = 0, length = 0;
    int reversals = 0, last = 0;
    for (size_t i = 0; i < route->count; i++) {
        const Pose *pose = &route->poses[i];
        Vec2 axis = vec2_heading(pose->heading);
        double clearance =
            freespace_clearance(&fixture->space, vec2_along(pose->at, profile->length / 2 - profile->axle, axis), axis,
                                profile->length / 2, profile->width / 2, ROUTE_CLEARANCE_REACH, NULL);
        CHECK_NEAR(pose->clearance, clearance, 1e-12);
        least = fmin(least, clearance);
        if (i == 0)
            continue;
        const Pose *before = &route->poses[i - 1];
        Vec2 motion = vec2_sub(pose->at, before->at);
        double moved = vec2_length(motion), turn = fabs(pose->heading - before->heading);
        length += moved;
        farthest = fmax(farthest, moved);
        turned = fmax(turned, turn);
        if (pose->direction == 0) {
            CHECK_NEAR(moved, 0, 1e-12);
        } else if (moved > 1e-9) {
            Vec2 mean = vec2_heading((pose->heading + before->heading) / 2);
            slip = fmax(slip, fabs(vec2_cross(mean, motion)) / moved);
            CHECK(vec2_dot(mean, motion) * pose->direction > 0);
            reversals += last != 0 && last != pose->direction;
            last = pose->direction;
        }
    }
    CHECK(least > 0);
    CHECK_NEAR(route->narrowest, fmin(least, ROUTE_CLEARANCE_REACH), 1e-12);
    CHECK_NEAR(slip, 0, 0.06);
    CHECK_NEAR(farthest, 0.04, 0.04);
    CHECK_NEAR(turned, 0, radians(16));
    CHECK_NEAR(reversals, route->reversals, 0);
    CHECK_NEAR(length, route->length, 1e-9);
    CHECK(route->fits && route->drivable && route->answer == ROUTE_FOUND);
}

LONG_TEST(fits_flips_within_a_centimetre_of_the_closed_form) {
    Random random = random_seed(7, 1);
    int tried = 0, wrong_above = 0, wrong_below = 0;
    while (tried < 200) {
        double width = 0.4 + 0.4 * random_uniform(&random), w2 = width + 0.05 + 0.6 * random_uniform(&random);
        double length = 0.8 + 0.8 * random_uniform(&random), low = width, high = 3;
        if (longest(width, high, w2) < length || longest(width, low, w2) > length)
            continue;
        while (high - low > 1e-6) {
            double w1 = (low + high) / 2;
            if (longest(width, w1, w2) < length)
                low = w1;
            else
                high = w1;
        }
        if (high < width + 0.05 || fmax(high, w2) + 0.02 > length)
            continue; /* shorter bodies may slide sideways */
        tried++;
        for (int side = -1; side <= 1; side += 2) {
            Fixture fixture;
            corner_make(&fixture, length, width, high + 0.01 * side, w2 + 0.01 * side, false);
            double margin = fits_margin(&fixture.query);
            wrong_above += side > 0 && margin < 0;
            wrong_below += side < 0 && margin >= 0;
            fixture_free(&fixture);
        }
    }
    CHECK_NEAR(wrong_above, 0, 0);
    CHECK_NEAR(wrong_below, 0, 0);
}

TEST(fits_margin_in_a_corner_has_a_closed_form) {
    /* Grown by m on every side: l + 2 m = 2 (sqrt(2) W - w - 2 m). */
    for (double w = 0.80; w < 0.95; w += 0.04) {
        Fixture fixture;
        corner_make(&fixture, 1.1, 0.63, w, w, false);
        CHECK_NEAR(fits_margin(&fixture.query), fmin((2 * (M_SQRT2 * w - 0.63) - 1.1) / 6, 0.1), 0.003);
        fixture_free(&fixture);
    }
}

TEST(a_chair_drives_round_corners_along_free_poses) {
    const double widths[][2] = {{0.95, 0.95}, {1.0, 0.9}, {1.0, 1.0}, {1.2, 1.0}, {1.0, 1.3}, {1.5, 1.5}, {1.8, 0.9}};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        Fixture fixture;
        corner_make(&fixture, 1.1, 0.63, widths[i][0], widths[i][1], false);
        Route route = route_drive(&fixture.query);
        check_path(&fixture, &route);
        CHECK(route.exit == 0);
        CHECK(fits_margin(&fixture.query) >= 0);
        route_free(&route);
        fixture_free(&fixture);
    }
}

TEST(a_mirrored_corner_has_a_mirrored_path) {
    const double widths[][2] = {{1.0, 1.0}, {1.2, 1.0}, {1.5, 1.5}};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        Fixture left, right;
        corner_make(&left, 1.1, 0.63, widths[i][0], widths[i][1], false);
        corner_make(&right, 1.1, 0.63, widths[i][0], widths[i][1], true);
        Route one = route_drive(&left.query), other = route_drive(&right.query);
        CHECK(one.answer == ROUTE_FOUND && other.answer == ROUTE_FOUND);
        CHECK_NEAR(other.reversals, one.reversals, 0);
        CHECK_NEAR(other.length, one.length, 0.015 * one.length);
        check_path(&right, &other);
        route_free(&one);
        route_free(&other);
        fixture_free(&left);
        fixture_free(&right);
    }
}

TEST(the_same_question_has_the_same_answer) {
    Fixture fixture;
    corner_make(&fixture, 1.1, 0.63, 1.0, 1.0, false);
    Route one = route_drive(&fixture.query), other = route_drive(&fixture.query);
    CHECK(one.count > 0 && one.count == other.count);
    for (size_t i = 0; i < one.count && i < other.count; i++)
        CHECK(memcmp(&one.poses[i].at, &other.poses[i].at, sizeof(Vec2)) == 0);
    route_free(&one);
    route_free(&other);
    fixture_free(&fixture);
}

TEST(a_door_narrower_than_the_body_is_named_with_its_widths) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.60, DOOR_OPEN);
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS && !route.fits && !route.drivable);
    CHECK_TEXT(route.blockage.what, "door d1");
    CHECK_NEAR(route.blockage.has, 0.60, 0.005);
    CHECK(route.blockage.needs > 0.63 && route.blockage.needs < 0.66);
    CHECK_NEAR(route.blockage.at.x, 3, 0.1);
    CHECK_NEAR(route.blockage.at.y, 1.5, 0.05);
    double needs = route.blockage.needs;
    route_free(&route);
    CHECK_NEAR(fits_margin(&fixture.query), -0.015, 0.002);
    fixture_free(&fixture);
    rooms_make(&fixture, 0.63, needs, DOOR_OPEN); /* widened to this width, the passage can be driven */
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND);
    route_free(&route);
    fixture_free(&fixture);
}

TEST(a_door_wider_than_the_body_is_driven_through) {
    for (double door = 0.70; door < 1.01; door += 0.1) {
        Fixture fixture;
        rooms_make(&fixture, 0.63, door, DOOR_OPEN);
        Route route = route_drive(&fixture.query);
        check_path(&fixture, &route);
        CHECK(route.narrowest <= (door - 0.63) / 2 + 1e-6);
        CHECK(route.narrowest > fmin((door - 0.63) / 2 - 0.03, 0.04));

        CHECK_NEAR(route.reversals, 0, 0);
        route_free(&route);
        fixture_free(&fixture);
    }
}

TEST(a_locked_door_is_named_and_a_closed_one_passed) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_LOCKED);
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS && !route.fits);
    CHECK_TEXT(route.blockage.what, "locked door d1");
    CHECK_NEAR(route.blockage.has, 0, 0);
    CHECK_NEAR(route.blockage.needs, 0.63, 1e-9);
    route_free(&route);
    route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    CHECK_TEXT(route.blockage.what, "locked door d1");
    route_free(&route);
    fixture_free(&fixture);
    rooms_make(&fixture, 0.63, 0.9, DOOR_CLOSED);
    route = route_drive(&fixture.query);
    check_path(&fixture, &route);
    route_free(&route);
    fixture_free(&fixture);
}

TEST(a_start_in_something_is_said_to_be_so) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.query.at = vec2(0.2, 1.5);
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS && route.count == 0);
    CHECK_TEXT(route.blockage.what, "start, inside wall w1");
    route_free(&route);
    fixture_free(&fixture);
}

TEST(an_exit_that_is_not_there_or_closed_is_no_exit) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[0].closes = 10;
    fixture.query.time = 10;
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_NO_EXIT);
    CHECK_TEXT(route.blockage.what, "exit e1");
    route_free(&route);
    fixture.query.time = 9;
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND);
    route_free(&route);
    fixture.plan.exit_count = 0;
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_NO_EXIT);
    route_free(&route);
    route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_NO_EXIT);
    route_free(&route);
    fixture_free(&fixture);
}

TEST(the_nearer_exit_is_taken_unless_another_is_asked_for) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[1] = (Exit){.id = "e2", .from = {2.4, 0}, .to = {2.4, 3}, .closes = HUGE_VAL};
    fixture.plan.exit_count = 2;
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND && route.exit == 1);
    route_free(&route);
    fixture.query.exit = 0;
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND && route.exit == 0);
    route_free(&route);
    fixture_free(&fixture);
}

TEST(via_points_are_passed_in_order) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    const Vec2 via[2] = {{0.9, 2.3}, {3.9, 2.2}};
    fixture.query.via = via;
    fixture.query.via_count = 2;
    for (int round = 0; round < 2; round++) {
        Route route = round ? route_round(&fixture.query) : route_drive(&fixture.query);
        CHECK(route.answer == ROUTE_FOUND);
        size_t passed = 0;
        for (size_t i = 0; i < route.count && passed < 2; i++)
            passed += vec2_distance(route.poses[i].at, via[passed]) <= 0.55 + 1e-9;
        CHECK_NEAR((double)passed, 2, 0);
        if (!round)
            check_path(&fixture, &route);
        route_free(&route);
    }
    fixture_free(&fixture);
}

TEST(no_more_reversals_are_driven_than_allowed) {
    for (int most = 0; most <= 3; most++) {
        Fixture fixture;
        corner_make(&fixture, 1.1, 0.63, 0.92, 0.92, false);
        fixture.query.most_reversals = most;
        Route route = route_drive(&fixture.query);
        CHECK(route.fits);
        CHECK(route.reversals <= most);
        if (route.answer == ROUTE_FOUND)
            check_path(&fixture, &route);
        else
            CHECK(route.blockage.needs > route.blockage.has && route.blockage.has > 0.7);
        route_free(&route);
        fixture_free(&fixture);
    }
}

/* Returns the length of the shortest path between two places around a circle about `middle`. */
static double string_length(Vec2 from, Vec2 middle, Vec2 to, double radius) {
    Vec2 one = vec2_sub(from, middle), other = vec2_sub(to, middle);
    double a = vec2_length(one), b = vec2_length(other), angle = 2 * M_PI - acos(vec2_dot(one, other) / (a * b));
    double arc = angle - acos(radius / a) - acos(radius / b);
    return sqrt(a * a - radius * radius) + sqrt(b * b - radius * radius) + radius * fmax(arc, 0);
}

TEST(a_disc_takes_the_short_way_round_a_corner) {
    Fixture fixture;
    corner_make(&fixture, 1.1, 0.63, 1.2, 1.2, false);
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
    fixture_free(&fixture);
}

TEST(a_disc_passes_a_door_a_centimetre_wider_and_no_narrower_one) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.64, DOOR_OPEN);
    Route route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND);
    CHECK(route.narrowest > 0 && route.narrowest <= 0.005 + 1e-9);
    route_free(&route);
    fixture_free(&fixture);
    rooms_make(&fixture, 0.63, 0.62, DOOR_OPEN);
    route = route_round(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    CHECK_TEXT(route.blockage.what, "door d1");
    CHECK_NEAR(route.blockage.has, 0.62, 0.005);
    CHECK_NEAR(route.blockage.needs, 0.63, 0.01);
    route_free(&route);
    fixture_free(&fixture);
}

/* Questions asked by several threads, and their answers. */
typedef struct Asked {
    const RouteQuery *queries; /* (count) */
    Route *routes;             /* (count) */
} Asked;

static void ask(void *context, size_t i) {
    Asked *asked = context;
    asked->routes[i] = i % 4 == 3 ? route_round(&asked->queries[i]) : route_drive(&asked->queries[i]);
}

static bool same_route(const Route *one, const Route *other) {
    if (one->answer != other->answer || one->count != other->count || one->exit != other->exit)
        return false;
    for (size_t i = 0; i < one->count; i++)
        if (memcmp(&one->poses[i].at, &other->poses[i].at, sizeof(Vec2)) != 0 ||
            memcmp(&one->poses[i].heading, &other->poses[i].heading, sizeof(double)) != 0 ||
            memcmp(&one->poses[i].clearance, &other->poses[i].clearance, sizeof(double)) != 0)
            return false;
    return true;
}

TEST(shared_fields_change_no_bit_of_any_answer) {
    enum { COUNT = 24 };
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_CLOSED);
    fixture.exits[1] = (Exit){.id = "e2", .from = {0.8, 0}, .to = {0.8, 3}, .closes = 10};
    fixture.plan.exit_count = 2;
    Profile small = chair(1.0, 0.5);
    const Vec2 via[1] = {{3.9, 2.2}};
    RouteQuery queries[COUNT];
    Route alone[COUNT], shared[COUNT];
    Random random = random_seed(7, 3);
    for (int i = 0; i < COUNT; i++) {
        queries[i] = fixture.query;
        queries[i].at = vec2(1.2 + 0.8 * random_uniform(&random), 1 + random_uniform(&random));
        queries[i].heading = 2 * M_PI * random_uniform(&random);
        queries[i].time = 20 * random_uniform(&random);
        queries[i].via = via;
        queries[i].via_count = i % 3 == 0;
        queries[i].profile = i % 5 == 0 ? &small : &fixture.profile;
        queries[i].exit = i % 7 == 0 ? 0 : SIZE_MAX;
    }
    parallel_for(1, COUNT, ask, &(Asked){queries, alone});
    for (int jobs = 1; jobs <= 4; jobs += 3) {
        Fields *fields = fields_create();
        for (int i = 0; i < COUNT; i++)
            queries[i].fields = fields;
        parallel_for(jobs, COUNT, ask, &(Asked){queries, shared});
        for (int i = 0; i < COUNT; i++) {
            CHECK(alone[i].answer == ROUTE_FOUND);
            CHECK(same_route(&alone[i], &shared[i]));
            route_free(&shared[i]);
        }
        fields_destroy(fields);
    }
    for (int i = 0; i < COUNT; i++)
        route_free(&alone[i]);
    fixture_free(&fixture);
}

TEST(one_field_serves_all_who_wish_for_the_same) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[0].closes = 10;
    Fields *fields = fields_create();
    FieldKey key = {&fixture.plan, &fixture.space, &fixture.profile, 0.3,
                    .goal = field_exit_goal(&fixture.plan, SIZE_MAX, 0, false)};
    const Field *one = fields_acquire(fields, &key);
    key.goal.time = 9; /* the exit is usable as before */
    const Field *other = fields_acquire(fields, &key);
    CHECK(one == other);
    fields_release(fields, one);
    fields_release(fields, other);
    key.goal.time = 11;
    other = fields_acquire(fields, &key);
    CHECK(one != other && !isfinite(field_time(other, vec2(1, 1))));
    fields_release(fields, other);
    key.goal.time = 0;
    key.radius = 0.25;
    other = fields_acquire(fields, &key);
    CHECK(one != other && isfinite(field_time(other, vec2(1, 1))));
    fields_release(fields, other);
    fields_destroy(fields);
    fixture_free(&fixture);
}

TEST(planned_again_halfway_a_closed_exit_is_left_for_another) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[1] = (Exit){.id = "e2", .from = {0.9, 0}, .to = {0.9, 3}, .closes = HUGE_VAL};
    fixture.plan.exit_count = 2;
    fixture.query.at = vec2(2, 1.5);
    fixture.query.exit = 0;
    Route first = route_drive(&fixture.query);
    CHECK(first.answer == ROUTE_FOUND && first.exit == 0);
    fixture.query.exit = SIZE_MAX;
    fixture.query.time = 10;
    fixture.exits[0].closes = 10;
    for (size_t i = 5; i + 10 < first.count; i += 10) {
        fixture.query.at = first.poses[i].at;
        fixture.query.heading = first.poses[i].heading;
        Route again = route_drive(&fixture.query);
        CHECK(again.exit == 1);
        check_path(&fixture, &again);
        CHECK_NEAR(vec2_distance(again.poses[0].at, fixture.query.at), 0, 0);
        CHECK_NEAR(again.poses[0].heading, fixture.query.heading, 0);
        route_free(&again);
    }
    route_free(&first);
    fixture_free(&fixture);
}

TEST(an_exit_that_opens_later_is_left_out_only_if_another_is_open) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[0].opens = 50;
    fixture.exits[1] = (Exit){.id = "e2", .from = {0.9, 0}, .to = {0.9, 3}, .closes = HUGE_VAL};
    fixture.plan.exit_count = 2;
    fixture.query.at = vec2(4.2, 1.5);
    fixture.query.time = 10;
    const size_t expected[2][3] = {{0, 0, 0}, {1, 0, 0}}; /* by open_first and case */
    for (int open_first = 0; open_first < 2; open_first++)
        for (int n = 0; n < 3; n++) {
            fixture.exits[1].opens = n == 1 ? 60 : 0;   /* neither is open */
            fixture.query.exit = n == 2 ? 0 : SIZE_MAX; /* only the first counts */
            fixture.query.open_first = open_first;
            Route route = route_drive(&fixture.query);
            CHECK(route.answer == ROUTE_FOUND && route.exit == expected[open_first][n]);
            route_free(&route);
        }
    fixture_free(&fixture);
}

TEST(a_chair_may_start_anyhow_where_it_is_free) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    Random random = random_seed(7, 4);
    int tried = 0;
    while (tried < 30) {
        fixture.query.at = vec2(0.4 + 4.4 * random_uniform(&random), 0.4 + 2.2 * random_uniform(&random));
        fixture.query.heading = 40 * random_uniform(&random) - 20;
        Vec2 axis = vec2_heading(fixture.query.heading);
        if (freespace_clearance(&fixture.space, vec2_along(fixture.query.at, 0.55 - 0.28, axis), axis, 0.55, 0.315, 0.1,
                                NULL) < 0.01)
            continue;
        tried++;
        Route route = route_drive(&fixture.query);
        check_path(&fixture, &route);
        route_free(&route);
    }
    fixture_free(&fixture);
}

TEST(a_chair_that_presses_on_a_wall_is_planned_from_beside_it) {
    Fixture fixture;
    rooms_make(&fixture, 0.63, 0.9, DOOR_OPEN);
    const double deep = 0.008;
    /* A pose in the corner of the two walls' faces at 0.06, tail first. */
    fixture.query.at = vec2(0.06 + 0.28 - deep, 0.06 + 0.315 - deep);
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    route_free(&route);
    fixture.query.pressed = 0.02;
    route = route_drive(&fixture.query);
    check_path(&fixture, &route);
    if (route.count > 0) {
        CHECK_NEAR(vec2_distance(route.poses[0].at, fixture.query.at), (deep + ROUTE_EASED) * M_SQRT2, 0.01);
        CHECK_NEAR(route.poses[0].heading, fixture.query.heading, 0);
    }
    route_free(&route);
    fixture.query.pressed = deep / 2;
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    CHECK_TEXT(route.blockage.what, "start, inside wall w1");
    route_free(&route);
    fixture_free(&fixture);
}
