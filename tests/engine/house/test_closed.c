/* Tests plans where the line of an exit that has closed lies across the way to another exit. */

#include "house/closed.h"

#include <string.h>

#include "case.h"
#include "check.h"
#include "house/journey.h"
#include "house/observation.h"

/* Returns a ring of corridors, 1.5 m wide, about a block, with a gate across the southern one that closes at 2 s. The
 * exit is in the east, its door near the south. `flip` mirrors the house about a horizontal line. */
static json_t *ring(bool flip) {
    json_t *plan = json_pack(
        "{s:s, s:i, s:s, s:[{s:s, s:[[f,f],[f,f],[f,f],[f,f],[f,f]], s:f}, {s:s, s:[[f,f],[f,f],[f,f],[f,f],[f,f]], "
        "s:f}], s:[{s:s, s:s, s:i, s:f, s:f}], s:[{s:s, s:[f,f], s:[f,f], s:f}, {s:s, s:[f,f], s:[f,f]}], s:[], "
        "s:{s:f}}",
        "format", "clearance-house", "version", 1, "name", "ring", "walls", "id", "outer", "points", 0.0, 0.0, 8.0, 0.0,
        8.0, 5.0, 0.0, 5.0, 0.0, 0.0, "thickness", 0.1, "id", "inner", "points", 1.6, 1.6, 6.4, 1.6, 6.4, 3.4, 1.6, 3.4,
        1.6, 1.6, "thickness", 0.1, "doors", "id", "d1", "wall", "outer", "segment", 1, "at", flip ? 4.2 : 0.8, "width",
        0.9, "exits", "id", "gate", "from", 4.0, flip ? 3.45 : 0.05, "to", 4.0, flip ? 4.95 : 1.55, "closes", 2.0, "id",
        "e1", "from", 8.05, flip ? 3.75 : 0.35, "to", 8.05, flip ? 4.65 : 1.25, "people", "run", "until", 60.0);
    CHECK(plan);
    return plan;
}

static void delay_person(json_t *plan, size_t index, double delay) {
    json_object_set_new(json_array_get(json_object_get(plan, "people"), index), "delay", json_real(delay));
}

static size_t exit_called(const House *house, const char *id) {
    for (size_t e = 0; e < house->plan.exit_count; e++)
        if (strcmp(house->plan.exits[e].id, id) == 0)
            return e;
    return SIZE_MAX;
}

/* Everybody is out by the exit, round the block, in less than `most` s. */
static void check_round(json_t *plan, double most) {
    House house = {.driver = 0};
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 2);
    for (size_t i = 0; i < observation.person_count; i++) {
        CHECK(observation.people[i].completed);
        CHECK(observation.people[i].exit == exit_called(&house, "e1"));
        CHECK(observation.people[i].time < most);
        CHECK(observation.people[i].path_length > 9);
    }
    observation_free(&observation);
    house_free(&house);
}

TEST(who_is_held_by_a_closed_line_goes_round_it) {
    for (int flip = 0; flip < 2; flip++) {
        double y = flip ? 4.2 : 0.8;
        json_t *plan = ring(flip); /* the gate closes while the chair comes, and before the others start */
        case_add_person(plan, "manual-chair", 1, y, 0);
        case_add_person(plan, "adult", 0.8, 2.5, 0);
        delay_person(plan, 1, 3);
        check_round(plan, 40);
        plan = ring(flip);
        case_add_person(plan, "manual-chair", 1, y, 0);
        delay_person(plan, 0, 2.5);
        check_round(plan, 40);
        plan = ring(flip); /* several, who weigh queues */
        for (int i = 0; i < 5; i++)
            case_add_person(plan, "adult", 0.8, 1.8 + 0.5 * i, 0);
        for (size_t i = 0; i < 5; i++)
            delay_person(plan, i, i % 2 ? 0 : 2.5);
        check_round(plan, 40);
    }
}

TEST(the_line_is_named_where_there_is_no_way_round) {
    json_t *plan = case_corridor(1.5);
    json_t *gate =
        json_pack("{s:s, s:[f,f], s:[f,f], s:f}", "id", "gate", "from", 9.0, -0.75, "to", 9.0, 0.75, "closes", 1.0);
    json_array_append_new(json_object_get(plan, "exits"), gate);
    json_array_append_new(json_object_get(plan, "walls"), json_pack("{s:s, s:[[f,f],[f,f]], s:f}", "id", "west",
                                                                    "points", 0.0, -0.85, 0.0, 0.85, "thickness", 0.1));
    case_add_person(plan, "manual-chair", 2, 0, 0);
    case_add_person(plan, "adult", 4, 0, 0);
    delay_person(plan, 0, 1.5);
    delay_person(plan, 1, 1.5);
    House house = {.driver = 0};
    case_made(&house, plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    for (size_t i = 0; i < house.person_count; i++) {
        CHECK(journeys.of[i].route.answer == ROUTE_CANNOT_PASS);
        CHECK(strcmp(journeys.of[i].route.blockage.what, "closed exit gate") == 0);
        CHECK(!(journeys.of[i].route.blockage.needs > 0));
    }
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(a_chair_under_which_an_exit_closes_goes_back_from_its_line) {
    json_t *plan = ring(false);
    case_add_person(plan, "manual-chair", 3.3, 0.8, 0); /* its front is behind the line, its axle before it */
    delay_person(plan, 0, 2.5);
    check_round(plan, 60);
}

TEST(a_closed_exit_beside_the_way_changes_nothing) {
    double times[2];
    for (int closed = 0; closed < 2; closed++) {
        json_t *plan = case_corridor(1.2);
        json_t *gate = json_pack("{s:s, s:[f,f], s:[f,f], s:f}", "id", "gate", "from", 6.0, 0.59, "to", 7.0, 0.59,
                                 "closes", closed ? 1.0 : 500.0);
        json_array_append_new(json_object_get(plan, "exits"), gate);
        json_object_set_new(plan, "routes",
                            json_pack("[{s:s, s:[s], s:[], s:s}]", "id", "A", "people", "p1", "via", "exit", "e1"));
        case_add_person(plan, "manual-chair", 2, 0, 0);
        delay_person(plan, 0, 2);
        House house = {.driver = 0};
        case_made(&house, plan, -1, NULL);
        Observation observation = case_run(&house, 1);
        times[closed] = observation.people[0].time;
        CHECK(observation.people[0].completed);
        observation_free(&observation);
        house_free(&house);
    }
    CHECK_NEAR(times[0], times[1], 0);
}
