/* Tests plans where the line of an exit that has closed lies across the way to another exit. */

#include "house/closed.h"

#include <stdio.h>
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
        CHECK(observation.people[i].contacts == 0 || house.people[i].profile->driving == DRIVING_WALKER);
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

/* Wherever the line lies under the body, up to the axle. */
TEST(a_chair_under_which_an_exit_closes_goes_back_from_its_line) {
    static const double axles[] = {3.3, 3.7, 3.8, 3.95};
    for (size_t a = 0; a < sizeof axles / sizeof *axles; a++)
        for (int flip = 0; flip < 2; flip++) {
            json_t *plan = ring(flip);
            case_add_person(plan, "manual-chair", axles[a], flip ? 4.2 : 0.8, 0);
            delay_person(plan, 0, 2.5);
            check_round(plan, 60);
        }
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

/* Three corridors about two blocks, 12 m by 8 m, with gates across the lower and the middle one at x = `at`, which
 * close at 2 s and 4.5 s, and an exit behind the lower one; `more`: people, and routes if any. */
static void check_ladder(double at, const char *more, bool touches) {
    char text[2000];
    snprintf(text, sizeof text,
             "{\"format\": \"clearance-house\", \"version\": 1, \"name\": \"ladder\", \"walls\": ["
             "{\"id\": \"outer\", \"points\": [[0, 0], [12, 0], [12, 8], [0, 8], [0, 0]], \"thickness\": 0.1}, "
             "{\"id\": \"b1\", \"points\": [[2, 2], [8, 2], [8, 3], [2, 3], [2, 2]], \"thickness\": 0.1}, "
             "{\"id\": \"b2\", \"points\": [[2, 5], [8, 5], [8, 6], [2, 6], [2, 5]], \"thickness\": 0.1}], "
             "\"doors\": [{\"id\": \"d1\", \"wall\": \"outer\", \"segment\": 1, \"at\": 1.0, \"width\": 1.0}], "
             "\"exits\": [{\"id\": \"e1\", \"from\": [12.05, 0.5], \"to\": [12.05, 1.5]}, "
             "{\"id\": \"g1\", \"from\": [%.3f, 0.05], \"to\": [%.3f, 1.95], \"closes\": 2}, "
             "{\"id\": \"g2\", \"from\": [%.3f, 3.05], \"to\": [%.3f, 4.95], \"closes\": 4.5}], "
             "\"run\": {\"until\": 90}, %s}",
             at, at, at, at, more);
    House house = {.driver = 0};
    case_made(&house, json_loads(text, 0, NULL), -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    for (size_t i = 0; i < observation.person_count && !touches; i++)
        CHECK(observation.people[i].contacts == 0);
    observation_free(&observation);
    house_free(&house);
}

TEST(lines_that_close_one_after_another_turn_people_twice) {
    check_ladder(5,
                 "\"people\": [{\"id\": \"p1\", \"profile\": \"adult\", \"at\": [1, 1]}, "
                 "{\"id\": \"p2\", \"profile\": \"adult\", \"at\": [1, 4], \"delay\": 1}, "
                 "{\"id\": \"p3\", \"profile\": \"adult\", \"at\": [1, 6.9], \"delay\": 0.5}], "
                 "\"routes\": [{\"id\": \"R\", \"people\": [\"p1\", \"p2\", \"p3\"], \"via\": [], \"exit\": \"e1\"}]",
                 true);
    check_ladder(5, "\"people\": [{\"id\": \"p1\", \"profile\": \"manual-chair\", \"at\": [1, 1], \"delay\": 5}]",
                 false);
}

/* Where the line is midway between grid points, both have the same distance from it: half a cell. */
TEST(who_stands_at_a_line_when_it_closes_turns) {
    static const double lines[] = {5, 5.02, 5.037};
    static const double before[] = {0.01, 0.05, 0.12, 0.3};
    for (size_t l = 0; l < sizeof lines / sizeof *lines; l++)
        for (size_t b = 0; b < sizeof before / sizeof *before; b++)
            for (int miura = 0; miura < 2; miura++) {
                char more[200];
                snprintf(more, sizeof more,
                         "\"people\": [{\"id\": \"p1\", \"profile\": \"%s\", \"at\": [%.3f, 1], \"delay\": 5}]",
                         miura ? "miura-chair" : "adult", lines[l] - before[b]);
                check_ladder(lines[l], more, miura);
            }
}

/* A line in a doorway, on either face of its wall or in the middle: the door is wide enough, and not to blame. */
TEST(a_closed_line_in_a_doorway_is_named) {
    static const double lines[] = {3.95, 4, 4.05};
    static const char *const profiles[] = {"adult", "manual-chair", "miura-chair"};
    for (size_t c = 0; c < 9; c++) {
        char text[1500];
        double line = lines[c / 3];
        snprintf(text, sizeof text,
                 "{\"format\": \"clearance-house\", \"version\": 1, \"name\": \"doorway\", \"walls\": ["
                 "{\"id\": \"outer\", \"points\": [[0, 0], [8, 0], [8, 4], [0, 4], [0, 0]], \"thickness\": 0.1}, "
                 "{\"id\": \"mid\", \"points\": [[4, 0], [4, 4]], \"thickness\": 0.1}], \"doors\": ["
                 "{\"id\": \"d0\", \"wall\": \"mid\", \"at\": 2.0, \"width\": 1.0}, "
                 "{\"id\": \"d1\", \"wall\": \"outer\", \"segment\": 1, \"at\": 2.0, \"width\": 1.0}], "
                 "\"exits\": [{\"id\": \"e1\", \"from\": [8.05, 1.5], \"to\": [8.05, 2.5]}, "
                 "{\"id\": \"g1\", \"from\": [%.2f, 1.5], \"to\": [%.2f, 2.5], \"closes\": 0.5}], "
                 "\"people\": [{\"id\": \"p1\", \"profile\": \"%s\", \"at\": [1.5, 2], \"delay\": 1}]}",
                 line, line, profiles[c % 3]);
        House house = {.driver = 0};
        case_made(&house, json_loads(text, 0, NULL), -1, NULL);
        Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
        CHECK(journeys.of[0].route.answer == ROUTE_CANNOT_PASS);
        CHECK_TEXT(journeys.of[0].route.blockage.what, "closed exit g1");
        CHECK(!(journeys.of[0].route.blockage.needs > 0));
        journey_free_all(&journeys);
        house_free(&house);
    }
}

/* An exit that closes, and another one on the same line that opens then: one door with two times. */
TEST(an_open_exit_is_not_held_by_a_closed_one_on_its_line) {
    static const char *const profiles[] = {"adult", "manual-chair", "miura-chair"};
    for (size_t c = 0; c < 6; c++) {
        json_t *plan = case_corridor(1.5);
        json_t *exits =
            json_pack("[{s:s, s:[f,f], s:[f,f], s:f}, {s:s, s:[f,f], s:[f,f], s:f}]", "id", "e1", "from", 6.0, -0.75,
                      "to", 6.0, 0.75, "closes", 30.0, "id", "e2", "from", 6.0, -0.75, "to", 6.0, 0.75, "opens", 30.0);
        json_object_set_new(plan, "exits", exits);
        case_add_person(plan, profiles[c / 2], 2, 0, 0);
        delay_person(plan, 0, c % 2 ? 35 : 0);
        House house = {.driver = 0};
        case_made(&house, plan, -1, NULL);
        Observation observation = case_run(&house, 1);
        CHECK(observation.completed);
        CHECK(observation.people[0].exit == exit_called(&house, c % 2 ? "e2" : "e1"));
        observation_free(&observation);
        house_free(&house);
    }
}
