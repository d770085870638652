/* Tests ways that are longer than those on which the search is led first: round a gap that is too narrow, and to
 * another exit than the nearest, which opens only later. */

#include <math.h>
#include <stdio.h>

#include "case.h"
#include "check.h"
#include "house/journey.h"
#include "route/recall.h"
#include "rules/ways.h"

/* Turns a point about the origin, by an angle, rad, after mirroring it. */
static json_t *point(double x, double y, double angle, bool mirrored) {
    Vec2 at = vec2_turn(vec2(x, mirrored ? -y : y), vec2_heading(angle));
    return json_pack("[f,f]", at.x, at.y);
}

/* Returns two rooms with a tight door between them, near the chair and the exit, and a wide one 5 m away. */
static json_t *two_ways(double tight, double angle, bool mirrored) {
    static const double outer[][2] = {{0, 0}, {8, 0}, {8, 9}, {0, 9}, {0, 0}}, inner[][2] = {{0, 4}, {8, 4}};
    json_t *round = json_array(), *between = json_array();
    for (int i = 0; i < 5; i++)
        json_array_append_new(round, point(outer[i][0], outer[i][1], angle, mirrored));
    for (int i = 0; i < 2; i++)
        json_array_append_new(between, point(inner[i][0], inner[i][1], angle, mirrored));
    return json_pack("{s:s, s:i, s:s, s:[{s:s, s:o}, {s:s, s:o}], s:[{s:s, s:s, s:f, s:f}, {s:s, s:s, s:f, s:f}, "
                     "{s:s, s:s, s:i, s:f, s:f}], s:[{s:s, s:o, s:o}], s:[{s:s, s:s, s:o, s:f}]}",
                     "format", "clearance-house", "version", 1, "name", "two ways", "walls", "id", "w1", "points",
                     round, "id", "w2", "points", between, "doors", "id", "tight", "wall", "w2", "at", 2.0, "width",
                     tight, "id", "wide", "wall", "w2", "at", 7.2, "width", 1.1, "id", "front", "wall", "w1", "segment",
                     3, "at", 2.0, "width", 1.2, "exits", "id", "e", "from", point(-0.6, 7.6, angle, mirrored), "to",
                     point(-0.6, 6.4, angle, mirrored), "people", "id", "p1", "profile", "manual-chair", "at",
                     point(2, 1.5, angle, mirrored), "heading", degrees(angle) + (mirrored ? -90 : 90));
}

/* With a recall, the no of the first search is kept, the way round is found again. */
TEST(a_gap_that_is_too_narrow_hides_no_way_round_it) {
    for (int n = 0; n < 6; n++) {
        House house;
        case_made(&house, two_ways(0.56 + 0.02 * (n % 4), 0.6 * (n % 3), n % 2), -1, NULL);
        CHECK(journey_possible(&house, NULL, NULL) == JOURNEY_POSSIBLE);
        Recall *recall = recall_create();
        for (int again = 0; again < 2; again++) {
            Journeys journeys = journey_plan_recalling(&house, NULL, false, recall, NULL, 1, NULL);
            CHECK(journeys.of[0].route.answer == ROUTE_FOUND && journeys.of[0].route.narrowest > 0.1);
            journey_free_all(&journeys);
        }
        CHECK(recall_found(recall) > 0);
        recall_destroy(recall);
        house_free(&house);
    }
}

TEST(a_gap_is_seen_on_a_coarse_grid) {
    const char *const settings[] = {"run.cell=0.15", NULL};
    House house;
    case_made(&house, two_ways(0.60, 0, false), -1, settings);
    CHECK(journey_possible(&house, NULL, NULL) == JOURNEY_POSSIBLE);
    house_free(&house);
}

TEST(a_gap_that_is_too_narrow_is_told_where_there_is_no_way_round_it) {
    House house;
    json_t *plan = two_ways(0.60, 0.6, false);
    json_object_set_new(json_array_get(json_object_get(plan, "doors"), 1), "state", json_string("locked"));
    case_made(&house, plan, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    CHECK(journeys.of[0].route.answer == ROUTE_CANNOT_PASS);
    CHECK_TEXT(journeys.of[0].route.blockage.what, "door tight");
    journey_free_all(&journeys);
    house_free(&house);
}

/* Returns a room with an exit near the person, which opens later, and one farther away. */
static json_t *two_exits(const char *profile, double opens) {
    return json_pack("{s:s, s:i, s:s, s:[{s:s, s:[[f,f],[f,f],[f,f],[f,f],[f,f]]}], s:[{s:s, s:s, s:f, s:f, s:s}, "
                     "{s:s, s:s, s:f, s:f, s:s}], s:[{s:s, s:[f,f], s:[f,f], s:f}, {s:s, s:[f,f], s:[f,f]}], "
                     "s:[{s:s, s:s, s:[f,f], s:f}]}",
                     "format", "clearance-house", "version", 1, "name", "two exits", "walls", "id", "w1", "points", 0.0,
                     0.0, 12.0, 0.0, 12.0, 4.0, 0.0, 4.0, 0.0, 0.0, "doors", "id", "d1", "wall", "w1", "at", 2.0,
                     "width", 1.0, "kind", "opening", "id", "d2", "wall", "w1", "at", 10.0, "width", 1.0, "kind",
                     "opening", "exits", "id", "near", "from", 1.5, -0.2, "to", 2.5, -0.2, "opens", opens, "id", "far",
                     "from", 9.5, -0.2, "to", 10.5, -0.2, "people", "id", "p1", "profile", profile, "at", 4.0, 2.0,
                     "heading", 180.0);
}

TEST(nobody_waits_for_an_exit_while_another_is_sooner) {
    static const struct {
        const char *profile;
        double most; /* s, to the farther exit */
    } people[] = {{"manual-chair", 14}, {"miura-chair", 14}, {"adult", 7}};
    for (size_t k = 0; k < sizeof people / sizeof *people; k++)
        for (int late = 0; late < 3; late++) {
            const double opens[] = {1, people[k].most - 3, 60};
            House house;
            case_made(&house, two_exits(people[k].profile, opens[late]), -1, NULL);
            Observation observation = case_run(&house, 1);
            double time = observation.people[0].time;
            CHECK(observation.people[0].completed);
            CHECK(late == 0 ? observation.people[0].exit == 0 && time < 0.7 * people[k].most : time < people[k].most);
            CHECK(late < 2 || observation.people[0].exit == 1);
            observation_free(&observation);
            house_free(&house);
        }
}

/* The chair would wait for 9 s until the door to the near exit is open. */
TEST(the_wait_for_a_door_counts_in_the_choice_of_an_exit) {
    for (int later = 0; later < 2; later++) {
        json_t *plan = two_exits("manual-chair", 0);
        json_t *door = json_array_get(json_object_get(plan, "doors"), 0);
        json_object_set_new(door, "kind", json_string("sliding"));
        json_object_set_new(door, "state", json_string("closed"));
        json_object_set_new(door, "opening_time", json_real(15));
        json_object_set_new(json_array_get(json_object_get(plan, "exits"), 1), "opens", json_real(later ? 0.5 : 0));
        House house;
        case_made(&house, plan, -1, NULL);
        Observation observation = case_run(&house, 1);
        CHECK(observation.people[0].exit == 1 && observation.people[0].time < 14);
        observation_free(&observation);
        house_free(&house);
    }
}

/* What does not ask for a time asks for all exits. */
TEST(an_exit_that_opens_later_is_an_exit_for_rules_and_reasons) {
    size_t ways[2];
    char what[2][sizeof((Blockage *)0)->what];
    for (int later = 0; later < 2; later++) {
        json_t *plan = case_plan("closed-door");
        json_object_set_new(json_array_get(json_object_get(plan, "doors"), 0), "state", json_string("locked"));
        json_object_set_new(json_array_get(json_object_get(plan, "exits"), 0), "opens", json_real(later ? 5 : 0));
        House house;
        case_made(&house, plan, -1, NULL);
        Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
        snprintf(what[later], sizeof what[later], "%s", journeys.of[0].route.blockage.what);
        journey_free_all(&journeys);
        house_free(&house);
        plan = case_plan("flat-0.910-module");
        json_object_set_new(json_array_get(json_object_get(plan, "exits"), 0), "opens", json_real(later ? 5 : 0));
        case_made(&house, plan, -1, NULL);
        RuleWays found = ways_find(&house, NULL);
        ways[later] = found.count;
        ways_free(&found);
        house_free(&house);
    }
    CHECK(ways[0] > 1 && ways[0] == ways[1]);
    CHECK_TEXT(what[1], what[0]);
}
