#include "check.h"

#include <string.h>

#include "case.h"
#include "result/jam.h"
#include "result/tight.h"

static void add(Observation *observation, const char *what, Vec2 at, double lost_time) {
    Hazard *hazard = &observation->hazards[observation->hazard_count++];
    *hazard = (Hazard){.at = at, .clearance = 0.1, .lost_time = lost_time};
    strcpy(hazard->what, what);
}

/* What is touched in a crowd says little: a jam is at an exit, a door, or in a room, and places are ranked by sums. */
TEST(the_jams_of_a_crowd_are_named_by_their_places_and_ranked_by_all_their_lost_time) {
    House house;
    case_house(&house, "shopping-centre", -1, NULL);
    Observation observation = {.hazards = memory_zeroed(HAZARDS_MOST, sizeof *observation.hazards)};
    add(&observation, "wall front-s-0", vec2(16.85, 10.95), 400);
    add(&observation, "door shop-1", vec2(5.53, 11.9), 560);
    add(&observation, "wall front-s-0", vec2(28.63, 10.86), 300);
    add(&observation, "free space", vec2(17.85, 11.0), 200);
    add(&observation, "door shop-3", vec2(29.0, 11.9), 100);
    add(&observation, "person p7", vec2(119.0, 14.0), 50);
    add(&observation, "wall front-s-0", vec2(24.0, 14.0), 40);
    Tight tight[HAZARDS_MOST];
    Arena arena = {0};
    static const char *const names[] = {"shop 2 door", "shop 1 door", "shop 3 door", "exit e1",
                                        "street 1, 5 m from shop 25 door"};
    CHECK(tight_all(&house, &observation, tight) == 5 && tight_count(&house, &observation) == 5);
    for (size_t i = 0; i < 5; i++)
        CHECK_TEXT(jam_name(&house, &observation.hazards[tight[i].hazard], &arena), names[i]);
    CHECK(tight[0].hazard == 0 && tight[1].hazard == 1 && tight[2].hazard == 2);
    CHECK_NEAR(tight[0].lost_time, 600, 1e-9);
    CHECK_NEAR(tight[1].lost_time, 560, 1e-9);
    CHECK_NEAR(tight[2].lost_time, 400, 1e-9);
    arena_clear(&arena);
    memory_free(observation.hazards);
    house_free(&house);
}

/* A jam is worst when most time is lost in it by people who have set off. */
TEST(a_jam_is_worst_when_most_people_wait_in_it) {
    House house;
    json_t *plan = case_corridor(3);
    for (int i = 0; i < 8; i++)
        case_add_person(plan, "adult", 1 + 0.6 * i, 0, 0);
    case_made(&house, plan, -1, NULL);
    Observation observation = {.people = NULL};
    trace_init(&observation.trace, observation_columns, TRACE_COLUMNS);
    for (int second = 0; second < 40; second++)
        for (int i = 0; i < 8; i++) {
            bool waits = second >= 20 && second < 23;
            double row[TRACE_COLUMNS] = {0};
            row[TRACE_TIME] = second + 0.5;
            row[TRACE_PERSON] = i;
            row[TRACE_X] = second < 10 ? 1 + 0.6 * i : 10;
            row[TRACE_SPEED] = second < 10 || waits ? 0 : 1;
            trace_add(&observation.trace, row);
        }
    CHECK_NEAR(jam_worst(&house, &observation, &(Hazard){.at = {10, 0}}), 21.5, 1e-9);
    trace_clear(&observation.trace);
    house_free(&house);
}

TEST(room_to_spare_is_read_in_centimetres) {
    Arena arena = {0};
    CHECK_TEXT(tight_to_spare(0.044, &arena), "4.4 cm");
    CHECK_TEXT(tight_to_spare(1.25, &arena), "1.25 m");
    CHECK_TEXT(tight_to_spare(-0.018, &arena), "touches");
    CHECK(!tight_to_spare(HUGE_VAL, &arena));
    arena_clear(&arena);
}
