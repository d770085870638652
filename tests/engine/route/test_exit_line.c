/* Tests exits whose lines lie on points of the grid of distances, or so near to them that rounding decides on which
 * side the points are: for discs, chairs and walkers. */

#include "check.h"

#include <math.h>
#include <stdint.h>

#include "case.h"
#include "plan/plan_geometry.h"
#include "rooms.h"
#include "route/disc_route.h"
#include "route/fit.h"
#include "route/floor_field.h"

/* How an exit's line lies on the grid. */
typedef enum Lie { LIE_COLUMN, LIE_ROW, LIE_LOW_ROW, LIE_DIAGONAL, LIE_ANTIDIAGONAL, LIE_COUNT } Lie;

enum { FURTHER = 6 };

/* How far beside the points, to the right or upwards. */
typedef enum Beside {
    BESIDE_ON,
    BESIDE_ULP_LESS,
    BESIDE_ULP_MORE,
    BESIDE_HAIR_LESS,
    BESIDE_HAIR_MORE,
    BESIDE_LESS,
    BESIDE_MORE,
    BESIDE_COUNT
} Beside;

static double beside(double value, Beside by) {
    switch (by) {
    case BESIDE_ON:
    case BESIDE_COUNT:
        return value;
    case BESIDE_ULP_LESS:
        return nextafter(value, -HUGE_VAL);
    case BESIDE_ULP_MORE:
        return nextafter(value, HUGE_VAL);
    case BESIDE_HAIR_LESS:
        return value - 1e-12;
    case BESIDE_HAIR_MORE:
        return value + 1e-12;
    case BESIDE_LESS:
        return value - 1e-9;
    case BESIDE_MORE:
        return value + 1e-9;
    }
    return value;
}

/* Returns the coordinate of the grid's point nearest to a coordinate, computed as the searches do. */
static double on_grid(double origin, double cell, double near) {
    return origin + (int)round((near - origin) / cell) * cell;
}

/* Puts the exit's line of the second of the two rooms on the grid's points, or beside them, some points further. */
static void lay_exit(Rooms *fixture, Lie lie, Beside by, int further, bool swapped) {
    const FreeSpace *space = &fixture->space;
    double cell = space->cell, more = further * cell,
           x = on_grid(space->origin.x, cell, (lie < LIE_DIAGONAL ? 4.4 : 3.6) + more);
    Vec2 from = {x, 0}, to = {x, 3};
    if (lie == LIE_ROW || lie == LIE_LOW_ROW) {
        from = vec2(3, on_grid(space->origin.y, cell, lie == LIE_ROW ? 2.0 + more : 1.0 - more));
        to = vec2(6, from.y);
    } else if (lie != LIE_COLUMN) {
        int i = (int)round((x - space->origin.x) / cell), sign = lie == LIE_DIAGONAL ? 1 : -1;
        int j = (int)round(((lie == LIE_DIAGONAL ? 0 : 3) - space->origin.y) / cell), steps = 48;
        from.y = space->origin.y + j * cell;
        to = vec2(space->origin.x + (i + steps) * cell, space->origin.y + (j + sign * steps) * cell);
    }
    if (lie == LIE_COLUMN) {
        from.x = to.x = beside(x, by);
    } else {
        from.y = beside(from.y, by);
        to.y = beside(to.y, by);
    }
    fixture->exits[0].from = swapped ? to : from;
    fixture->exits[0].to = swapped ? from : to;
}

/* Returns how far a place is to the left of the exit's line, m. */
static double left_of_exit(const Rooms *fixture, Vec2 at) {
    const Exit *exit = &fixture->exits[0];
    return vec2_cross(vec2_unit(vec2_sub(exit->to, exit->from)), vec2_sub(at, exit->from));
}

static void make_rooms(Rooms *fixture) {
    rooms_make_two(fixture, 0.5, 0.8, DOOR_OPEN);
    fixture->profile.length = 0.8;
}

static bool leads_out(const Rooms *fixture, size_t exit, Vec2 end) {
    return exit == 0 && left_of_exit(fixture, end) * left_of_exit(fixture, fixture->query.at) < 0 &&
           fabs(left_of_exit(fixture, end)) > 0.01;
}

TEST(an_exits_line_belongs_to_neither_side) {
    for (int turned = 0; turned < 12; turned++) {
        Vec2 axis = vec2_heading(turned * M_PI / 6 + 0.1), origin = {17.3, -4.1};
        const struct {
            Vec2 from, to;
            bool out;
        } motions[] = {
            {{1, -1}, {1, 1}, true},       {{1, -1}, {1, 0}, true},       {{1, 0}, {1, -1}, true},
            {{1, 0}, {1, 1}, true},        {{1, 1e-12}, {1, -0.1}, true}, {{1, 1e-12}, {1, 0.1}, true},
            {{1, 1e-6}, {1, 1}, false},    {{1, -1e-6}, {1, 1e-6}, true}, {{1, 0}, {1, 0}, false},
            {{0.5, 0}, {1.5, 0}, false},   {{-1, 0}, {1, 0}, false},      {{2.5, 0}, {3, 0}, false},
            {{2.5, 0}, {2.5, 1}, false},   {{2.5, -1}, {2.5, 1}, false},  {{2.5, 0}, {1.5, 1}, false},
            {{3, -1}, {1.5, 1e-12}, true}, {{1, -2}, {1, -1}, false},     {{-0.5, -1}, {0.1, 1}, false},
        };
        for (size_t m = 0; m < sizeof motions / sizeof *motions; m++)
            for (int k = 0; k < 4; k++) {
                Vec2 ends[2] = {origin, vec2_along(origin, 2, axis)};
                Exit exit = {.from = ends[k % 2], .to = ends[1 - k % 2]};
                Vec2 from = vec2_add(origin, vec2_turn(motions[m].from, axis));
                Vec2 to = vec2_add(origin, vec2_turn(motions[m].to, axis));
                CHECK(plan_geometry_leads_out(&exit, k < 2 ? from : to, k < 2 ? to : from) == motions[m].out);
            }
    }
}

TEST(a_disc_leaves_by_an_exit_on_the_points_of_the_grid) {
    int lost = 0, lost_at_all = 0;
    for (int n = 0; n < LIE_COUNT * BESIDE_COUNT * 2 * FURTHER; n++) {
        Rooms fixture;
        make_rooms(&fixture);
        lay_exit(&fixture, n / 2 % LIE_COUNT, n / 2 / LIE_COUNT % BESIDE_COUNT, n / 2 / LIE_COUNT / BESIDE_COUNT,
                 n % 2);
        Fields *fields = fields_create();
        Goal goal = field_exit_goal(SIZE_MAX, 0, 0);
        SearchTrack track = {0};
        search_track_add(&track, (Pose){fixture.query.at, 0, 0, 0});
        bool found =
            disc_route_leg(&track, fields, &fixture.plan, &fixture.space, &fixture.profile, 0.25, &goal, false);
        lost += !found || !leads_out(&fixture, track.exit, track.poses[track.count - 1].at);
        search_track_clear(&track);
        fields_destroy(fields);
        Route route = route_round(&fixture.query);
        lost_at_all += route.answer != ROUTE_FOUND || !leads_out(&fixture, route.exit, route.poses[route.count - 1].at);
        route_free(&route);
        rooms_free(&fixture);
    }
    CHECK_NEAR(lost, 0, 0);
    CHECK_NEAR(lost_at_all, 0, 0);
}

TEST(a_chair_leaves_by_an_exit_on_the_points_of_the_grid) {
    for (int n = 0; n < LIE_COUNT * BESIDE_COUNT * 2; n++) {
        Rooms fixture;
        make_rooms(&fixture);
        lay_exit(&fixture, n / 2 % LIE_COUNT, n / 2 / LIE_COUNT, 0, n % 2);
        Route route = route_drive(&fixture.query);
        CHECK(route.answer == ROUTE_FOUND && leads_out(&fixture, route.exit, route.poses[route.count - 1].at));
        CHECK_NEAR(rooms_fit_margin(&fixture), ROOMS_FIT_MOST, FIT_RESOLUTION);
        route_free(&route);
        rooms_free(&fixture);
    }
}

/* Both corridors of such a corner end on a row of the grid for widths of 0.73 m, 0.98 m and so on. */
TEST(a_disc_leaves_by_an_exit_at_the_end_of_a_corner) {
    for (double width = 0.73; width < 1.6; width += 0.05)
        for (int n = 0; n < 2 * BESIDE_COUNT; n++) {
            Rooms fixture;
            make_rooms(&fixture);
            rooms_free(&fixture);
            double side = width + 0.06, far = 4 + width;
            const Vec2 points[6] = {{4 + side, far}, {4 + side, -0.06}, {-0.06, -0.06},
                                    {-0.06, side},   {3.94, side},      {3.94, far}};
            for (size_t i = 0; i < 6; i++)
                fixture.points[i] = points[i];
            fixture.walls[0] = (Wall){.id = "w1", .points = {fixture.points, 6}, .thickness = 0.12};
            fixture.plan.wall_count = 1;
            fixture.plan.door_count = 0;
            Vec2 from = {4, beside(far, n / 2)}, to = {4 + width, from.y};
            fixture.exits[0] =
                (Exit){.id = "e1", .from = n % 2 ? to : from, .to = n % 2 ? from : to, .closes = HUGE_VAL};
            fixture.profile.width = 0.63;
            fixture.query.at = vec2(1, width / 2);
            rooms_build(&fixture);
            Route route = route_round(&fixture.query);
            CHECK(route.answer == ROUTE_FOUND && leads_out(&fixture, route.exit, route.poses[route.count - 1].at));
            CHECK_TEXT(route.blockage.what, "");
            route_free(&route);
            rooms_free(&fixture);
        }
}

TEST(whoever_starts_on_an_exits_line_has_a_way_off_it) {
    for (int n = 0; n < LIE_COUNT * BESIDE_COUNT * 4; n++) {
        Rooms fixture;
        make_rooms(&fixture);
        lay_exit(&fixture, n / 4 % LIE_COUNT, BESIDE_ON, 0, n % 2);
        const Exit *exit = &fixture.exits[0];
        Vec2 middle = {4.4, 1.5}, at = vec2_nearest_on_segment(middle, exit->from, exit->to);
        at.x = beside(at.x, n / 4 / LIE_COUNT);
        if (n / 4 % LIE_COUNT == LIE_ROW || n / 4 % LIE_COUNT == LIE_LOW_ROW)
            at.y = beside(at.y, n / 4 / LIE_COUNT);
        fixture.query.at = at;
        fixture.query.heading = n / 2 % 2 ? M_PI_2 : 0;
        for (int disc = 0; disc < 2; disc++) {
            Route route = disc ? route_round(&fixture.query) : route_drive(&fixture.query);
            CHECK(route.answer == ROUTE_FOUND && route.exit == 0 && route.count > 1);
            if (route.count > 1)
                CHECK(fabs(left_of_exit(&fixture, route.poses[route.count - 1].at)) > 0.01);
            CHECK(route.length < 1.5);
            route_free(&route);
        }
        rooms_free(&fixture);
    }
}

/* A wall that shuts the way out does not lie behind an exit's line on which the grid's points are. */
TEST(an_exit_on_the_points_of_the_grid_does_not_open_a_wall) {
    for (int n = 0; n < LIE_COUNT * 2; n++) {
        Rooms fixture;
        make_rooms(&fixture);
        lay_exit(&fixture, n / 2, BESIDE_ON, 0, n % 2);
        rooms_free(&fixture);
        fixture.doors[0].state = DOOR_LOCKED;
        rooms_build(&fixture);
        for (int disc = 0; disc < 2; disc++) {
            Route route = disc ? route_round(&fixture.query) : route_drive(&fixture.query);
            CHECK(route.answer == ROUTE_CANNOT_PASS);
            CHECK_TEXT(route.blockage.what, "locked door d1");
            route_free(&route);
        }
        rooms_free(&fixture);
    }
}

TEST(an_exit_that_ends_in_the_open_is_left_by_from_its_ends) {
    for (int n = 0; n < 2 * BESIDE_COUNT * FURTHER; n++) {
        Rooms fixture;
        make_rooms(&fixture);
        double x = beside(on_grid(fixture.space.origin.x, fixture.space.cell, 4.4), n / 2 % BESIDE_COUNT);
        double end = 1 + 0.01 * (n / 2 / BESIDE_COUNT);
        fixture.exits[0].from = vec2(x, n % 2 ? 0 : end);
        fixture.exits[0].to = vec2(x, n % 2 ? end : 0);
        fixture.query.at = vec2(on_grid(fixture.space.origin.x, fixture.space.cell, 4.4), 2.4);
        for (int disc = 0; disc < 2; disc++) {
            Route route = disc ? route_round(&fixture.query) : route_drive(&fixture.query);
            CHECK(route.answer == ROUTE_FOUND && route.exit == 0);
            bool out = false;
            for (size_t i = 1; i < route.count; i++)
                out |= plan_geometry_leads_out(&fixture.exits[0], route.poses[i - 1].at, route.poses[i].at);
            CHECK(out);
            route_free(&route);
        }
        rooms_free(&fixture);
    }
}

TEST(walkers_leave_by_an_exit_on_the_points_of_the_grid) {
    for (int n = 0; n < LIE_COUNT * BESIDE_COUNT * 2; n++) {
        Rooms fixture;
        make_rooms(&fixture);
        lay_exit(&fixture, n / 2 % LIE_COUNT, n / 2 / LIE_COUNT, 0, n % 2);
        FloorField field;
        Goal goal = {.exit = SIZE_MAX};
        CHECK(floor_field_init(&field, &fixture.plan, &fixture.space, 0.23, 1.34, &goal));
        Vec2 at = fixture.query.at;
        CHECK(isfinite(floor_field_time(&field, at)));
        bool out = false;
        for (int step = 0; step < 400 && !out; step++) {
            Vec2 next = vec2_along(at, 0.02, floor_field_direction(&field, at));
            out = plan_geometry_leads_out(&fixture.exits[0], at, next);
            at = next;
        }
        CHECK(out);
        floor_field_clear(&field);
        rooms_free(&fixture);
    }
}

/* Beside the jamb of the door the points next to the line are too narrow for the walker, those before them are not. */
TEST(walkers_beside_an_exits_line_know_the_way_next_to_a_corner) {
    int lost = 0, found = 0;
    for (int n = 0; n < 40; n++) {
        Rooms fixture;
        rooms_make_two(&fixture, 0.5, 1.0, DOOR_OPEN);
        double y = on_grid(fixture.space.origin.y, fixture.space.cell, 1.1) + (n / 2 - 10) * fixture.space.cell / 10;
        fixture.exits[0].from = vec2(n % 2 ? 3 : 6, y);
        fixture.exits[0].to = vec2(n % 2 ? 6 : 3, y);
        FloorField field;
        Goal goal = {.exit = SIZE_MAX};
        CHECK(floor_field_init(&field, &fixture.plan, &fixture.space, 0.23, 1.34, &goal));
        for (int k = 0; k < 2000; k++) {
            Vec2 at = {2.8 + 0.01 * (k % 50), 0.9 + 0.01 * (int)(k / 50)};
            if (!(freespace_distance(&fixture.space, at) > 0.15))
                continue;
            found++;
            lost += isfinite(floor_field_time(&field, at)) && !(vec2_length(floor_field_direction(&field, at)) > 0.99);
        }
        floor_field_clear(&field);
        rooms_free(&fixture);
    }
    CHECK(found > 10000);
    CHECK_NEAR(lost, 0, 0);
}

/* The exit of the corridor lies across x = 18; a shift puts people or the line beside. */
static void check_run(double from_x, double line_x, bool swapped, const char *profile, int driving, double heading) {
    json_t *plan = case_corridor(2);
    json_t *exit = json_array_get(json_object_get(plan, "exits"), 0);
    json_object_set_new(exit, swapped ? "to" : "from", json_pack("[f,f]", line_x, -1.0));
    json_object_set_new(exit, swapped ? "from" : "to", json_pack("[f,f]", line_x, 1.0));
    case_add_person(plan, profile, from_x, 0, heading);
    House house;
    case_made(&house, plan, driving, (const char *[]){"run.until=60", NULL});
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed && observation.people[0].exit == 0);
    observation_free(&observation);
    house_free(&house);
}

TEST(whoever_starts_on_an_exits_line_gets_out_in_a_run) {
    for (int n = 0; n < 2 * BESIDE_COUNT; n++) {
        double at = beside(18, n / 2);
        for (int back = 0; back < 2; back++) {
            check_run(at, 18, n % 2, "manual-chair", DRIVING_DRIVER, back ? 180 : 0);
            check_run(at, 18, n % 2, "manual-chair", DRIVING_MIURA, back ? 180 : 0);
            if (n / 2 != BESIDE_MORE) /* that is outside already */
                check_run(at, 18, n % 2, "adult", -1, back ? 180 : 0);
        }
    }
}

TEST(whoever_comes_to_an_exit_on_the_points_of_the_grid_gets_out_in_a_run) {
    json_t *plan = case_corridor(2);
    House house;
    case_made(&house, plan, -1, NULL);
    double column = on_grid(house.space.origin.x, house.space.cell, 15);
    house_free(&house);
    for (int n = 0; n < 2 * BESIDE_COUNT; n++) {
        check_run(13, beside(column, n / 2), n % 2, "manual-chair", DRIVING_DRIVER, 0);
        check_run(13, beside(column, n / 2), n % 2, "manual-chair", DRIVING_MIURA, 0);
        check_run(13, beside(column, n / 2), n % 2, "adult", -1, 0);
    }
}
