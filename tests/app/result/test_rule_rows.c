/* Tests the words of an inspection: the headline, and that what was not read at its source is quiet. */

#include "result/rules.h"

#include <string.h>

#include "case.h"
#include "check.h"
#include "scratch.h"

static Inspection inspect(House *house, RuleSets *sets, const char *name) {
    Fault fault = {0};
    *sets = (RuleSets){0};
    CHECK(rule_set_read_all(sets, scratch_source("assets/rules"), NULL, &fault));
    check_say(&fault);
    case_house(house, name, -1, NULL);
    return inspection_make(house, sets, 1, NULL);
}

static void clear(House *house, RuleSets *sets, Inspection *inspection) {
    inspection_free(inspection);
    house_free(house);
    rule_set_free_all(sets);
}

TEST(the_shipped_corridor_of_0_78_m_is_called_legal_and_impassable) {
    House house;
    RuleSets sets;
    Arena arena = {0};
    Inspection inspection = inspect(&house, &sets, "corner-0.78-0.78");
    const char *sentence = result_rules_sentence(&inspection, &arena);
    if (!strstr(sentence,
                "Legal and impassable: corridor c1 (second leg) has 0.780 m of 0.780 m (jp-senior-housing-1414, "))
        CHECK_TEXT(
            sentence,
            "Legal and impassable: corridor c1 (second leg) has 0.780 m of 0.780 m (jp-senior-housing-1414, ...");
    ResultTable stops = result_rules_stops(&inspection);
    CHECK(stops.record_count == 1 && strcmp(result_find(&stops, 0, "who")->text, "p1") == 0);
    result_clear(&stops);
    arena_clear(&arena);
    clear(&house, &sets, &inspection);
}

TEST(an_interrupted_inspection_has_no_numbers) {
    House house;
    RuleSets sets;
    Stop stop = {1};
    Inspection whole = inspect(&house, &sets, "corner-0.78-0.78");
    Inspection inspection = inspection_make(&house, &sets, 1, &stop);
    inspection.places[0].stopped = 1; /* as if another thread had found a chair that is stopped */
    ResultTable stops = result_rules_stops(&inspection), counts = result_rules_sets(&inspection, &sets);
    CHECK(inspection.interrupted && !inspection.finding_count && stops.record_count == 0);
    CHECK(counts.record_count == sets.count && !whole.interrupted);
    for (size_t s = 0; s < counts.record_count; s++)
        CHECK(result_find(&counts, s, "pass")->omitted && result_find(&counts, s, "fail")->omitted);
    result_clear(&stops);
    result_clear(&counts);
    counts = result_rules_sets(&whole, &sets);
    CHECK(!result_find(&counts, 0, "pass")->omitted);
    result_clear(&counts);
    inspection_free(&whole);
    clear(&house, &sets, &inspection);
}

TEST(a_wide_corner_is_not_called_so) {
    House house;
    RuleSets sets;
    Arena arena = {0};
    Inspection inspection = inspect(&house, &sets, "corner-1.80-1.80");
    CHECK(!strstr(result_rules_sentence(&inspection, &arena), "impassable"));
    CHECK(!inspection.counts[RULE_FAILS] && inspection.counts[RULE_PASSES] > 0);
    arena_clear(&arena);
    clear(&house, &sets, &inspection);
}

TEST(what_was_not_read_at_its_source_is_quiet_and_says_its_word) {
    static const char *const keys[] = {"clause", "status", "requires"};
    House house;
    RuleSets sets;
    Inspection inspection = inspect(&house, &sets, "flat-0.910-module");
    ResultTable table = result_rules_all(&inspection);
    size_t known = 0;
    CHECK(table.record_count == inspection.finding_count);
    for (size_t i = 0; i < table.record_count; i++) {
        int status = inspection.findings[i].status;
        known += status == STATUS_KNOWN;
        for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
            CHECK((result_find(&table, i, keys[k])->role == ROLE_DIM_TEXT) == (status != STATUS_READ));
        CHECK_TEXT(result_find(&table, i, "status")->text, rule_set_status_name(status));
    }
    CHECK(known > 0);
    result_clear(&table);
    clear(&house, &sets, &inspection);
}

TEST(what_the_plan_does_not_hold_is_never_a_pass) {
    House house;
    RuleSets sets;
    Inspection inspection = inspect(&house, &sets, "ube-techno-house");
    size_t steps = 0;
    for (size_t i = 0; i < inspection.finding_count; i++) {
        const Finding *finding = &inspection.findings[i];
        bool step = finding->rule->what == RULE_STEP_HEIGHT || finding->rule->what == RULE_SLOPE;
        steps += step;
        CHECK(!step || (finding->verdict == RULE_OPEN && strcmp(finding->why, "not in the plan") == 0));
    }
    CHECK(steps > 0);
    clear(&house, &sets, &inspection);
}
