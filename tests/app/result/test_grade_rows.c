/* The rows of grades and of tight places, written by hand. */
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "case.h"
#include "check.h"
#include "result/check.h"
#include "result/json.h"
#include "result/text.h"

TEST(a_tight_place_has_its_grade_its_centimetres_and_the_change_in_text_and_json) {
    House house;
    case_house(&house, "straight-corridor", -1, NULL);
    Grade grade = {.letter = GRADE_C,
                   .place_count = 2,
                   .places = {{.letter = GRADE_C,
                               .to_next = 0.015,
                               .at = {3.5, 0},
                               .what = "door d1",
                               .changes = true,
                               .by = 0.03,
                               .change = "widen door d1 by 3 cm to 0.73 m"},
                              {.letter = GRADE_B, .to_next = (double)NAN, .what = "wall n"}}};
    json_t *places = result_json_take_list(result_check_grade_places(&house, &grade));
    const json_t *door = json_array_get(places, 0), *wall = json_array_get(places, 1);
    CHECK(json_array_size(places) == 2);
    CHECK_TEXT(json_string_value(json_object_get(door, "what")), "door d1");
    CHECK_TEXT(json_string_value(json_object_get(door, "grade")), "C");
    CHECK_TEXT(json_string_value(json_object_get(door, "next")), "B");
    CHECK_NEAR(json_real_value(json_object_get(door, "to_next")), 0.015, 1e-12);
    CHECK_NEAR(json_real_value(json_object_get(json_object_get(door, "change"), "size")), 0.03, 1e-12);
    CHECK(!json_object_get(wall, "to_next") && !json_object_get(wall, "change"));
    json_decref(places);
    Text text = {0};
    result_text_take(&text, "", result_check_grade_places(&house, &grade));
    CHECK(strstr(text.text, "widen door d1 by 3 cm to 0.73 m") && strstr(text.text, "1.5"));
    CHECK(strstr(text.text, "no door or piece nearby is enough"));
    memory_free(text.text);
    house_free(&house);
}
