#include "check.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/random.h"
#include "base/stop.h"
#include "rooms.h"
#include "route/search.h"

TEST(a_chair_drives_round_corners_along_free_poses) {
    const double widths[][2] = {{0.95, 0.95}, {1.0, 0.9}, {1.0, 1.0}, {1.2, 1.0}, {1.0, 1.3}, {1.5, 1.5}, {1.8, 0.9}};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        Rooms fixture;
        rooms_make_corner(&fixture, 1.1, 0.63, widths[i][0], widths[i][1], false);
        Route route = route_drive(&fixture.query);
        rooms_check_path(&fixture, &route);
        CHECK(route.exit == 0);
        CHECK(rooms_fit_margin(&fixture) >= 0);
        route_free(&route);
        rooms_free(&fixture);
    }
}

TEST(a_mirrored_corner_has_a_mirrored_path) {
    const double widths[][2] = {{1.0, 1.0}, {1.2, 1.0}, {1.5, 1.5}};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        Rooms left, right;
        rooms_make_corner(&left, 1.1, 0.63, widths[i][0], widths[i][1], false);
        rooms_make_corner(&right, 1.1, 0.63, widths[i][0], widths[i][1], true);
        Route one = route_drive(&left.query), other = route_drive(&right.query);
        CHECK(one.answer == ROUTE_FOUND && other.answer == ROUTE_FOUND);
        CHECK_NEAR(other.reversals, one.reversals, 0);
        CHECK_NEAR(other.length, one.length, 0.015 * one.length);
        rooms_check_path(&right, &other);
        route_free(&one);
        route_free(&other);
        rooms_free(&left);
        rooms_free(&right);
    }
}

TEST(the_same_question_has_the_same_answer) {
    Rooms fixture;
    rooms_make_corner(&fixture, 1.1, 0.63, 1.0, 1.0, false);
    Route one = route_drive(&fixture.query), other = route_drive(&fixture.query);
    CHECK(one.count > 0 && one.count == other.count);
    for (size_t i = 0; i < one.count && i < other.count; i++)
        CHECK(memcmp(&one.poses[i].at, &other.poses[i].at, sizeof(Vec2)) == 0);
    route_free(&one);
    route_free(&other);
    rooms_free(&fixture);
}

TEST(an_interrupted_search_says_neither_yes_nor_no) {
    const double doors[] = {0.90, 0.60};
    const Stop stop = {1};
    for (size_t i = 0; i < sizeof doors / sizeof *doors; i++) {
        Rooms fixture;
        rooms_make_two(&fixture, 0.63, doors[i], DOOR_OPEN);
        fixture.query.stop = &stop;
        Route driven = route_drive(&fixture.query);
        CHECK(driven.answer == ROUTE_INTERRUPTED && !driven.poses && !*driven.blockage.what);
        CHECK_NEAR(driven.blockage.needs, 0, 0);
        rooms_free(&fixture);
    }
}

TEST(a_door_narrower_than_the_body_is_named_with_its_widths) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.60, DOOR_OPEN);
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS && !route.fits && !route.drivable);
    CHECK_TEXT(route.blockage.what, "door d1");
    CHECK_NEAR(route.blockage.has, 0.60, 0.005);
    CHECK(route.blockage.needs > 0.63 && route.blockage.needs < 0.66 && !route.blockage.estimated);
    CHECK_NEAR(route.blockage.at.x, 3, 0.1);
    CHECK_NEAR(route.blockage.at.y, 1.5, 0.05);
    double needs = route.blockage.needs;
    route_free(&route);
    CHECK_NEAR(rooms_fit_margin(&fixture), -0.015, 0.002);
    rooms_free(&fixture);
    rooms_make_two(&fixture, 0.63, needs, DOOR_OPEN); /* widened to this width, the passage can be driven */
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND);
    route_free(&route);
    rooms_free(&fixture);
    rooms_make_two(&fixture, 0.63, needs - 0.01, DOOR_OPEN); /* that is a whole centimetre, and the least one */
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    route_free(&route);
    rooms_free(&fixture);
}

TEST(only_a_chair_that_skids_is_told_the_skids_with_which_it_could_pass) {
    for (int skids = 0; skids < 2; skids++) {
        Rooms fixture;
        rooms_make_corner(&fixture, 1.1, 0.63, 0.87, 0.87, false);
        fixture.profile.skid_time = skids ? 100 : 0;
        Route route = route_drive(&fixture.query);
        char text[64];
        route_skids(&route.blockage, text, sizeof text);
        CHECK(route.answer == ROUTE_CANNOT_PASS && route.fits);
        CHECK((route.blockage.skid > 0 && route.blockage.skid < 0.15) == (skids > 0));
        CHECK((strstr(text, "could pass with skids of 0.1") == text) == (skids > 0));
        route_free(&route);
        rooms_free(&fixture);
    }
}

TEST(a_door_wider_than_the_body_is_driven_through) {
    for (double door = 0.70; door < 1.01; door += 0.1) {
        Rooms fixture;
        rooms_make_two(&fixture, 0.63, door, DOOR_OPEN);
        Route route = route_drive(&fixture.query);
        rooms_check_path(&fixture, &route);
        CHECK(route.narrowest <= (door - 0.63) / 2 + 1e-6);
        CHECK(route.narrowest > fmin((door - 0.63) / 2 - 0.03, 0.04));

        CHECK_NEAR(route.reversals, 0, 0);
        route_free(&route);
        rooms_free(&fixture);
    }
}

TEST(a_locked_door_is_named_and_a_closed_one_passed) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_LOCKED);
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
    rooms_free(&fixture);
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_CLOSED);
    route = route_drive(&fixture.query);
    rooms_check_path(&fixture, &route);
    route_free(&route);
    rooms_free(&fixture);
}

TEST(a_start_in_something_is_said_to_be_so) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.query.at = vec2(0.2, 1.5);
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS && route.count == 0);
    CHECK_TEXT(route.blockage.what, "start, inside wall w1");
    route_free(&route);
    rooms_free(&fixture);
}

TEST(an_exit_that_is_not_there_or_closed_is_no_exit) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
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
    rooms_free(&fixture);
}

TEST(the_nearer_exit_is_taken_unless_another_is_asked_for) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[1] = (Exit){.id = "e2", .from = {2.4, 0}, .to = {2.4, 3}, .closes = HUGE_VAL};
    fixture.plan.exit_count = 2;
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND && route.exit == 1);
    route_free(&route);
    fixture.query.exit = 0;
    route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_FOUND && route.exit == 0);
    route_free(&route);
    rooms_free(&fixture);
}

TEST(via_points_are_passed_in_order) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
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
            rooms_check_path(&fixture, &route);
        route_free(&route);
    }
    rooms_free(&fixture);
}

TEST(no_more_reversals_are_driven_than_allowed) {
    for (int most = 0; most <= 3; most++) {
        Rooms fixture;
        rooms_make_corner(&fixture, 1.1, 0.63, 0.92, 0.92, false);
        fixture.query.most_reversals = most;
        Route route = route_drive(&fixture.query);
        CHECK(route.fits);
        CHECK(route.reversals <= most);
        if (route.answer == ROUTE_FOUND)
            rooms_check_path(&fixture, &route);
        else
            CHECK(route.blockage.needs > route.blockage.has && route.blockage.has > 0.7);
        route_free(&route);
        rooms_free(&fixture);
    }
}

/* The chair that is shown where it sticks lies on the corner, in houses that are turned, too. */
TEST(where_a_chair_sticks_its_pose_is_known) {
    for (int k = 0; k < 12; k++) {
        Rooms rooms;
        double width = 0.76 + 0.01 * k;
        rooms_make_corner(&rooms, 1.1, 0.63, width, width, false);
        rooms_turn(&rooms, radians(31) * k, vec2(0.3 * k, -0.7));
        Route route = route_drive(&rooms.query);
        const Blockage *blockage = &route.blockage;
        Rectangle body = search_body(rooms.query.profile);
        Vec2 axis = vec2_heading(blockage->heading), reference = vec2_along(blockage->middle, -body.ahead, axis);
        CHECK(route.answer == ROUTE_CANNOT_PASS && blockage->posed);
        double clearance = search_clearance(rooms.query.space, &body, reference, blockage->heading, 1, NULL);
        CHECK(clearance > -0.1 && clearance < 0.03);
        CHECK(vec2_distance(blockage->middle, blockage->at) < body.half_length + body.half_width);
        CHECK(fabs(vec2_dot(vec2_unit(axis), vec2_heading(radians(31) * k))) < 0.99); /* on the slant of both legs */
        CHECK(fabs(vec2_cross(vec2_unit(axis), vec2_heading(radians(31) * k))) < 0.99);
        route_free(&route);
        rooms_free(&rooms);
    }
}

TEST(any_way_is_free_and_found_where_the_quickest_is) {
    for (int width = 82; width <= 98; width += 8) {
        Rooms fixture;
        rooms_make_corner(&fixture, 1.1, 0.63, width / 100.0, width / 100.0, false);
        rooms_turn(&fixture, 0.4, vec2(0.3, -0.2));
        fixture.query.brief = true;
        Route quickest = route_drive(&fixture.query);
        fixture.query.any = true;
        Route any = route_drive(&fixture.query);
        CHECK(any.answer == quickest.answer && any.fits == quickest.fits);
        if (any.answer == ROUTE_FOUND)
            rooms_check_path(&fixture, &any);
        route_free(&any);
        route_free(&quickest);
        rooms_free(&fixture);
    }
}

TEST(planned_again_halfway_a_closed_exit_is_left_for_another) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
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
        rooms_check_path(&fixture, &again);
        CHECK_NEAR(vec2_distance(again.poses[0].at, fixture.query.at), 0, 0);
        CHECK_NEAR(again.poses[0].heading, fixture.query.heading, 0);
        route_free(&again);
    }
    route_free(&first);
    rooms_free(&fixture);
}

TEST(an_exit_that_opens_only_later_does_not_count) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[0].opens = 50;
    fixture.exits[1] = (Exit){.id = "e2", .from = {0.9, 0}, .to = {0.9, 3}, .opens = 20, .closes = HUGE_VAL};
    fixture.plan.exit_count = 2;
    fixture.query.at = vec2(4.2, 1.5);
    const struct {
        double opens_before; /* s */
        RouteAnswer answer;
        size_t exit;
    } cases[] = {{0, ROUTE_FOUND, 0}, {51, ROUTE_FOUND, 0}, {50, ROUTE_FOUND, 1}, {20, ROUTE_NO_EXIT, SIZE_MAX}};
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        fixture.query.opens_before = cases[n].opens_before;
        Route route = route_drive(&fixture.query);
        CHECK(route.answer == cases[n].answer && route.exit == cases[n].exit);
        route_free(&route);
    }
    rooms_free(&fixture);
}

TEST(a_chair_may_start_anyhow_where_it_is_free) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
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
        rooms_check_path(&fixture, &route);
        route_free(&route);
    }
    rooms_free(&fixture);
}

TEST(a_chair_that_presses_on_a_wall_is_planned_from_beside_it) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
    const double deep = 0.008;
    /* A pose in the corner of the two walls' faces at 0.06, tail first. */
    fixture.query.at = vec2(0.06 + 0.28 - deep, 0.06 + 0.315 - deep);
    Route route = route_drive(&fixture.query);
    CHECK(route.answer == ROUTE_CANNOT_PASS);
    route_free(&route);
    fixture.query.pressed = 0.02;
    route = route_drive(&fixture.query);
    rooms_check_path(&fixture, &route);
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
    rooms_free(&fixture);
}

/* A chair cannot be pushed sideways from a jamb that holds its front corner. */
TEST(a_chair_that_a_jamb_holds_first_goes_back) {
    for (int k = 0; k <= 4; k++) {
        Rooms fixture;
        rooms_make_two(&fixture, 0.63, 0.8, DOOR_OPEN);
        fixture.query.at = vec2(2.94 + 0.03 - (1.1 - 0.28), 1.5 - 0.4 + 0.315 - 0.004);
        fixture.query.pressed = 0.02;
        rooms_turn(&fixture, radians(8) * k, vec2(0.3, -0.7));
        Route route = route_drive(&fixture.query);
        CHECK(route.count > 2 && route.poses[1].direction == -1);
        CHECK_NEAR(vec2_distance(route.poses[0].at, fixture.query.at), 0, 0);
        if (route.count > 2) {
            Vec2 moved = vec2_sub(route.poses[1].at, route.poses[0].at), axis = vec2_heading(fixture.query.heading);
            CHECK_NEAR(vec2_cross(axis, moved), 0, 1e-9);
            CHECK(vec2_dot(axis, moved) < -0.02 && vec2_dot(axis, moved) > -0.15);
            CHECK(route.reversals >= 1);
            for (size_t i = 1; i < route.count; i++)
                CHECK(route.poses[i].clearance > 0);
        }
        route_free(&route);
        rooms_free(&fixture);
    }
}

/* A wardrobe in two rooms of 3 m x 3 m leaves a place too narrow for a chair. */
static Route route_past_wardrobe(Rooms *rooms, double door, Vec2 centre, Vec2 size, bool round) {
    rooms_make_two(rooms, 0.63, door, DOOR_OPEN);
    rooms_free(rooms);
    rooms->furniture[0] = (Furniture){.id = "f1", .name = "wardrobe", .centre = centre, .size = size, .height = 2};
    rooms->plan.furniture_count = 1;
    rooms_build(rooms);
    return round ? route_round(&rooms->query) : route_drive(&rooms->query);
}

TEST(furniture_that_narrows_a_place_is_named_before_a_wall_or_a_door) {
    static const struct {
        double door;
        Vec2 centre, size;
        const char *what, *beside;
    } cases[] = {
        {0.9, {3, 1.8}, {0.6, 0.6}, "wardrobe", "door d1"}, /* in the door's opening */
        {0.9, {4.5, 1.45}, {0.4, 1.9}, "wardrobe", "wall"}, /* across a room */
        {0.5, {4.5, 0.5}, {0.4, 0.4}, "door d1", ""},       /* aside, where the door itself is too narrow */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int round = 0; round < 2; round++) {
            Rooms rooms;
            Route route = route_past_wardrobe(&rooms, cases[i].door, cases[i].centre, cases[i].size, round);
            CHECK(route.answer == ROUTE_CANNOT_PASS);
            CHECK(strncmp(route.blockage.what, cases[i].what, strlen(cases[i].what)) == 0);
            CHECK(strncmp(route.blockage.beside, cases[i].beside, strlen(cases[i].beside)) == 0);
            CHECK(*cases[i].beside || !*route.blockage.beside);
            char widths[ROUTE_WIDTHS];
            route_widths(&route.blockage, widths, sizeof widths);
            CHECK(strstr(widths, " m beside ") || !*cases[i].beside);
            route_free(&route);
            rooms_free(&rooms);
        }
    }
}
