#include "check.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "case.h"
#include "rooms.h"

/* A turn, then a mirror image in the x axis if wanted, then a shift. The exits of a mirror image are drawn from their
 * other end. */
typedef struct Congruence {
    double angle; /* degree */
    bool mirrored;
    Vec2 shift; /* m */
} Congruence;

static const Congruence congruences[] = {
    {10, false, {0, 0}},          {37, false, {1000.3, -77.7}}, {45, true, {0, 0}},
    {113, true, {1000.3, -77.7}}, {180, false, {0, 0}},
};
enum { CONGRUENCES = sizeof congruences / sizeof *congruences };

static Vec2 place(const Congruence *by, Vec2 at) {
    Vec2 turned = vec2_turn(at, vec2_heading(radians(by->angle)));
    return vec2_add(vec2(turned.x, by->mirrored ? -turned.y : turned.y), by->shift);
}

/* Works in degrees, as a plan does. */
static double angle(const Congruence *by, double own) {
    return by->mirrored ? -(own + by->angle) : own + by->angle;
}

static void *copied(Arena *arena, const void *array, size_t count, size_t size) {
    void *copy = arena_allocate(arena, count * size + 1);
    if (count)
        memcpy(copy, array, count * size);
    return copy;
}

static void place_points(const Congruence *by, Points *points, Arena *arena) {
    points->at = copied(arena, points->at, points->count, sizeof *points->at);
    for (size_t i = 0; i < points->count; i++)
        points->at[i] = place(by, points->at[i]);
}

/* A congruent copy of a plan, and questions put to it. */
typedef struct Copy {
    Plan plan;
    Outline outline;
    FreeSpace space;
    Fields *fields;
} Copy;

static void copy_make(Copy *copy, const Plan *plan, const Congruence *by) {
    *copy = (Copy){.plan = *plan, .fields = fields_create()};
    Plan *own = &copy->plan;
    Arena *arena = &own->arena;
    *arena = (Arena){0};
    own->walls = copied(arena, plan->walls, plan->wall_count, sizeof *plan->walls);
    own->doors = copied(arena, plan->doors, plan->door_count, sizeof *plan->doors);
    own->furniture = copied(arena, plan->furniture, plan->furniture_count, sizeof *plan->furniture);
    own->exits = copied(arena, plan->exits, plan->exit_count, sizeof *plan->exits);
    own->people = copied(arena, plan->people, plan->person_count, sizeof *plan->people);
    own->crowds = copied(arena, plan->crowds, plan->crowd_count, sizeof *plan->crowds);
    own->routes = copied(arena, plan->routes, plan->route_count, sizeof *plan->routes);
    for (size_t w = 0; w < own->wall_count; w++)
        place_points(by, &own->walls[w].points, arena);
    for (size_t d = 0; by->mirrored && d < own->door_count; d++)
        own->doors[d].swing = own->doors[d].swing == SWING_LEFT ? SWING_RIGHT : SWING_LEFT;
    for (size_t f = 0; f < own->furniture_count; f++) {
        Furniture *piece = &own->furniture[f];
        piece->centre = place(by, piece->centre);
        piece->angle = angle(by, piece->angle);
        if (by->mirrored && (piece->topples == TOPPLE_FRONT || piece->topples == TOPPLE_BACK))
            piece->topples = piece->topples == TOPPLE_FRONT ? TOPPLE_BACK : TOPPLE_FRONT;
    }
    for (size_t e = 0; e < own->exit_count; e++) {
        Vec2 ends[2] = {place(by, own->exits[e].from), place(by, own->exits[e].to)};
        own->exits[e].from = ends[by->mirrored];
        own->exits[e].to = ends[!by->mirrored];
    }
    for (size_t p = 0; p < own->person_count; p++)
        own->people[p].at = place(by, own->people[p].at);
    for (size_t c = 0; c < own->crowd_count; c++)
        place_points(by, &own->crowds[c].area, arena);
    for (size_t r = 0; r < own->route_count; r++)
        place_points(by, &own->routes[r].via, arena);
    Fault fault = {0};
    CHECK(outline_build(&copy->outline, own, &fault));
    check_say(&fault);
    freespace_build(&copy->space, &copy->outline, own->run.cell);
}

static void copy_free(Copy *copy) {
    fields_destroy(copy->fields);
    freespace_free(&copy->space);
    outline_free(&copy->outline);
    arena_clear(&copy->plan.arena);
}

static Route answer(const RouteQuery *query, bool round) {
    return round ? route_round(query) : route_drive(query);
}

/* Puts the copied question to a copy of the house. */
static Route ask_copy(Copy *copy, const RouteQuery *query, const Congruence *by, bool round) {
    Vec2 *via = memory_zeroed(query->via_count, sizeof *via);
    for (size_t i = 0; i < query->via_count; i++)
        via[i] = place(by, query->via[i]);
    RouteQuery asked = *query;
    asked.plan = &copy->plan;
    asked.space = &copy->space;
    asked.fields = copy->fields;
    asked.via = via;
    asked.at = place(by, query->at);
    asked.heading = radians(angle(by, degrees(query->heading)));
    Route route = answer(&asked, round);
    memory_free(via);
    return route;
}

static const double NEAR = 1e-5; /* m; rad */

static void check_same(const Route *one, const Route *other, const Congruence *by) {
    CHECK(other->answer == one->answer && other->exit == one->exit);
    CHECK(other->fits == one->fits);
    CHECK_NEAR(other->reversals, one->reversals, 0);
    CHECK_NEAR(other->length, one->length, NEAR);
    CHECK_NEAR(other->narrowest, one->narrowest, NEAR);
    CHECK_NEAR((double)other->count, (double)one->count, 0);
    double farthest = 0, most = 0;
    for (size_t i = 0; i < one->count && one->count == other->count; i++) {
        Vec2 heading = vec2_heading(radians(angle(by, degrees(one->poses[i].heading))));
        farthest = fmax(farthest, vec2_distance(other->poses[i].at, place(by, one->poses[i].at)));
        most = fmax(most, vec2_distance(vec2_heading(other->poses[i].heading), heading));
        CHECK(other->poses[i].direction == one->poses[i].direction);
    }
    CHECK_NEAR(farthest, 0, NEAR);
    CHECK_NEAR(most, 0, NEAR);
    CHECK_TEXT(other->blockage.what, one->blockage.what);
    if (*one->blockage.what)
        CHECK_NEAR(vec2_distance(other->blockage.at, place(by, one->blockage.at)), 0, NEAR);
    CHECK_NEAR(other->blockage.has, one->blockage.has, NEAR);
    CHECK_NEAR(other->blockage.needs, one->blockage.needs, NEAR);
}

/* Checks that all copies of a house have the copied route. */
static void check_copies(const RouteQuery *query, bool round) {
    Route one = answer(query, round);
    for (size_t i = 0; i < CONGRUENCES; i++) {
        Copy copy;
        copy_make(&copy, query->plan, &congruences[i]);
        Route other = ask_copy(&copy, query, &congruences[i], round);
        check_same(&one, &other, &congruences[i]);
        route_free(&other);
        copy_free(&copy);
    }
    route_free(&one);
}

TEST(copies_of_a_tight_corner_have_the_copied_route) {
    const double widths[] = {0.80, 0.92, 0.93, 1.2};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++)
        for (int round = 0; round < 2; round++) {
            Rooms fixture;
            rooms_make_corner(&fixture, 1.1, 0.63, widths[i], widths[i], false);
            check_copies(&fixture.query, round);
            rooms_free(&fixture);
        }
}

LONG_TEST(copies_of_two_rooms_have_the_copied_route) {
    const struct {
        double door; /* m */
        int state;
        bool brief;
    } cases[] = {
        {0.60, DOOR_OPEN, false}, {0.68, DOOR_CLOSED, true}, {0.75, DOOR_OPEN, true}, {0.90, DOOR_LOCKED, true}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Rooms fixture;
        rooms_make_two(&fixture, 0.63, cases[i].door, cases[i].state);
        fixture.doors[0].kind = DOOR_HINGED;
        fixture.furniture[0] = (Furniture){.id = "f1",
                                           .name = "shelf",
                                           .centre = {3.9, 2.2},
                                           .size = {0.4, 0.8},
                                           .angle = 20,
                                           .height = 0.5,
                                           .topples = TOPPLE_FRONT,
                                           .toppled = i % 2};
        fixture.plan.furniture_count = 1;
        rooms_free(&fixture);
        rooms_build(&fixture);
        const Vec2 via[1] = {{4.2, 0.8}};
        fixture.query.via = via;
        fixture.query.via_count = i == 2;
        fixture.query.brief = cases[i].brief;
        check_copies(&fixture.query, false);
        rooms_free(&fixture);
    }
}

/* Makes a house of one closed wall without thickness. */
static void make_ring(Rooms *fixture, const Vec2 *points, size_t count, Exit exit, Vec2 at, double heading) {
    *fixture = (Rooms){.profile = rooms_chair(1.1, 0.63)};
    for (size_t i = 0; i <= count; i++)
        fixture->points[i] = points[i % count];
    fixture->walls[0] = (Wall){.id = "w1", .points = {fixture->points, count + 1}};
    fixture->exits[0] = exit;
    fixture->plan = (Plan){.walls = fixture->walls, .wall_count = 1, .exits = fixture->exits, .exit_count = 1};
    fixture->query.at = at;
    fixture->query.heading = heading;
    rooms_build(fixture);
}

/* A door off a corridor into a room. */
LONG_TEST(copies_of_a_door_off_a_corridor_have_the_copied_route) {
    const double widths[][2] = {{1.20, 0.80}, {1.10, 0.80}, {1.02, 0.80}, {0.95, 0.70}};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        double c = widths[i][0], left = 3 - widths[i][1] / 2, right = 3 + widths[i][1] / 2;
        const Vec2 points[] = {{0, 0},          {6, 0},       {6, c},       {right, c},      {right, c + 0.12},
                               {4.5, c + 0.12}, {4.5, c + 4}, {1.5, c + 4}, {1.5, c + 0.12}, {left, c + 0.12},
                               {left, c},       {0, c}};
        Rooms fixture;
        make_ring(&fixture, points, sizeof points / sizeof *points,
                  (Exit){.id = "e1", .from = {1.6, c + 3}, .to = {4.4, c + 3}, .closes = HUGE_VAL}, vec2(1, c / 2), 0);
        check_copies(&fixture.query, false);
        rooms_free(&fixture);
    }
}

/* Two right angles, one to either side. */
LONG_TEST(copies_of_an_s_have_the_copied_route) {
    const double widths[] = {0.90, 0.95, 1.05};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        double w = widths[i];
        const Vec2 points[] = {{0, 0},           {3 + w, 0},   {3 + w, 1.2}, {6 + w, 1.2},
                               {6 + w, 1.2 + w}, {3, 1.2 + w}, {3, w},       {0, w}};
        Rooms fixture;
        make_ring(&fixture, points, sizeof points / sizeof *points,
                  (Exit){.id = "e1", .from = {5, 1.2}, .to = {5, 1.2 + w}, .closes = HUGE_VAL}, vec2(0.6, w / 2), 0);
        check_copies(&fixture.query, false);
        rooms_free(&fixture);
    }
}

/* Asks for the first riders of a shipped house. */
static void check_house(const char *name, size_t most) {
    House house;
    case_house(&house, name, -1, NULL);
    size_t asked = 0;
    for (size_t i = 0; i < house.person_count && asked < most; i++) {
        const Inhabitant *person = &house.people[i];
        if (person->profile->driving == DRIVING_WALKER || person->under)
            continue;
        asked++;
        RouteQuery query = {.plan = &house.plan,
                            .space = &house.space,
                            .profile = person->profile,
                            .at = person->at,
                            .heading = person->heading,
                            .via = person->route ? person->route->via.at : NULL,
                            .via_count = person->route ? person->route->via.count : 0,
                            .exit = person->route ? person->route->exit_index : SIZE_MAX,
                            .most_reversals = house.plan.run.reversals,
                            .brief = true};
        check_copies(&query, person->profile->driving == DRIVING_MIURA);
    }
    house_free(&house);
}

TEST(copies_of_shipped_houses_have_the_copied_routes) {
    const char *const names[] = {"bedroom-after-earthquake", "closed-door",      "corner-0.78-0.78", "corner-0.80-1.20",
                                 "corner-1.00-1.00",         "corner-1.50-1.50", "ube-techno-house"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        check_house(names[i], 2);
}

LONG_TEST(copies_of_tight_or_large_houses_have_the_copied_routes) {
    const char *const names[] = {"corner-0.85-0.85",  "corner-0.90-0.90",   "corner-1.20-0.80",
                                 "flat-0.910-module", "flat-0.910-widened", "shopping-centre"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        check_house(names[i], 3);
}

/* Pushed against a wall in the middle of a run. */
TEST(copies_of_a_house_have_the_copied_route_in_the_middle_of_a_run) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.80, DOOR_OPEN);
    fixture.query.at = vec2(1.2345678912, 0.06 + 0.63 / 2 - 0.004);
    fixture.query.heading = radians(0.3);
    fixture.query.pressed = 0.02;
    check_copies(&fixture.query, false);
    fixture.query.at = vec2(2.94 + 0.03 - (1.1 - 0.28), 1.5 - 0.4 + 0.315 - 0.004); /* held by the jamb */
    fixture.query.heading = 0;
    check_copies(&fixture.query, false);
    rooms_free(&fixture);
}

TEST(a_frame_is_built_once_for_a_plan_and_a_sense) {
    Rooms fixture, other;
    rooms_make_two(&fixture, 0.63, 0.80, DOOR_OPEN);
    rooms_make_two(&other, 0.63, 0.70, DOOR_OPEN);
    Fields *fields = fields_create();
    const RouteFrame *frame = fields_frame(fields, &fixture.plan, 0);
    CHECK(frame && frame == fields_frame(fields, &fixture.plan, 0));
    CHECK(fields_frame(fields, &fixture.plan, 5) != frame);
    CHECK(fields_frame(fields, &other.plan, 0) != frame);
    CHECK_NEAR(fields_frame(fields, &other.plan, 0)->plan.doors[0].width, 0.70, 0);
    fields_destroy(fields);
    rooms_free(&fixture);
    rooms_free(&other);
}
