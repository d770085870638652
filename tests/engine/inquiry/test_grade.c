#include "inquiry/grade.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "case.h"
#include "check.h"
#include "inquiry/grade_try.h"

/* Releases the plan. */
static Grade grade_chair(json_t *plan, double x) {
    House house;
    case_add_person(plan, "manual-chair", x, 0, 0);
    case_made(&house, plan, -1, NULL);
    Grade grade = grade_person(&house, 0, NULL);
    house_free(&house);
    return grade;
}

static Grade grade_corridor(double width) {
    return grade_chair(case_corridor(width), 14);
}

/* In a corridor c* is half of what is wider than the chair, 0.63 m. */
LONG_TEST(a_corridor_has_the_grade_of_its_width) {
    static const struct {
        double width;
        int letter;
        double to_next; /* m */
    } known[] = {{0.95, GRADE_A, 0},
                 {0.80, GRADE_B, 0.138 - 0.085},
                 {0.70, GRADE_C, 0.05 - 0.035},
                 {0.65, GRADE_D, 0.015 - 0.010},
                 {0.61, GRADE_F, 0.010}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        Grade grade = grade_corridor(known[k].width);
        CHECK_NEAR(grade.letter, known[k].letter, 0);
        CHECK_NEAR(grade.to_next, known[k].to_next, 0.005);
        CHECK_NEAR(grade.tightness, fmin((known[k].width - 0.63) / 2, 0.138), 0.005);
        CHECK(grade.wider == (k == 0) && !grade.interrupted);
    }
}

TEST(a_corridor_of_0_80_m_is_driven_with_care) {
    Grade grade = grade_corridor(0.80);
    CHECK_NEAR(grade.letter, GRADE_B, 0);
    CHECK_NEAR(grade.tightness, 0.085, 0.005);
    CHECK_TEXT(grade.what, "start, beside wall south"); /* only the body that was grown is inside it */
    CHECK(strcmp(grade_letter(GRADE_A), "A") == 0 && strcmp(grade_letter(GRADE_F), "F") == 0);
    CHECK(strcmp(grade_words(GRADE_E), "helper only") == 0);
}

static Grade grade_corner(double w, double angle) {
    House house;
    case_made(&house, case_corner(w, w, angle), -1, NULL);
    Grade grade = grade_person(&house, 0, NULL), alone = grade_person_letter(&house, 0, NULL);
    CHECK(alone.letter == grade.letter && isnan(alone.tightness));
    house_free(&house);
    return grade;
}

/* The limits of a corridor are closed forms. Within the resolution of them the better grade is told. */
TEST(the_letter_alone_is_that_of_the_room_and_only_of_those_asked_for) {
    static const struct {
        double spare; /* m, on each side */
        int letter;
    } known[] = {{0.142, GRADE_A}, {0.132, GRADE_B}, {0.054, GRADE_B}, {0.044, GRADE_C},
                 {0.019, GRADE_C}, {0.009, GRADE_D}, {-0.01, GRADE_F}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        House house;
        json_t *plan = case_corridor(0.63 + 2 * known[k].spare);
        case_add_person(plan, "manual-chair", 14, 0, 0);
        case_add_person(plan, "manual-chair", 12, 0, 0);
        case_made(&house, plan, -1, NULL);
        Grade grades[2];
        CHECK(grade_all_letters(grades, &house, (const bool[]){true, false}, 2, NULL));
        CHECK_NEAR(grades[0].letter, known[k].letter, 0);
        CHECK(!grades[0].interrupted && grades[1].interrupted && isnan(grades[0].tightness));
        CHECK(grades[0].has_place == (known[k].letter != GRADE_A));
        house_free(&house);
    }
}

/* The last person has more room than the first one in the same corridor. */
TEST(the_worst_letter_is_the_worst_of_all_letters) {
    static const double widths[] = {0.67, 0.72, 0.80, 0.95};
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
        House house;
        json_t *plan = case_corridor(widths[k]);
        case_add_person(plan, "manual-chair", 14, 0, 0);
        case_add_person(plan, "manual-chair", 12, 0, 0);
        case_made(&house, plan, -1, NULL);
        PersonObservation people[2] = {{.took_part = true, .completed = true}, {.took_part = true, .completed = true}};
        Observation observation = {.completed = true, .people = people, .person_count = 2};
        Grade *grades, worst;
        CHECK(grade_answer(&grades, &house, &observation, 2, 2, NULL) && grades);
        CHECK(grade_answer_worst(&worst, &house, &observation, 2, NULL) && !worst.interrupted);
        const Grade *expected = &grades[grade_worst(&house, grades)];
        CHECK(worst.letter == expected->letter && worst.has_place == expected->has_place);
        CHECK_TEXT(worst.what, expected->what);
        memory_free(grades);
        CHECK(grade_answer(&grades, &house, &observation, 1, 2, NULL) && !grades); /* two are a crowd then */
        CHECK(grade_answer_worst(&worst, &house, &observation, 1, NULL) && worst.interrupted);
        observation.completed = false;
        CHECK(grade_answer_worst(&worst, &house, &observation, 2, NULL) && worst.interrupted);
        house_free(&house);
    }
}

LONG_TEST(a_corner_is_as_tight_turned_and_no_tighter_when_wider) {
    Grade narrow = grade_corner(0.94, 0), slanted = grade_corner(0.94, M_PI / 6), wide = grade_corner(0.98, 0);
    printf("c*: %.1f mm, turned %.1f mm; 4 cm wider %.1f mm\n", 1000 * narrow.tightness, 1000 * slanted.tightness,
           1000 * wide.tightness);
    CHECK_NEAR(slanted.tightness, narrow.tightness, 0.005);
    CHECK(wide.tightness >= narrow.tightness && wide.letter <= narrow.letter);
    /* the body fits there and cannot be driven: the place is where it sticks */
    CHECK(vec2_distance(narrow.at, vec2(4, 0.94)) < 1);
    CHECK(vec2_distance(vec2_turn(slanted.at, vec2_heading(-M_PI / 6)), vec2(4, 0.94)) < 1);
}

/* Out of a room by a door into a corridor, where one lattice finds the way and another does not. */
LONG_TEST(whether_a_tight_door_is_passed_does_not_hang_on_one_search) {
    static const double sizes[][2] = {{0.94, 0.80}, {0.92, 0.82}, {0.94, 0.82}}; /* m, corridor and door */
    for (size_t k = 0; k < 2 * (sizeof sizes / sizeof *sizes); k++) {
        House house;
        double angle = k % 2 ? M_PI / 6 : 0;
        case_made(&house, case_side_door(sizes[k / 2][0], sizes[k / 2][1], true, angle), -1, NULL);
        GradeTry tried = grade_try_growth(&house, 0, 0, house.plan.run.reversals, NULL);
        CHECK(tried.found && tried.holds > 0.002);
        house_free(&house);
    }
}

LONG_TEST(who_cannot_pass_has_no_grade_of_those_who_can) {
    for (int k = 0; k < 3; k++) {
        House house;
        case_made(&house, case_side_door(0.92 + 0.01 * k, 0.80, true, 0), -1, NULL);
        bool found = grade_try_growth(&house, 0, 0, house.plan.run.reversals, NULL).found;
        Grade grade = grade_person(&house, 0, NULL);
        printf("corridor %.2f m: %s, %s, c* %.1f mm\n", 0.92 + 0.01 * k, found ? "passes" : "cannot pass",
               grade_letter(grade.letter), 1000 * grade.tightness);
        CHECK((grade.letter <= GRADE_D) == found && (grade.tightness >= 0) == found);
        house_free(&house);
    }
}

/* Two openings one after the other, `first` and 0.80 m wide, in a closed corridor of 1.40 m. */
static json_t *two_doors(double first) {
    return json_pack("{s:s, s:i, s:s, s:[{s:s, s:[[f,f],[f,f],[f,f],[f,f],[f,f]], s:f}, {s:s, s:[[f,f],[f,f]], s:f}, "
                     "{s:s, s:[[f,f],[f,f]], s:f}], s:[{s:s, s:s, s:f, s:f, s:s}, {s:s, s:s, s:f, s:f, s:s}], "
                     "s:[{s:s, s:[f,f], s:[f,f]}], s:[]}",
                     "format", "clearance-house", "version", 1, "name", "two doors", "walls", "id", "w", "points", 0.0,
                     -0.8, 12.0, -0.8, 12.0, 0.8, 0.0, 0.8, 0.0, -0.8, "thickness", 0.2, "id", "c1", "points", 3.5,
                     -0.8, 3.5, 0.8, "thickness", 0.12, "id", "c2", "points", 6.5, -0.8, 6.5, 0.8, "thickness", 0.12,
                     "doors", "id", "d1", "wall", "c1", "at", 0.8, "width", first, "kind", "opening", "id", "d2",
                     "wall", "c2", "at", 0.8, "width", 0.80, "kind", "opening", "exits", "id", "e1", "from", 9.5, -0.7,
                     "to", 9.5, 0.7, "people");
}

static Grade grade_two_doors(double first) {
    return grade_chair(two_doors(first), 1.8);
}

/* A straight door gives (its width - 0.63) / 2 on each side; B needs 0.05, A 0.138. */
LONG_TEST(each_tight_place_has_its_grade_and_the_change_that_buys_the_next) {
    Grade grade = grade_two_doors(0.70);
    const GradePlace *places = grade.places;
    for (size_t p = 0; p < grade.place_count; p++)
        printf("%s: %s, %.1f cm, %s\n", places[p].what, grade_letter(places[p].letter), 100 * places[p].to_next,
               places[p].change);
    CHECK(grade.letter == GRADE_C && grade.place_count == 2 && strcmp(grade.what, "door d1") == 0);
    CHECK(strcmp(places[0].what, "door d1") == 0 && places[0].letter == GRADE_C && places[0].changes);
    CHECK_NEAR(places[0].to_next, 0.05 - 0.035, 0.005);
    CHECK_NEAR(places[0].by, 0.73 - 0.70, 0.011);
    CHECK(strncmp(places[0].change, "widen door d1 by ", strlen("widen door d1 by ")) == 0);
    CHECK(strcmp(places[1].what, "door d2") == 0 && places[1].letter == GRADE_B && places[1].changes);
    CHECK_NEAR(places[1].to_next, 0.138 - 0.085, 0.005);
    CHECK_NEAR(places[1].by, 0.906 - 0.80, 0.011);
    Grade limit = grade_two_doors(0.66); /* C needs 0.015 m, which is all there is */
    CHECK(limit.place_count >= 1 && strcmp(limit.places[0].what, "door d1") == 0 && limit.places[0].changes);
    Grade wider = grade_two_doors(0.70 + places[0].by);
    CHECK(wider.letter == GRADE_B && wider.place_count >= 1);
    for (size_t p = 0; p < wider.place_count; p++)
        CHECK(wider.places[p].letter == GRADE_B);
}

TEST(where_no_door_or_piece_helps_the_place_is_said_without_a_change) {
    Grade grade = grade_corridor(0.80);
    CHECK(grade.place_count == 1 && !grade.places[0].changes);
    CHECK_NEAR(grade.places[0].letter, GRADE_B, 0);
    CHECK_NEAR(grade.places[0].to_next, grade.to_next, 1e-12);
}
