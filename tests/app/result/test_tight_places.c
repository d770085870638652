#include "check.h"

#include <string.h>

#include "case.h"
#include "result/names.h"
#include "result/tight.h"

static void add(Observation *observation, const char *what, Vec2 at, double lost_time) {
    Hazard *hazard = &observation->hazards[observation->hazard_count++];
    *hazard = (Hazard){.at = at, .clearance = 0.1, .lost_time = lost_time};
    strcpy(hazard->what, what);
}

/* The wall along the shops of a street is one place for each shop, and the places are ranked by their sums. */
TEST(a_place_is_a_thing_in_one_room_and_ranked_by_all_its_lost_time) {
    House house;
    case_house(&house, "shopping-centre", -1, NULL);
    Observation observation = {.hazards = memory_zeroed(HAZARDS_MOST, sizeof *observation.hazards)};
    add(&observation, "wall front-s-0", vec2(16.85, 10.95), 400);
    add(&observation, "door shop-1", vec2(5.53, 11.9), 560);
    add(&observation, "wall front-s-0", vec2(28.63, 10.86), 300);
    add(&observation, "wall front-s-0", vec2(17.85, 11.0), 200);
    add(&observation, "door shop-3", vec2(29.0, 11.9), 100);
    Tight tight[TIGHT_MOST];
    Arena arena = {0};
    CHECK(tight_places(&house, &observation, tight) == TIGHT_MOST && tight_count(&house, &observation) == 4);
    CHECK(tight[0].hazard == 0 && tight[1].hazard == 1 && tight[2].hazard == 2);
    CHECK_NEAR(tight[0].lost_time, 600, 1e-9);
    CHECK_NEAR(tight[1].lost_time, 560, 1e-9);
    CHECK_NEAR(tight[2].lost_time, 300, 1e-9);
    CHECK_TEXT(names_thing(&house, "wall front-s-0", observation.hazards[0].at, &arena), "upper wall of shop 2");
    CHECK_TEXT(names_thing(&house, "wall front-s-0", observation.hazards[2].at, &arena), "upper wall of shop 3");
    arena_clear(&arena);
    memory_free(observation.hazards);
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
