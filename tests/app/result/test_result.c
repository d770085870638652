/* The four pens print the same rows. */
#include "beam/beam_cycle.h"
#include "check.h"

#include <stdint.h>
#include <string.h>

#include "case.h"
#include "pens.h"
#include "command/answer.h"
#include "house/journey.h"
#include "result/headline.h"
#include "result/beam.h"
#include "result/check.h"
#include "result/house.h"
#include "result/json.h"
#include "result/page.h"
#include "result/panel.h"
#include "result/suggest.h"
#include "result/text.h"

/* A record with a fact of each kind. */
static ResultTable sample(void) {
    ResultTable table = {0};
    result_add(&table, (ResultRow){.key = "id", .label = "person", .text = "p1"});
    result_add(&table, (ResultRow){.key = "out", .label = "result", .kind = RESULT_FLAG, .number = 1, .text = "out"});
    result_add(
        &table,
        (ResultRow){
            .key = "turns", .label = "changes of direction", .head = "turns", .kind = RESULT_COUNT, .number = 3});
    result_add(&table, (ResultRow){.key = "near.x", .kind = RESULT_NUMBER, .number = 1.5});
    result_add(&table, (ResultRow){.key = "near.clearance",
                                   .label = "narrowest",
                                   .kind = RESULT_NUMBER,
                                   .number = -1e-9,
                                   .unit = "m",
                                   .decimals = 3,
                                   .difference = DIFFERENCE_IF_BOTH});
    result_add(&table, (ResultRow){.key = "error",
                                   .label = "error",
                                   .kind = RESULT_NUMBER,
                                   .number = 0.0123,
                                   .unit = "%",
                                   .factor = 100,
                                   .decimals = 1,
                                   .sign = true});
    result_add(&table,
               (ResultRow){.key = "force", .label = "force", .kind = RESULT_NUMBER, .number = NAN, .unit = "N"});
    result_add(&table, (ResultRow){.key = "reason", .label = "reason", .omitted = true});
    result_end(&table);
    return table;
}

TEST(long_times_are_read_in_minutes_in_the_panel) {
    static const struct {
        double seconds;
        const char *text;
    } times[] = {{18.4, "18.4 s"}, {20.83, "20.8 s"}, {99.9, "99.9 s"}, {99.96, "1:40"}, {411.9, "6:52"}};
    Arena arena = {0};
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        ResultRow row = {
            .label = "last out", .kind = RESULT_NUMBER, .number = times[i].seconds, .unit = "s", .decimals = 2};
        SceneRow line, pair;
        CHECK(result_panel_row(&line, &row, &arena) && result_panel_pair(&pair, &row, &row, &arena));
        CHECK_TEXT(line.cells[1], times[i].text);
        CHECK_TEXT(pair.cells[2], times[i].text);
    }
    arena_clear(&arena);
}

TEST(lengths_in_the_panel_are_gaps_in_centimetres_and_widths_in_metres) {
    static const struct {
        double length;
        bool gap;
        const char *text;
    } lengths[] = {{0.044, true, "4.4 cm"},   {0.135, true, "13.5 cm"}, {1.25, true, "1.25 m"},
                   {-0.002, true, "touches"}, {0.83, false, "0.83 m"},  {8.451, false, "8.45 m"}};
    Arena arena = {0};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        ResultRow row = {.label = "length",
                         .kind = RESULT_NUMBER,
                         .number = lengths[i].length,
                         .unit = "m",
                         .decimals = 3,
                         .gap = lengths[i].gap};
        SceneRow line;
        CHECK(result_panel_row(&line, &row, &arena));
        CHECK_TEXT(line.cells[1], lengths[i].text);
    }
    arena_clear(&arena);
}

TEST(a_record_is_an_object_whose_keys_with_points_are_objects_within) {
    ResultTable table = sample();
    json_t *object = result_json_record(&table, 0);
    char *text = json_dumps(object, JSON_COMPACT | JSON_REAL_PRECISION(12));
    CHECK_TEXT(text, "{\"id\":\"p1\",\"out\":true,\"turns\":3,\"near\":{\"x\":1.5,\"clearance\":-0.0},\"error\":0.0123,"
                     "\"force\":null}");
    free(text);
    json_decref(object);
    result_clear(&table);
}

TEST(a_table_has_columns_for_what_is_known) {
    ResultTable table = sample();
    Text text = {0};
    result_text_table(&text, &table);
    CHECK_TEXT(text.text, "person  result  turns  narrowest m  error %\n"
                          "p1      out         3        0.000     +1.2\n");
    memory_free(text.text);
    result_clear(&table);
}

TEST(a_list_has_a_line_for_each_fact_with_its_unit) {
    ResultTable table = sample();
    Text text = {0};
    result_text_list(&text, (const ResultTable *const[]){&table}, 1);
    CHECK_TEXT(text.text, "person                p1\nresult                out\nchanges of direction  3\n"
                          "narrowest             0.000 m\nerror                 +1.2 %\n");
    memory_free(text.text);
    result_clear(&table);
}

static const char *decimal_text(double number, int decimals, bool sign, Arena *arena) {
    ResultRow row = {.kind = RESULT_NUMBER, .number = number, .decimals = decimals, .sign = sign};
    return result_value(&row, arena);
}

static const char *significant_text(double number, int significant, Arena *arena) {
    ResultRow row = {.kind = RESULT_NUMBER, .number = number, .significant = significant};
    return result_value(&row, arena);
}

TEST(a_number_that_rounds_to_nought_has_no_sign) {
    Arena arena = {0};
    CHECK_TEXT(decimal_text(-0.0001, 2, false, &arena), "0.00");
    CHECK_TEXT(decimal_text(-0.0, 1, true, &arena), "0.0");
    CHECK_TEXT(decimal_text(-0.5, 0, false, &arena), "0");
    CHECK_TEXT(decimal_text(0.5, 0, true, &arena), "0");
    CHECK_TEXT(decimal_text(-5e-7, 6, false, &arena), "0.000000");
    CHECK_TEXT(decimal_text(-0.0051, 2, false, &arena), "-0.01");
    CHECK_TEXT(decimal_text(0.0051, 2, true, &arena), "+0.01");
    CHECK_TEXT(decimal_text(-1.5, 0, false, &arena), "-2");
    arena_clear(&arena);
}

TEST(a_number_has_its_significant_digits_after_rounding_up) {
    Arena arena = {0};
    CHECK_TEXT(significant_text(9.994, 3, &arena), "9.99");
    CHECK_TEXT(significant_text(9.996, 3, &arena), "10.0");
    CHECK_TEXT(significant_text(-9.996, 3, &arena), "-10.0");
    CHECK_TEXT(significant_text(99.96, 3, &arena), "100");
    CHECK_TEXT(significant_text(999.6, 3, &arena), "1000");
    CHECK_TEXT(significant_text(0.09996, 3, &arena), "0.100");
    CHECK_TEXT(significant_text(0.5, 1, &arena), "0.5");
    CHECK_TEXT(significant_text(0.95, 1, &arena), "0.9"); /* the double next to 0.95 is below it */
    CHECK_TEXT(significant_text(9.5, 1, &arena), "10");   /* ties go to the even digit, which carries */
    CHECK_TEXT(significant_text(8.5, 1, &arena), "8");
    CHECK_TEXT(significant_text(1000, 2, &arena), "1000");
    CHECK_TEXT(significant_text(0, 3, &arena), "0");
    CHECK_TEXT(significant_text(-1e-5, 2, &arena), "-0.000010");
    ResultRow list = {.kind = RESULT_LIST, .list = (const double[]){9.996, INFINITY}, .count = 2, .significant = 3};
    CHECK_TEXT(result_value(&list, &arena), "10.0, inf");
    arena_clear(&arena);
}

TEST(names_alone_are_no_table) {
    ResultTable table = {0};
    Text text = {0};
    result_add(&table, (ResultRow){.key = "id", .label = "route", .text = "A"});
    result_add(&table, (ResultRow){.key = "mean", .label = "mean", .kind = RESULT_NUMBER, .number = NAN});
    result_end(&table);
    result_text_table(&text, &table);
    CHECK(!text.text);
    result_clear(&table);
}

TEST(a_page_is_never_too_narrow_for_a_table) {
    enum { FACTS = 25 };
    ResultTable table = {0};
    for (int f = 0; f < FACTS; f++)
        result_add(&table, (ResultRow){.label = text_in_arena(&table.arena, "fact %d", f), .text = "known"});
    result_end(&table);
    Document document = document_begin("clearance 9");
    result_page_table(&document, "caption", &table);
    size_t cells = 0, parts = 0;
    for (const Block *block; (block = pens_table(&document, parts)); parts++) {
        CHECK(block->table.column_count <= 10);
        CHECK_TEXT(block->table.columns[0].head, "Fact 0");
        cells += block->table.column_count - 1;
    }
    CHECK(parts == 3 && cells == FACTS - 1);
    document_clear(&document);
    result_clear(&table);
}

TEST(two_runs_are_compared_where_both_have_succeeded) {
    ResultTable a = sample(), b = sample(), compared = {0}, failed = {0};
    b.rows[4].number = 0.2;
    ResultPair pair = {&a, &b, {"a", "b", "b - a"}, "out", NULL};
    result_compare(&compared, &pair);
    CHECK(compared.record_count == 3 && compared.row_count == 4);
    CHECK_NEAR(result_find(&compared, 2, "near.clearance")->number, 0.2, 1e-8);
    b.rows[1].number = 0;
    result_compare(&failed, &pair);
    CHECK(isnan(result_find(&failed, 2, "near.clearance")->number));
    b.rows[0].text = "p2";
    CHECK(result_partner(&pair, 0) == SIZE_MAX);
    result_clear(&a);
    result_clear(&b);
    result_clear(&compared);
    result_clear(&failed);
}

TEST(a_difference_agrees_with_the_numbers_beside_it) {
    static const struct {
        double a, b, factor;
        int decimals, significant;
        const char *text;
    } cases[] = {{20.84, 20.56, 0, 1, 0, "-0.2"},     /* 20.8, 20.6; the numbers differ by 0.28 */
                 {0.0444, 0.0456, 100, 1, 0, "+0.2"}, /* 4.4 cm, 4.6 cm, 0.12 cm */
                 {1.04, 1.06, 0, 1, 0, "+0.1"},       /* 1.0, 1.1 */
                 {9.994, 10.04, 0, 0, 3, "+0.01"},    /* 9.99, 10.0 */
                 {1234.4, 1234.6, 0, 0, 3, "+1"},     /* 1234, 1235 */
                 {2.04, 1.96, 0, 1, 0, "0.0"}};
    Arena arena = {0};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ResultRow a = {.kind = RESULT_NUMBER,
                       .number = cases[i].a,
                       .factor = cases[i].factor,
                       .decimals = cases[i].decimals,
                       .significant = cases[i].significant,
                       .difference = DIFFERENCE_ALWAYS},
                  b = a;
        b.number = cases[i].b;
        ResultRow difference = result_difference(&a, &b, true);
        CHECK_TEXT(result_value(&difference, &arena), cases[i].text);
        CHECK_NEAR(difference.number, cases[i].b - cases[i].a, 1e-12);
    }
    arena_clear(&arena);
}

static void check_house(const char *name, size_t least) {
    House house;
    case_house(&house, name, -1, NULL);
    Observation observation = case_run(&house, 1);
    Text text = {0};
    Document document = document_begin("clearance 9");
    answer_text_add(&text, &house, &observation, "");
    result_page_take(&document, NULL, result_house_people(&house, &observation));
    json_t *answer = answer_house(&house, &observation);
    ResultTable people = result_house_people(&house, &observation);
    pens_check_facts(&people, least, text.text, json_array_get(json_object_get(answer, "people"), 0), &document);
    result_clear(&people);
    document_clear(&document);
    ResultTable places = result_house_hindrances(&house, &observation);
    document = document_begin("clearance 9");
    result_page_take(&document, NULL, result_house_hindrances(&house, &observation));
    if (places.record_count)
        pens_check_facts(&places, 5, text.text, json_array_get(json_object_get(answer, "hindrances"), 0), &document);
    result_clear(&places);
    document_clear(&document);
    json_decref(answer);
    memory_free(text.text);
    observation_free(&observation);
    house_free(&house);
}

/* The facts of a check, and its sentence, with a number of facts at least. */
static void check_paths(const char *name, const char *sentence, size_t least) {
    House house;
    Arena arena = {0};
    case_house(&house, name, -1, NULL);
    Journeys journeys = journey_plan_all(&house, NULL, 1, NULL);
    Observation observation = result_check_observation(&house, &journeys);
    Census census = census_make(&house, &observation);
    ResultTable people = result_check_people(&house, &journeys, NULL);
    pens_check(&people, least);
    CHECK_TEXT(result_check_sentence(&house, &observation, &census, &arena), sentence);
    result_clear(&people);
    arena_clear(&arena);
    census_clear(&census);
    observation_free(&observation);
    journey_free_all(&journeys);
    house_free(&house);
}

TEST(each_fact_of_a_planned_path_is_printed_by_all_pens) {
    check_paths("corner-1.00-1.00", "p1 can leave by e1", 9);
    check_paths("two-chairs-corridor", "All 2 people can leave", 9);
}

TEST(each_fact_of_a_path_that_is_too_narrow_is_printed_by_all_pens) {
    check_paths("flat-0.910-module", "p1 cannot pass door d3: needs at least 0.82 m, has 0.75 m", 10);
}

TEST(each_fact_of_a_suggestion_is_printed_by_all_pens) {
    const char *const settings[] = {"door.d3.width=0.83", "door.d4.width=0.9"};
    SuggestList list = {
        .list = {{"Widen doors", settings, 2, 0.08, 26.068, {true, false, false, true}}}, .count = 1, .tries = 18};
    ResultTable table = result_suggest_changes(&list, NULL), copy = result_copy(&table);
    Arena arena = {0};
    pens_check(&table, 5);
    json_t *list_of_changes = result_json_list(&copy);
    char *text = json_dumps(list_of_changes, JSON_COMPACT | JSON_REAL_PRECISION(12));
    CHECK_TEXT(text, "[{\"words\":\"Widen doors\",\"settings\":[\"door.d3.width=0.83\",\"door.d4.width=0.9\"],"
                     "\"size\":0.08,\"time\":26.068}]");
    result_clear(&table);
    RulePay pays[] = {{WORK_HINGED_DOOR, PAYS_PAYABLE, "if it slides", "", "", STATUS_SECOND_HAND},
                      {WORK_FURNITURE, PAYS_NOT_LISTED, "", "", "", STATUS_READ}};
    RuleSet set = {.id = "insurance", .pays = pays, .pay_count = 2};
    table = result_suggest_changes(&list, &(RuleSets){.sets = &set, .count = 1});
    pens_check(&table, 6);
    CHECK_TEXT(result_find(&table, 0, "paid.insurance")->text,
               "hinged door: payable, if it slides (read second-hand); furniture: not listed (read)");
    CHECK_TEXT(result_suggest_sentence(&list, &arena), "Smallest changes that let all people out");
    CHECK_TEXT(result_suggest_outcome(&list.list[0], &arena), "all people are out in 26.1 s");
    CHECK_TEXT(result_suggest_tried(&list, &arena), "Houses tried: 18");
    free(text);
    json_decref(list_of_changes);
    arena_clear(&arena);
    result_clear(&table);
    result_clear(&copy);
}

/* Uses a periodic motion, which takes little time. */
TEST(each_fact_of_a_beam_is_on_terminal_and_panel_and_in_json) {
    char path[4096];
    Beam beam = {0};
    Rig rig;
    Response response;
    Fault fault = {0};
    Text text = {0};
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", check_source());
    CHECK(beam_read(&beam, path, (const char *const[]){"drive.frequency=290"}, 1, &fault));
    CHECK(rig_build(&rig, &beam, path, &fault));
    beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
    ResultTable motion = result_beam_motion(&beam, &response), forces = result_beam_forces(&rig, &response);
    json_t *answer = json_object();
    result_json_add(answer, &motion, 0);
    result_json_add(answer, &forces, 0);
    result_text_list(&text, (const ResultTable *const[]){&motion, &forces}, 2);
    pens_check_facts(&motion, 6, text.text, answer, NULL);
    pens_check_facts(&forces, 10, text.text, answer, NULL);
    CHECK_NEAR(result_find(&forces, 0, "peaks.max")->number, 1032, 2);
    json_decref(answer);
    memory_free(text.text);
    result_clear(&motion);
    result_clear(&forces);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

TEST(each_fact_of_a_person_who_is_out_is_on_terminal_and_panel_in_json_and_report) {
    check_house("corner-1.00-1.00", 12);
}

TEST(each_fact_of_a_person_who_cannot_pass_is_on_terminal_and_panel_in_json_and_report) {
    check_house("flat-0.910-module", 7);
}

TEST(each_fact_of_a_person_among_others_is_on_terminal_and_panel_in_json_and_report) {
    check_house("two-chairs-corridor", 12);
}

TEST(the_difference_of_two_times_is_that_of_their_shown_digits) {
    CHECK_NEAR(headline_difference(15.651, 18.249), 2.5, 1e-9); /* 15.7 s and 18.2 s */
    CHECK_NEAR(headline_difference(98.26, 104.4), 5.7, 1e-9);   /* 98.3 s and 1:44 */
    CHECK_NEAR(headline_difference(20.04, 19.96), 0, 1e-9);
}
