#include "check.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "base/random.h"
#include "case.h"
#include "rooms.h"
#include "route/fields.h"

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
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_CLOSED);
    fixture.exits[1] = (Exit){.id = "e2", .from = {0.8, 0}, .to = {0.8, 3}, .closes = 10};
    fixture.plan.exit_count = 2;
    Profile small = rooms_chair(1.0, 0.5);
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
    rooms_free(&fixture);
}

TEST(one_field_serves_all_who_wish_for_the_same) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.9, DOOR_OPEN);
    fixture.exits[0].closes = 10;
    Fields *fields = fields_create();
    FieldKey key = {&fixture.plan, &fixture.space, &fixture.profile, 0.3, .goal = field_exit_goal(SIZE_MAX, 0, 0)};
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
    rooms_free(&fixture);
}

/* Lowers the times of all points that are reached from a point by any of the moves. Returns true if there are some. */
static bool lower_all_from(const Ground *ground, float *time, int x, int y) {
    const FreeSpace *space = ground->space;
    int nx = space->nx, ny = space->ny;
    size_t from = (size_t)(y * nx + x);
    bool lowered = false;
    for (int dy = -2; dy <= 2; dy++)
        for (int dx = -2; dx <= 2; dx++) {
            int i = x + dx, j = y + dy, square = dx * dx + dy * dy;
            size_t to = (size_t)(j * nx + i), half = (size_t)((y + dy / 2) * nx + x + dx / 2);
            size_t rest = (size_t)((y + dy - dy / 2) * nx + x + dx - dx / 2);
            if ((square != 1 && square != 2 && square != 5) || i < 0 || j < 0 || i >= nx || j >= ny ||
                !(ground->slowness[to] > 0) ||
                (square == 5 && !(ground->slowness[half] > 0 && ground->slowness[rest] > 0)))
                continue;
            float length = (square == 1 ? 1 : square == 2 ? 1.41421f : 2.23607f) * (0.5f * (float)space->cell);
            float reached = time[from] + length * (ground->slowness[from] + ground->slowness[to]);
            if (!(reached < time[to]))
                continue;
            Vec2 at = vec2(space->origin.x + x * space->cell, space->origin.y + y * space->cell);
            reached += (float)field_delay(ground, at, vec2_add(at, vec2(dx * space->cell, dy * space->cell)));
            lowered |= reached < time[to];
            time[to] = fminf(time[to], reached);
        }
    return lowered;
}

/* Asks for the times of points here and there, while others are not known yet, and keeps them. */
static void ask_here_and_there(const Field *field, float *asked) {
    const FreeSpace *space = field->ground->space;
    size_t points = (size_t)space->nx * (size_t)space->ny, stride = 7919; /* a prime number */
    for (size_t k = 0; k < points; k += 50) {
        size_t p = k * stride % points;
        int x = (int)p % space->nx, y = (int)p / space->nx;
        field_know(field, x, y, x + 1, y + 1);
        asked[p] = field->time[p];
    }
}

/* Checks that the times of a field are those of all moves from all points, again and again until none falls. */
static void check_times(const Plan *plan, const FreeSpace *space, const Profile *profile, double radius) {
    int nx = space->nx, ny = space->ny;
    size_t points = (size_t)nx * (size_t)ny, reached = 0, wrong = 0;
    Ground ground;
    Field field;
    Goal goal = field_exit_goal(SIZE_MAX, 0, 0);
    field_ground_init(&ground, plan, space, profile, radius);
    field_init(&field, &ground, &goal);
    float *time = memory_zeroed(points, sizeof *time), *asked = memory_zeroed(points, sizeof *asked);
    for (size_t p = 0; p < points; p++)
        asked[p] = -1;
    ask_here_and_there(&field, asked);
    field_know(&field, 0, 0, nx, ny);
    for (size_t p = 0; p < points; p++)
        time[p] = field.time[p] > 0 ? HUGE_VALF : 0;
    for (bool lowered = true, backwards = false; lowered; backwards = !backwards) {
        lowered = false;
        for (size_t k = 0; k < points; k++) {
            size_t p = backwards ? points - 1 - k : k;
            if (isfinite(time[p]))
                lowered |= lower_all_from(&ground, time, (int)p % nx, (int)p / nx);
        }
    }
    for (size_t p = 0; p < points; p++) {
        reached += isfinite(time[p]);
        wrong += memcmp(&time[p], &field.time[p], sizeof *time) != 0;
        wrong += asked[p] >= 0 && memcmp(&asked[p], &field.time[p], sizeof *asked) != 0;
    }
    CHECK(reached > 1000);
    CHECK(wrong == 0);
    memory_free(time);
    memory_free(asked);
    field_clear(&field);
    field_ground_clear(&ground);
}

TEST(times_are_those_of_all_moves_to_the_last_bit) {
    static const char *const names[] = {"ube-techno-house", "flat-0.910-widened", "closed-door"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        House house;
        case_house(&house, names[n], DRIVING_DRIVER, (const char *const[]){NULL});
        check_times(&house.plan, &house.space, house.people[0].profile, 0.25);
        house_free(&house);
    }
    for (int turned = 0; turned < 6; turned++) {
        Rooms fixture;
        rooms_make_two(&fixture, 0.6, 0.9, turned % 2 ? DOOR_OPEN : DOOR_CLOSED);
        rooms_turn(&fixture, 0.37 * turned, vec2(0.3, -0.2));
        fixture.profile.steering_time = 0.1 * turned;
        check_times(&fixture.plan, &fixture.space, &fixture.profile, 0.3);
        rooms_free(&fixture);
    }
}
