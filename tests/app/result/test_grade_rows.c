/* The rows of grades and of tight places, written by hand. */
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "case.h"
#include "check.h"
#include "result/check.h"
#include "result/grade.h"
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

TEST(an_answer_has_the_worst_grade_of_those_that_are_known) {
    House house;
    Arena arena = {0};
    case_house(&house, "two-chairs-corridor", -1, NULL);
    Grade grades[2] = {{.letter = GRADE_B, .has_place = true, .what = "door d1"},
                       {.letter = GRADE_D, .has_place = true, .what = "start, beside wall w1"}};
    const char *title = "All 2 out in 9.0 s", *detail = "no contact";
    CHECK_TEXT(result_grade_phrase(&house, grades, &arena),
               "worst grade D, touching likely, at the start, beside wall w1");
    result_grade_add(&title, &detail, &house, grades, &arena);
    CHECK_TEXT(title, "All 2 out in 9.0 s, worst grade D");
    CHECK_TEXT(detail, "touching likely; no contact");
    title = "All 2 out in 9.0 s";
    detail = "no contact";
    result_grade_add(&title, &detail, &house, NULL, &arena); /* not known yet */
    CHECK_TEXT(title, "All 2 out in 9.0 s");
    CHECK_TEXT(detail, "working out the grade; no contact");
    grades[1].interrupted = true;
    CHECK_TEXT(result_grade_phrase(&house, grades, &arena), "grade B, with care, at door d1");
    grades[0] = (Grade){.letter = GRADE_E, .weak = true, .has_place = true, .what = "turn"};
    CHECK_TEXT(result_grade_phrase(&house, grades, &arena), "grade E, helper only, driver too weak");
    grades[0].interrupted = true;
    title = "No person takes part";
    detail = "";
    result_grade_add(&title, &detail, &house, grades, &arena);
    CHECK(!*result_grade_phrase(&house, grades, &arena) && !*detail);
    CHECK_TEXT(title, "No person takes part");
    arena_clear(&arena);
    house_free(&house);
}
