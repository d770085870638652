#include "check.h"

#include <stdint.h>
#include <string.h>

#include "base/random.h"
#include "case.h"
#include "route/floor_field.h"

#define RADIUS 0.23 /* m, of a walker */
#define SPEED 1.34  /* m/s */

/* A plan of a few walls and the obstacles on the path. */
typedef struct Fixture {
    Vec2 points[16];
    Wall walls[4];
    Door doors[1];
    Exit exits[2];
    Plan plan;
    Outline outline;
    FreeSpace space;
    Goal goal;
    FloorField field;
} Fixture;

/* Called once the plan's parts are in place. */
static bool fixture_build(Fixture *fixture, double cell) {
    Fault fault = {0};
    CHECK(outline_build(&fixture->outline, &fixture->plan, &fault));
    fault_clear(&fault);
    freespace_build(&fixture->space, &fixture->outline, cell);
    memset(&fixture->field, 0xa5, sizeof fixture->field);
    return floor_field_init(&fixture->field, &fixture->plan, &fixture->space, RADIUS, SPEED, &fixture->goal);
}

static void fixture_free(Fixture *fixture) {
    floor_field_clear(&fixture->field);
    freespace_free(&fixture->space);
    outline_free(&fixture->outline);
}

static Fixture fixture_of(const Vec2 *points, size_t count) {
    Fixture fixture = {.goal = {.exit = SIZE_MAX}};
    memcpy(fixture.points, points, count * sizeof *points);
    fixture.plan = (Plan){.name = "fixture", .wall_count = 1, .exit_count = 1};
    return fixture;
}

static void fixture_point(Fixture *fixture) {
    fixture->plan.walls = fixture->walls;
    fixture->plan.doors = fixture->doors;
    fixture->plan.exits = fixture->exits;
}

/* Returns a closed corridor, 20 m by 2 m, with the exit's line across x = 18, turned about the origin. */
static void corridor_make(Fixture *fixture, double angle) {
    const Vec2 points[5] = {{0, 0}, {20, 0}, {20, 2}, {0, 2}, {0, 0}};
    Vec2 axis = vec2_heading(angle);
    *fixture = fixture_of(points, 5);
    for (int i = 0; i < 5; i++)
        fixture->points[i] = vec2_turn(points[i], axis);
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 5}, .thickness = 0.1};
    fixture->exits[0] = (Exit){
        .id = "e1", .from = vec2_turn(vec2(18, 0), axis), .to = vec2_turn(vec2(18, 2), axis), .closes = HUGE_VAL};
    fixture_point(fixture);
}

/* Two closed rooms, each 5 m by 4 m, with a gap between them at height 2 m and an exit's line across x = 9, turned
 * and shifted so that the gap has no relation to the grid. */
static void rooms_make(Fixture *fixture, double gap, double angle, double thickness) {
    const Vec2 points[9] = {{0, 0}, {10, 0},          {10, 4},          {0, 4}, {0, 0},
                            {5, 0}, {5, 2 - gap / 2}, {5, 2 + gap / 2}, {5, 4}};
    Vec2 axis = vec2_heading(angle);
    *fixture = fixture_of(points, 9);
    for (int i = 0; i < 9; i++)
        fixture->points[i] = vec2_turn(points[i], axis);
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, 5}, .thickness = 0.12};
    fixture->walls[1] = (Wall){.id = "w2", .points = {fixture->points + 5, 2}, .thickness = thickness};
    fixture->walls[2] = (Wall){.id = "w3", .points = {fixture->points + 7, 2}, .thickness = thickness};
    fixture->plan.wall_count = gap > 0 ? 3 : 2;
    if (!(gap > 0))
        fixture->points[6] = fixture->points[8];
    fixture->exits[0] =
        (Exit){.id = "e1", .from = vec2_turn(vec2(9, 0), axis), .to = vec2_turn(vec2(9, 4), axis), .closes = HUGE_VAL};
    fixture_point(fixture);
}

static bool crosses(const Exit *exit, Vec2 from, Vec2 to) {
    Vec2 along = vec2_sub(exit->to, exit->from);
    double before = vec2_cross(along, vec2_sub(from, exit->from)), after = vec2_cross(along, vec2_sub(to, exit->from));
    double where = vec2_dot(along, vec2_sub(to, exit->from)) / vec2_dot(along, along);
    return (before < 0) != (after < 0) && where >= 0 && where <= 1;
}

typedef struct Walk {
    bool out;       /* across an exit */
    double nearest; /* m, to an obstacle */
    double length;  /* m */
    Vec2 end;       /* m */
} Walk;

/* Follows the directions in small steps to `beyond` m after an exit or the goal. */
static Walk follow(const FloorField *field, const Plan *plan, Vec2 at, double beyond) {
    const double step = 0.02;
    Walk walk = {.nearest = HUGE_VAL, .end = at};
    for (int n = 0; n < 20000; n++) {
        Vec2 direction = floor_field_direction(field, walk.end);
        if (!(vec2_length(direction) > 0))
            return walk;
        Vec2 next = vec2_along(walk.end, step, direction);
        for (size_t e = 0; e < plan->exit_count && !walk.out; e++)
            walk.out = crosses(&plan->exits[e], walk.end, next);
        walk.end = next;
        walk.length += step;
        walk.nearest = fmin(walk.nearest, freespace_exact(field->space, next, 1, NULL));
        if (walk.out && (beyond -= step) < 0)
            return walk;
        if (field->goal.radius > 0 && vec2_distance(next, field->goal.at) < field->goal.radius)
            return walk;
    }
    return walk;
}

TEST(a_straight_corridor_takes_its_length_over_the_speed) {
    const double angles[] = {0, 0.3, M_PI / 4, 1.2, M_PI / 2};
    for (size_t a = 0; a < sizeof angles / sizeof *angles; a++) {
        Fixture fixture;
        corridor_make(&fixture, angles[a]);
        Vec2 axis = vec2_heading(angles[a]);
        CHECK(fixture_build(&fixture, 0.05));
        for (double x = 1; x < 18; x += 4) {
            double expected = (18 - x) / SPEED;
            CHECK_NEAR(floor_field_time(&fixture.field, vec2_turn(vec2(x, 1), axis)), expected,
                       0.005 * expected + 0.005);
            Vec2 direction = vec2_unturn(floor_field_direction(&fixture.field, vec2_turn(vec2(x, 1), axis)), axis);
            CHECK_NEAR(direction.x, 1, 0.01);
        }
        fixture_free(&fixture);
    }
}

/* Returns the shortest path between two places around a circle about `middle`. */
static double string_length(Vec2 from, Vec2 middle, Vec2 to, double radius) {
    Vec2 one = vec2_sub(from, middle), other = vec2_sub(to, middle);
    double a = vec2_length(one), b = vec2_length(other), angle = 2 * M_PI - acos(vec2_dot(one, other) / (a * b));
    double arc = angle - acos(radius / a) - acos(radius / b);
    return sqrt(a * a - radius * radius) + sqrt(b * b - radius * radius) + radius * fmax(arc, 0);
}

TEST(the_time_round_a_corner_is_that_of_a_taut_string_and_converges) {
    const Vec2 points[7] = {{0, 9}, {0, 0}, {9, 0}, {9, 3}, {3, 3}, {3, 9}, {0, 9}};
    const double cells[] = {0.1, 0.05, 0.025, 0.0125};
    double times[4], least = 0;
    Vec2 from = {1.5, 7.5}, to = {7.5, 1.5};
    for (int c = 0; c < 4; c++) {
        Fixture fixture = fixture_of(points, 7);
        fixture_point(&fixture);
        fixture.walls[0] = (Wall){.id = "w1", .points = {fixture.points, 7}, .thickness = 0};
        fixture.goal = (Goal){.at = to, .radius = 0.5, .exit = SIZE_MAX};
        CHECK(fixture_build(&fixture, cells[c]));
        times[c] = floor_field_time(&fixture.field, from);
        least = (string_length(from, vec2(3, 3), to, RADIUS) - 0.5) / SPEED;
        CHECK_NEAR(times[c], least, (cells[c] > 0.06 ? 0.025 : 0.02) * least);
        fixture_free(&fixture);
    }
    CHECK(times[3] > least); /* the path keeps off the corner */
    CHECK(fabs(times[1] - times[3]) < fmax(fabs(times[0] - times[3]), 0.001));
    CHECK_NEAR(times[2], times[3], 0.002 * least);
    CHECK_NEAR(times[1], times[3], 0.005 * least);
}

TEST(ways_keep_off_a_corner_where_there_is_room) {
    const Vec2 points[7] = {{0, 9}, {0, 0}, {9, 0}, {9, 3}, {3, 3}, {3, 9}, {0, 9}};
    Fixture fixture = fixture_of(points, 7);
    fixture_point(&fixture);
    fixture.walls[0] = (Wall){.id = "w1", .points = {fixture.points, 7}, .thickness = 0};
    fixture.exits[0] = (Exit){.id = "e1", .from = {8, 0}, .to = {8, 3}, .closes = HUGE_VAL};
    CHECK(fixture_build(&fixture, 0.05));
    Walk walk = follow(&fixture.field, &fixture.plan, vec2(2, 8), 0.1);
    CHECK(walk.out);
    CHECK_NEAR(walk.nearest, RADIUS + 0.1, 0.06);
    fixture_free(&fixture);
}

TEST(a_gap_narrower_than_the_disc_is_not_passed_and_any_wider_one_is) {
    const double cells[] = {0.02, 0.05, 0.08, 0.11}, thicknesses[] = {0, 0.1, 0.3},
                 wider[] = {0.001, 0.006, 0.02, 0.05};
    int wrong_narrow = 0, wrong_wide = 0, into = 0;
    Random random = random_seed(3, 1);
    for (size_t c = 0; c < sizeof cells / sizeof *cells; c++)
        for (int n = 0; n < 24; n++) {
            double cell = cells[c], angle = 2 * M_PI * random_uniform(&random), thickness = thicknesses[n % 3];
            Vec2 start = vec2_turn(vec2(1, 2), vec2_heading(angle));
            Fixture fixture;
            rooms_make(&fixture, 2 * RADIUS - 0.01 - cell * cell / (4 * RADIUS), angle, thickness);
            CHECK(fixture_build(&fixture, cell)); /* from the other room */
            wrong_narrow += isfinite(floor_field_time(&fixture.field, start));
            CHECK(!(vec2_length(floor_field_direction(&fixture.field, start)) > 0));
            fixture_free(&fixture);
            rooms_make(&fixture, 2 * RADIUS + wider[n % 4], angle, thickness);
            CHECK(fixture_build(&fixture, cell));
            wrong_wide += !isfinite(floor_field_time(&fixture.field, start));
            Walk walk = follow(&fixture.field, &fixture.plan, start, 0);
            wrong_wide += !walk.out;
            into += walk.nearest < RADIUS - cell;
            fixture_free(&fixture);
        }
    CHECK_NEAR(wrong_narrow, 0, 0);
    CHECK_NEAR(wrong_wide, 0, 0);
    CHECK_NEAR(into, 0, 0);
}

TEST(an_unreachable_place_has_neither_time_nor_direction) {
    Fixture fixture;
    rooms_make(&fixture, 0, 0.2, 0);
    CHECK(fixture_build(&fixture, 0.05));
    Random random = random_seed(3, 2);
    int wrong = 0;
    for (int n = 0; n < 2000; n++) {
        Vec2 at = vec2_turn(vec2(0.07 + 4.9 * random_uniform(&random), 0.07 + 3.86 * random_uniform(&random)),
                            vec2_heading(0.2));
        wrong += isfinite(floor_field_time(&fixture.field, at)) ||
                 vec2_length(floor_field_direction(&fixture.field, at)) > 0;
    }
    CHECK_NEAR(wrong, 0, 0);
    Vec2 away = {1000, 1000};
    CHECK(!isfinite(floor_field_time(&fixture.field, away)) &&
          !(vec2_length(floor_field_direction(&fixture.field, away)) > 0));
    fixture_free(&fixture);
    rooms_make(&fixture, 1, 0, 0.1);
    fixture.exits[0].closes = 10;
    fixture.goal.time = 10;
    CHECK(!fixture_build(&fixture, 0.05));
    CHECK(!isfinite(floor_field_time(&fixture.field, vec2(7, 2))));
    CHECK(!(vec2_length(floor_field_direction(&fixture.field, vec2(7, 2))) > 0));
    fixture_free(&fixture);
}

TEST(a_closed_door_costs_its_opening_time) {
    const double angles[] = {0, 0.35, M_PI / 4, 1.3};
    for (size_t a = 0; a < sizeof angles / sizeof *angles; a++) {
        double times[2];
        for (int closed = 0; closed < 2; closed++) {
            Fixture fixture;
            rooms_make(&fixture, 0, angles[a], 0.12);
            fixture.plan.door_count = 1;
            fixture.doors[0] = (Door){.id = "d1",
                                      .wall = "w2",
                                      .at = 2,
                                      .width = 0.9,
                                      .kind = DOOR_SLIDING,
                                      .state = closed ? DOOR_CLOSED : DOOR_OPEN,
                                      .opening_time = 3,
                                      .leaf = 0.04,
                                      .wall_index = 1};
            CHECK(fixture_build(&fixture, 0.05));
            times[closed] = floor_field_time(&fixture.field, vec2_turn(vec2(1, 2.5), vec2_heading(angles[a])));
            fixture_free(&fixture);
        }
        CHECK_NEAR(times[1] - times[0], 3, 0.1);
    }
}

TEST(an_exits_line_is_crossed_from_either_side) {
    for (double angle = 0; angle < 6; angle += 0.7) {
        Fixture fixture;
        corridor_make(&fixture, angle);
        Vec2 axis = vec2_heading(angle);
        fixture.exits[0].from = vec2_turn(vec2(10, 0), axis);
        fixture.exits[0].to = vec2_turn(vec2(10.3, 2), axis);
        CHECK(fixture_build(&fixture, 0.05));
        CHECK(fixture.field.exits[0].outward == 0);
        for (double y = 0.3; y < 1.8; y += 0.2)
            for (int side = -1; side <= 1; side += 2) {
                Vec2 start = vec2_turn(vec2(10 + 3 * side, y), axis);
                CHECK(follow(&fixture.field, &fixture.plan, start, 0).out);
                /* The line is crossed from any distance. */
                Vec2 close = vec2_turn(vec2(10 + 0.15 * y + 1e-3 * side, y), axis);
                Vec2 there = vec2_unturn(floor_field_direction(&fixture.field, close), axis);
                CHECK(there.x * side < -0.9);
            }
        fixture_free(&fixture);
    }
}

TEST(an_exit_to_the_outside_leads_on_beyond_its_line) {
    const Vec2 points[6] = {{6, 1.5}, {6, 0}, {0, 0}, {0, 4}, {6, 4}, {6, 2.5}};
    for (double angle = 0; angle < 6; angle += 0.7) {
        Fixture fixture = fixture_of(points, 6);
        Vec2 axis = vec2_heading(angle);
        for (int i = 0; i < 6; i++)
            fixture.points[i] = vec2_turn(points[i], axis);
        fixture_point(&fixture);
        fixture.walls[0] = (Wall){.id = "w1", .points = {fixture.points, 6}, .thickness = 0.2};
        fixture.exits[0] = (Exit){
            .id = "e1", .from = vec2_turn(vec2(6, 1.5), axis), .to = vec2_turn(vec2(6, 2.5), axis), .closes = HUGE_VAL};
        CHECK(fixture_build(&fixture, 0.05));
        CHECK(fixture.field.exits[0].outward != 0);
        for (double y = 0.4; y < 3.8; y += 0.2) {
            Walk walk = follow(&fixture.field, &fixture.plan, vec2_turn(vec2(2, y), axis), 0.42);
            CHECK(walk.out && walk.nearest > RADIUS - 0.05);
            CHECK_NEAR(vec2_unturn(walk.end, axis).x, 6.43, 0.04);
            CHECK_NEAR(floor_field_time(&fixture.field, walk.end), 0, 0);
        }
        fixture_free(&fixture);
    }
}

TEST(somebody_pressed_against_a_wall_is_led_away_from_it_or_along_it) {
    Fixture fixture;
    rooms_make(&fixture, 0.9, 0.4, 0.08);
    CHECK(fixture_build(&fixture, 0.05));
    Random random = random_seed(3, 3);
    int lost = 0, into = 0, endless = 0, tried = 0;
    while (tried < 2000) {
        Vec2 at = vec2_turn(vec2(10 * random_uniform(&random), 4 * random_uniform(&random)), vec2_heading(0.4));
        int index;
        double distance = freespace_exact(&fixture.space, at, RADIUS, &index);
        if (index < 0 || freespace_distance(&fixture.space, at) < 0.001)
            continue;
        tried++;
        const Face *face = &fixture.outline.faces[index];
        Vec2 direction = floor_field_direction(&fixture.field, at);
        Vec2 away = vec2_unit(vec2_sub(at, vec2_nearest_on_segment(at, face->a, face->b)));
        lost += !(vec2_length(direction) > 0.999);
        into += distance < RADIUS - 0.05 && vec2_dot(direction, away) < -0.01;
        endless += !isfinite(floor_field_time(&fixture.field, at));
    }
    CHECK_NEAR(lost, 0, 0);
    CHECK_NEAR(into, 0, 0);
    CHECK_NEAR(endless, 0, 0);
    fixture_free(&fixture);
}

TEST(directions_lead_out_of_every_shipped_house_past_everything) {
    static const char *const names[] = {"ube-techno-house", "flat-0.910-module", "bedroom-after-earthquake",
                                        "closed-door",      "corner-0.85-0.85",  "straight-corridor"};
    for (size_t h = 0; h < sizeof names / sizeof *names; h++) {
        House house;
        case_house(&house, names[h], -1, NULL);
        FloorField field;
        Goal goal = {.exit = SIZE_MAX};
        CHECK(floor_field_init(&field, &house.plan, &house.space, RADIUS, SPEED, &goal));
        Random random = random_seed(3, 10 + h);
        Box box = house.outline.box;
        int tried = 0, inside = 0, stuck = 0, grazed = 0, slow = 0;
        for (int n = 0; n < 400; n++) {
            Vec2 at = {box.low.x + (box.high.x - box.low.x) * random_uniform(&random),
                       box.low.y + (box.high.y - box.low.y) * random_uniform(&random)};
            double time = floor_field_time(&field, at);
            if (freespace_distance(&house.space, at) <= RADIUS || !isfinite(time))
                continue;
            tried++;
            Walk walk = follow(&field, &house.plan, at, 0);
            /* A person who starts outside is led to the others' exit. */
            stuck += !walk.out && floor_field_time(&field, walk.end) > (FLOOR_FIELD_BEYOND + 0.1) / SPEED;
            inside += walk.out;
            grazed += walk.nearest < RADIUS - field.cell;
            slow += walk.out && walk.length / SPEED > time + 0.2; /* discomfort and doors can only increase it */
        }
        CHECK(tried > 50 && inside > 20);
        CHECK_NEAR(stuck, 0, 0);
        CHECK_NEAR(grazed, 0, 0);
        CHECK_NEAR(slow, 0, 0);
        floor_field_clear(&field);
        house_free(&house);
    }
}

TEST(a_thinned_grid_finds_through_a_door) {
    Random random = random_seed(3, 4);
    for (int n = 0; n < 3; n++) {
        double angle = 2 * M_PI * random_uniform(&random);
        Fixture fixture;
        rooms_make(&fixture, 0.8, angle, 0.1);
        /* Distant corners make the grid large. */
        fixture.points[9] = vec2(-60, -60);
        fixture.points[10] = vec2(-60, -59);
        fixture.walls[3] = (Wall){.id = "w4", .points = {fixture.points + 9, 2}, .thickness = 0.1};
        fixture.plan.wall_count = 4;
        CHECK(fixture_build(&fixture, 0.05));
        CHECK_NEAR(fixture.field.cell, 0.1, 1e-9);
        CHECK((double)fixture.field.nx * fixture.field.ny <= FLOOR_FIELD_MOST_POINTS);
        Walk walk = follow(&fixture.field, &fixture.plan, vec2_turn(vec2(1, 1), vec2_heading(angle)), 0);
        CHECK(walk.out && walk.nearest > RADIUS - 0.1);
        fixture_free(&fixture);
    }
}

TEST(the_same_march_has_the_same_bits) {
    Fixture one, other;
    rooms_make(&one, 0.9, 0.4, 0.1);
    rooms_make(&other, 0.9, 0.4, 0.1);
    CHECK(fixture_build(&one, 0.05) && fixture_build(&other, 0.05));
    size_t points = (size_t)one.field.nx * (size_t)one.field.ny;
    CHECK(memcmp(one.field.time, other.field.time, points * sizeof *one.field.time) == 0);
    CHECK(memcmp(one.field.directions, other.field.directions, points * sizeof *one.field.directions) == 0);
    fixture_free(&one);
    fixture_free(&other);
}
