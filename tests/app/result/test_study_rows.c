/* The rows of studies and types: JSON and text print the same facts. */
#include "check.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "command/study_answer.h"
#include "command/study_text.h"
#include "result/json.h"
#include "result/page.h"
#include "result/paper.h"
#include "result/study.h"
#include "result/study_grades.h"
#include "result/text.h"
#include "result/types.h"

enum { REGULAR, WAY, MEASURE, EMPTY, OBSERVABLES };

static const Observable observables[] = {[REGULAR] = {"completed", "1", "all people are out"},
                                         [WAY] = {"way", "1", "the way"},
                                         [MEASURE] = {"time", "s", "time until all people are out"},
                                         [EMPTY] = {"lost", "s", "lost time"}};
static const Parameter width = {.name = "door.d1.width", .unit = "m"};

static const Parameter *find_parameter(const void *given, const char *name) {
    (void)given;
    (void)name;
    return &width;
}

static const Experiment house = {.kind = "house",
                                 .observables = observables,
                                 .observable_count = OBSERVABLES,
                                 .regular = REGULAR,
                                 .outcome = WAY,
                                 .measure = MEASURE,
                                 .parameter = find_parameter};

/* Widths from 0.8 m in steps of 0.1 m; nobody is out at the first. `clear_study` releases it. */
static Study make_study(size_t axes, size_t steps, size_t runs) {
    Study study = {.experiment = &house,
                   .axes = {{"door.d1.width", 0.8, 0.8 + 0.1 * (double)(steps - 1), steps}},
                   .axis_count = axes,
                   .passes = {STUDY_RESET},
                   .pass_count = 1,
                   .runs = runs,
                   .seed = 1};
    study_begin(&study);
    for (size_t t = 0; t < study.trial_count; t++) {
        Trial *trial = &study.trials[t];
        trial->done = true;
        trial->observed[REGULAR] = t % steps > 0;
        trial->observed[WAY] = 1;
        trial->observed[MEASURE] = t % steps > 0 ? 20 - (double)t : NAN;
        trial->observed[EMPTY] = NAN;
    }
    return study;
}

static void check_answer(const Study *study, const char *expected) {
    Text text = {0};
    study_text_add(&text, study, "flat.json");
    CHECK_TEXT(text.text, expected);
    memory_free(text.text);
}

TEST(a_study_along_an_axis_says_where_the_answer_changes_and_shows_each_value) {
    Study study = make_study(1, 3, 1);
    check_answer(&study,
                 "flat.json: door.d1.width from 0.8 to 1.0 m in 3 steps\n"
                 "not out at 0.8 m, out from 0.9 m on; the time until all people are out falls from 19 to 18 s\n\n"
                 "door.d1.width m  answer   time s\n"
                 "            0.8  not out       -\n"
                 "            0.9  out          19\n"
                 "            1.0  out          18\n");
    study.trials[2].observed[REGULAR] = study.trials[2].observed[MEASURE] = NAN;
    check_answer(&study, "flat.json: door.d1.width from 0.8 to 1.0 m in 3 steps\n"
                         "not out at 0.8 m, out at 0.9 m, undecided at 1.0 m; the time until all people are out is 19 s"
                         "\n\ndoor.d1.width m  answer     time s\n"
                         "            0.8  not out         -\n"
                         "            0.9  out            19\n"
                         "            1.0  undecided       -\n");
    study_clear(&study);
}

TEST(a_change_of_less_than_a_thousandth_of_the_range_is_not_reported) {
    const char *const words[] = {"falls from 19 to 15 s", "goes from 19 to 15.1 s, least 15 s at 1.1 m"};
    const double rises[] = {0.003, 0.1};
    for (int i = 0; i < 2; i++) {
        Study study = make_study(1, 5, 1);
        study.trials[3].observed[MEASURE] = 15;
        study.trials[4].observed[MEASURE] = 15 + rises[i];
        Text text = {0};
        study_text_add(&text, &study, "flat.json");
        CHECK(text.text && strstr(text.text, words[i]));
        memory_free(text.text);
        study_clear(&study);
    }
}

/* Ranks the third observable, as the grades of a house are. */
static Experiment graded_house(void) {
    static const char *const ranks[] = {"A", "B", "C", "D", "E", "F"};
    Experiment graded = house;
    graded.rank = EMPTY;
    graded.ranks = ranks;
    graded.rank_count = sizeof ranks / sizeof *ranks;
    graded.note = "grade_place";
    return graded;
}

TEST(grades_stand_in_the_table_in_a_sentence_and_in_json) {
    static const double grades[] = {NAN, 3, 3, 1};
    static const char *const places[] = {NULL, "door d1", "door d1", "start, beside wall w1"};
    const Experiment graded = graded_house();
    Study study = make_study(1, 4, 1);
    study.experiment = &graded;
    for (size_t t = 0; t < 4; t++) {
        study.trials[t].observed[EMPTY] = grades[t];
        study.trials[t].note = places[t] ? text_copy(places[t]) : NULL;
    }
    check_answer(&study,
                 "flat.json: door.d1.width from 0.8 to 1.1 m in 4 steps\n"
                 "not out at 0.8 m, out from 0.9 m on; the time until all people are out falls from 19 to 17 s\n"
                 "grade D, at door d1, from 0.9 to 1.0 m; grade B, at the start, beside wall w1, at 1.1 m\n\n"
                 "door.d1.width m  answer   grade  time s\n"
                 "            0.8  not out  -           -\n"
                 "            0.9  out      D          19\n"
                 "            1.0  out      D          18\n"
                 "            1.1  out      B          17\n");
    json_t *answer = study_answer_make(&study, "flat.json"), *list = json_object_get(answer, "grades");
    CHECK(json_array_size(list) == 3);
    CHECK_TEXT(json_string_value(json_object_get(json_array_get(list, 2), "grade")), "B");
    CHECK_TEXT(json_string_value(json_object_get(json_array_get(list, 2), "said")), "B, with care");
    CHECK_TEXT(json_string_value(json_object_get(json_array_get(list, 0), "what")), "door d1");
    CHECK_NEAR(json_number_value(json_object_get(json_object_get(json_array_get(list, 0), "at"), "door.d1.width")), 0.9,
               1e-12);
    json_decref(answer);
    ResultTable ranges = study_grades_ranges(&study);
    CHECK(ranges.record_count == 2);
    CHECK_TEXT(result_find(&ranges, 1, "what")->text, "start, beside wall w1");
    result_clear(&ranges);
    study_clear(&study);
}

TEST(an_interrupted_study_has_the_grades_of_the_runs_that_are_done) {
    const Experiment graded = graded_house();
    Study study = make_study(1, 3, 2);
    study.experiment = &graded;
    for (size_t t = 0; t < 6; t++) {
        study.trials[t].observed[EMPTY] = t % 3 ? (double)t : NAN; /* steps 1 and 2: B and C, then E and F */
        study.trials[t].done = t < 5;
    }
    CHECK(!study_grades_letter(&study, 0, 0));
    CHECK_TEXT(study_grades_letter(&study, 0, 1), "E");
    CHECK_TEXT(study_grades_letter(&study, 0, 2), "C");
    study_clear(&study);
}

TEST(an_answer_in_json_has_the_counts_the_ranges_and_the_best_run) {
    Study study = make_study(1, 3, 1);
    study.trials[0].observed[REGULAR] = NAN;
    json_t *answer = study_answer_make(&study, "flat.json");
    CHECK(json_integer_value(json_object_get(answer, "cannot_be_told")) == 1);
    CHECK(json_is_null(json_object_get(answer, "first_fault")));
    CHECK_TEXT(json_string_value(json_object_get(json_object_get(answer, "measure"), "unit")), "s");
    const json_t *ranges = json_object_get(answer, "ranges"), *best = json_object_get(answer, "best");
    CHECK(json_array_size(ranges) == 2);
    CHECK_TEXT(json_string_value(json_object_get(json_array_get(ranges, 0), "answer")), "cannot be told");
    CHECK_NEAR(json_number_value(json_object_get(json_array_get(ranges, 1), "to")), 1, 1e-12);
    CHECK_NEAR(json_number_value(json_object_get(best, "value")), 18, 0);
    CHECK_NEAR(json_number_value(json_object_get(json_object_get(best, "at"), "door.d1.width")), 1, 1e-12);
    json_decref(answer);
    study_clear(&study);
}

TEST(a_study_by_chance_has_distributions_of_what_people_read_and_of_all_in_json) {
    Study study = make_study(0, 1, 2);
    for (size_t t = 0; t < 2; t++) {
        study.trials[t].observed[REGULAR] = 1;
        study.trials[t].observed[MEASURE] = 10;
    }
    check_answer(&study,
                 "flat.json: 2 runs, seeds 1 to 2\n"
                 "out in 2 of 2 runs: 100.0 %, with 95 % confidence from 34.2 to 100.0 %\n"
                 "all runs are alike, since nothing in them is random; give a tolerance with --spread NAME=SHARE\n"
                 "\nobservable  unit  mean  deviation  std error  50 %  least  greatest\n"
                 "time        s       10          0          0    10     10        10\n");
    json_t *answer = study_answer_make(&study, "flat.json");
    const json_t *all = json_object_get(json_object_get(answer, "distribution"), "observables");
    CHECK(json_object_size(all) == OBSERVABLES);
    CHECK_NEAR(json_number_value(json_object_get(json_object_get(all, "time"), "q95")), 10, 0);
    CHECK(json_object_size(json_object_get(json_object_get(answer, "best"), "at")) == 0);
    CHECK(json_is_object(json_object_get(json_object_get(answer, "best"), "at")));
    json_decref(answer);
    study_clear(&study);
}

TEST(where_no_run_has_the_measure_there_is_no_best) {
    Study study = make_study(1, 1, 1);
    ResultTable least = result_study_extreme(&study, false);
    CHECK(least.record_count == 0);
    json_t *answer = study_answer_make(&study, "flat.json");
    CHECK(json_is_null(json_object_get(answer, "best")));
    json_decref(answer);
    result_clear(&least);
    study_clear(&study);
}

TEST(an_interrupted_type_is_neither_decided_nor_undecided) {
    Types types = {.kind = TYPES_KIND_INTERRUPTED, .reason = TYPES_INTERRUPTED, .stopped = true};
    ResultTable kind = result_types_kind(&types);
    CHECK_TEXT(result_find(&kind, 0, "type")->text, "interrupted");
    CHECK_TEXT(result_at(&kind, 0, 1)->text, "interrupted");
    CHECK_TEXT(result_find(&kind, 0, "reason")->text, "interrupted");
    result_clear(&kind);
}

TEST(a_parameter_of_a_type_has_the_same_rows_in_a_table_and_in_json) {
    Types types = {.kind = TYPES_UNRESOLVED,
                   .reason = TYPES_UNDECIDED,
                   .parameters = {{.name = "door.d1.width", .nominal = 0.8, .sensitivity = HUGE_VAL}},
                   .parameter_count = 1,
                   .points = {{.parameter = 1, .value = NAN, .possible = true, .undecided = 2, .answer_count = 1}},
                   .point_count = 1};
    types.parameters[0].below.reached = 0.2;
    types.parameters[0].above = (Neighbour){.answer = NEIGHBOUR_FOUND, .value = 0.84, .share = 0.05, .reached = 0.05};
    ResultTable kind = result_types_kind(&types), parameters = result_types_parameters(&types, &house);
    ResultTable points = result_types_points(&types, &house);
    CHECK_TEXT(result_find(&kind, 0, "type")->text, "unresolved");
    CHECK_TEXT(result_at(&kind, 0, 1)->text, "undecided");
    CHECK_TEXT(result_find(&kind, 0, "reason")->text, "cannot be told");
    CHECK_NEAR(result_find(&points, 0, "untold")->number, 2, 0);
    Text text = {0};
    result_text_table(&text, &parameters);
    CHECK_TEXT(text.text, "parameter      value  sensitivity      change below   change above\n"
                          "door.d1.width  0.8 m        jumps  none within 20 %  0.84 m (+5 %)\n");
    memory_free(text.text);
    json_t *object = result_json_record(&parameters, 0);
    char *dump = json_dumps(object, JSON_COMPACT | JSON_REAL_PRECISION(6));
    CHECK_TEXT(dump, "{\"name\":\"door.d1.width\",\"unit\":\"m\",\"value\":0.8,\"sensitivity\":null,\"jumps\":true,"
                     "\"below\":{\"at\":null,\"away\":null,\"looked\":0.2},"
                     "\"above\":{\"at\":0.84,\"away\":0.05,\"looked\":0.05}}");
    free(dump);
    json_decref(object);
    result_clear(&kind);
    result_clear(&parameters);
    result_clear(&points);
}

TEST(a_claim_of_the_paper_has_the_same_rows_as_lines_as_a_table_and_in_json) {
    PaperClaim claims[PAPER_CLAIMS];
    for (size_t i = 0; i < PAPER_CLAIMS; i++)
        claims[i] =
            (PaperClaim){"chaos", "figure 2", "it is chaotic", "chaotic", "periodic", PAPER_NOT_TOLD, "an exponent"};
    claims[1].met = PAPER_MET;
    ResultTable table = result_paper_claims(claims, PAPER_CLAIMS);
    Text text = {0};
    result_text_record(&text, &table, 0);
    CHECK_TEXT(text.text, "in the paper  figure 2\nclaim         it is chaotic\npaper         chaotic\n"
                          "ours          periodic\nresult        undecided\nmet when      an exponent\n");
    CHECK_TEXT(result_paper_summary(claims, PAPER_CLAIMS, &table.arena), "1 of 13 claims of the paper are met");
    json_t *object = result_json_record(&table, 0);
    char *dump = json_dumps(object, JSON_COMPACT);
    CHECK_TEXT(dump, "{\"id\":\"chaos\",\"place\":\"figure 2\",\"claim\":\"it is chaotic\",\"paper\":\"chaotic\","
                     "\"ours\":\"periodic\",\"met\":\"not told\",\"rule\":\"an exponent\"}");
    Document document = document_begin("clearance 9");
    result_page_table(&document, NULL, &table);
    const Block *block = &document.blocks[document.count - 1];
    CHECK(block->kind == BLOCK_TABLE && block->table.column_count == 6);
    CHECK_TEXT(block->table.columns[4].head, "Result");
    CHECK_TEXT(block->table.cells[4], "undecided");
    document_clear(&document);
    free(dump);
    json_decref(object);
    memory_free(text.text);
    result_clear(&table);
}
