/* Tests that furniture in a wall is reported with its depth, and furniture in a doorway is not. */
#include "plan/overlap.h"

#include "check.h"

static const char text[] =
    "{\"format\": \"clearance-house\", \"version\": 1, \"walls\": [{\"id\": \"w1\", \"points\": [[0, 0], [6, 0]], "
    "\"thickness\": 0.2}], \"doors\": [{\"id\": \"d1\", \"wall\": \"w1\", \"at\": 2, \"width\": 1}], \"furniture\": "
    "[{\"id\": \"f1\", \"centre\": [4, 0.5], \"size\": [1, 1]}, {\"id\": \"f2\", \"centre\": [4, 0.6], \"size\": [1, "
    "1]}, {\"id\": \"f3\", \"centre\": [2, 0.2], \"size\": [0.8, 0.4]}]}";

TEST(how_deep_a_piece_stands_in_a_wall) {
    Plan plan = {0};
    Fault fault = {0};
    size_t wall = 7;
    CHECK(plan_read_text(&plan, "overlap", text, NULL, 0, &fault));
    CHECK_NEAR(overlap_depth(&plan, &plan.furniture[0], &wall), 0.1, 1e-9);
    CHECK(wall == 0);
    CHECK(overlap_depth(&plan, &plan.furniture[1], &wall) < OVERLAP_LEAST); /* beside it */
    CHECK(overlap_depth(&plan, &plan.furniture[2], &wall) < OVERLAP_LEAST); /* in the doorway */
    plan_free(&plan);
    fault_clear(&fault);
}
