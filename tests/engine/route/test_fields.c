#include "check.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/parallel.h"
#include "base/random.h"
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
    rooms_free(&fixture);
}
