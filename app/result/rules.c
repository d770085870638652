#include "result/rules.h"

#include <math.h>
#include <stdint.h>

#include "base/text.h"
#include "inquiry/grade.h"

const char *result_rules_verdict(const Finding *finding, Arena *arena) {
    double lacks = finding->requires - finding->has;
    if (finding->verdict == RULE_OPEN)
        return "cannot be told";
    if (finding->verdict == RULE_PASSES)
        return "pass";
    return finding->at_most ? text_in_arena(arena, "fails by %.1f m", -lacks)
                            : text_in_arena(arena, "fails by %.0f mm", 1000 * lacks);
}

/* Returns "0.850 m of 0.900 m", or "18.0 m of way without a place for turning, of at most 15 m". */
static const char *dimension_words(const Finding *finding, Arena *arena) {
    return finding->at_most ? text_in_arena(arena, "%.1f m of way without a place for turning, of at most %g m",
                                            finding->has, finding->requires)
                            : text_in_arena(arena, "%.3f m of %.3f m", finding->has, finding->requires);
}

/* Returns "pass", "fail" or "unknown", for scripts. */
static const char *verdict_word(int verdict) {
    static const char *const words[RULE_VERDICTS] = {"pass", "fail", "unknown"};
    return words[verdict];
}

static const char *place_name(const Inspection *inspection, const Finding *finding) {
    return finding->place == SIZE_MAX ? "the house" : inspection->places[finding->place].name;
}

/* Returns "0 of 1 get through", "1 of 1", or NULL where no chair comes. */
static const char *chairs_words(const RulePlace *place, Arena *arena) {
    if (!place || !place->chairs)
        return NULL;
    return text_in_arena(arena, "%zu of %zu", place->chairs - place->stopped, place->chairs);
}

/* Sentences ---------------------------------------------------------------------------------------------------------
 */

const char *result_rules_counts(const Inspection *inspection, Arena *arena) {
    const size_t *counts = inspection->counts;
    return text_in_arena(arena, "%zu checks: %zu pass, %zu fail, %zu cannot be told", inspection->finding_count,
                         counts[RULE_PASSES], counts[RULE_FAILS], counts[RULE_OPEN]);
}

static const Finding *worst_failure(const Inspection *inspection) {
    const Finding *worst = NULL;
    for (size_t i = 0; i < inspection->finding_count; i++) {
        const Finding *finding = &inspection->findings[i];
        bool worse = !worst || worst->at_most > finding->at_most ||
                     (worst->at_most == finding->at_most &&
                      fabs(finding->requires - finding->has) > fabs(worst->requires - worst->has));
        if (finding->verdict == RULE_FAILS && worse)
            worst = finding;
    }
    return worst;
}

/* Returns "31 of 100 drivers of whm get through", or NULL if no drivers were tried. */
static const char *drivers_words(const Inspection *inspection, const RulePlace *place, Arena *arena) {
    if (!inspection->population || !place || !place->drivers)
        return NULL;
    return text_in_arena(arena, "%zu of %zu drivers of %s get through", place->drivers - place->refused, place->drivers,
                         inspection->population);
}

static const char *legal_impassable(const Inspection *inspection, const Finding *finding, Arena *arena) {
    const RulePlace *place = &inspection->places[finding->place];
    const char *drivers = drivers_words(inspection, place, arena);
    const char *helped =
        place->carried == place->stopped ? "only a helper could lift and shift it through" : "it does not even fit";
    const char *grey =
        finding->status == STATUS_READ ? "" : text_in_arena(arena, ", %s", rule_set_status_name(finding->status));
    const char *has = text_in_arena(arena, "Legal and impassable: %s has %s (%s, %s%s), and", place->name,
                                    dimension_words(finding, arena), finding->set->id, finding->rule->clause, grey);
    if (!place->stopped)
        return text_in_arena(arena, "%s only %s", has, drivers);
    return text_in_arena(arena, "%s the chair of %s does not get through: %s%s%s", has, place->who, helped,
                         drivers ? "; " : "", drivers ? drivers : "");
}

const char *result_rules_sentence(const Inspection *inspection, Arena *arena) {
    const Finding *legal = inspection_legal_impassable(inspection), *worst = worst_failure(inspection);
    if (inspection->interrupted)
        return "The inspection was interrupted: what is not listed is neither a pass nor a failure";
    if (legal)
        return legal_impassable(inspection, legal, arena);
    const char *open = inspection->counts[RULE_OPEN]
                           ? text_in_arena(arena, "; %zu cannot be told", inspection->counts[RULE_OPEN])
                           : "";
    if (!worst)
        return text_in_arena(arena,
                             inspection->counts[RULE_PASSES] ? "All %zu checks that can be made pass%s"
                                                             : "None of the rules can be checked here%.0zu%s",
                             inspection->counts[RULE_PASSES], open);
    return text_in_arena(
        arena, "%zu of %zu checks fail%s; most is lacking at %s: %s (%s, %s)", inspection->counts[RULE_FAILS],
        inspection->counts[RULE_FAILS] + inspection->counts[RULE_PASSES], open, place_name(inspection, worst),
        dimension_words(worst, arena), worst->set->id, worst->rule->clause);
}

const char *result_rules_title(const Inspection *inspection, Arena *arena) {
    const Finding *legal = inspection_legal_impassable(inspection);
    size_t fails = inspection->counts[RULE_FAILS], passes = inspection->counts[RULE_PASSES];
    if (legal)
        return text_in_arena(arena, "Legal and impassable: %s", place_name(inspection, legal));
    return fails ? text_in_arena(arena, "%zu of %zu checks fail", fails, fails + passes)
                 : text_in_arena(arena, "All %zu checks that can be made pass", passes);
}

static const char *enough_words(const Finding *finding, Arena *arena) {
    return finding->at_most ? text_in_arena(arena, "A place for turning each %.1f m", finding->has)
                            : text_in_arena(arena, "%.3f m", finding->has);
}

const char *result_rules_detail(const Inspection *inspection, Arena *arena) {
    const Finding *legal = inspection_legal_impassable(inspection);
    if (!legal)
        return result_rules_counts(inspection, arena);
    const RulePlace *place = &inspection->places[legal->place];
    if (!place->stopped)
        return text_in_arena(arena, "%s is enough for %s; only %s", enough_words(legal, arena), legal->set->id,
                             drivers_words(inspection, place, arena));
    return text_in_arena(arena, "%s is enough for %s; the chair of %s does not get through", enough_words(legal, arena),
                         legal->set->id, place->who);
}

const char *result_rules_group(FindingGroup group) {
    static const char *const names[] = {
        [GROUP_LEGAL_IMPASSABLE] = "Rules pass, chairs are stopped",
        [GROUP_ILLEGAL_IMPASSABLE] = "Rules fail, chairs are stopped",
        [GROUP_ILLEGAL] = "Rules fail, no chair is stopped",
        [GROUP_GOOD] = "Rules pass, no chair is stopped",
        [GROUP_OPEN] = "Cannot be told",
    };
    return names[group];
}

/* Tables ------------------------------------------------------------------------------------------------------------
 */

static void add_dimension(ResultTable *table, const char *key, const char *label, double number) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = number,
                                  .unit = "m",
                                  .decimals = 3,
                                  .omitted = isnan(number)});
}

static void add_driver_count(ResultTable *table, const char *key, size_t count) {
    result_add(table, (ResultRow){.key = key, .kind = RESULT_COUNT, .number = (double)count});
}

/* Adds what drivers do at a place, and how tight it is; nothing where no driver comes. */
static void add_drivers(ResultTable *table, const RulePlace *place) {
    bool driven = place && place->drivers, graded = place && place->grade >= 0;
    Arena *arena = &table->arena;
    size_t through = driven ? place->drivers - place->refused : 0;
    add_driver_count(table, "drivers.count", driven ? place->drivers : 0);
    add_driver_count(table, "drivers.through", through);
    add_driver_count(table, "drivers.out", driven ? place->out : 0);
    add_driver_count(table, "drivers.touching", driven ? place->touching : 0);
    result_add(table, (ResultRow){.label = "drivers through",
                                  .text = driven ? text_in_arena(arena, "%zu of %zu", through, place->drivers) : NULL});
    result_add(table, (ResultRow){.label = "out", .text = driven ? text_in_arena(arena, "%zu", place->out) : NULL});
    result_add(table, (ResultRow){.label = "touch there",
                                  .text = driven ? text_in_arena(arena, "%zu", place->touching) : NULL});
    result_add(table, (ResultRow){.key = "grade",
                                  .label = "grade",
                                  .text = graded ? grade_letter(place->grade) : NULL,
                                  .omitted = !graded});
    bool lacks = graded && place->grade > GRADE_A && isfinite(place->to_next);
    result_add(table, (ResultRow){.key = "to_next",
                                  .label = "missing to the next",
                                  .kind = RESULT_NUMBER,
                                  .number = lacks ? place->to_next : (double)NAN,
                                  .unit = "cm",
                                  .factor = 100,
                                  .decimals = 1,
                                  .omitted = !lacks});
}

/* Every word but `read` says that the source itself was not read; it is printed in the quiet role. */
static void add_finding(ResultTable *table, const Inspection *inspection, const Finding *finding) {
    const RulePlace *place = finding->place == SIZE_MAX ? NULL : &inspection->places[finding->place];
    Arena *arena = &table->arena;
    result_add(table, (ResultRow){.key = "place", .label = "place", .text = place_name(inspection, finding)});
    result_add(table, (ResultRow){.key = "set", .label = "rules", .text = finding->set->id});
    result_add(table, (ResultRow){.key = "rule", .text = finding->rule->id});
    result_add(table, (ResultRow){.key = "what", .label = "what", .text = rule_set_what_name(finding->rule->what)});
    Role role = finding->status == STATUS_READ ? ROLE_TEXT : ROLE_DIM_TEXT;
    result_add(table, (ResultRow){.key = "clause", .label = "clause", .text = finding->rule->clause, .role = role});
    result_add(
        table,
        (ResultRow){.key = "status", .label = "source", .text = rule_set_status_name(finding->status), .role = role});
    result_add(table, (ResultRow){.key = "source", .text = finding->rule->source});
    add_dimension(table, "requires", "requires", finding->requires);
    table->rows[table->used - 1].role = role;
    add_dimension(table, "has", "has", finding->has);
    if (finding->at_least)
        table->rows[table->used - 1].text = text_in_arena(arena, "%.3f or more", finding->has);
    add_dimension(table, "furnished", "between furniture", finding->furnished);
    result_add(table, (ResultRow){.key = "limit", .text = finding->at_most ? "most" : "least"});
    result_add(table, (ResultRow){.key = "why", .label = "measured", .text = finding->why});
    result_add(table, (ResultRow){.key = "verdict", .text = verdict_word(finding->verdict)});
    result_add(table, (ResultRow){.label = "verdict",
                                  .text = result_rules_verdict(finding, arena),
                                  .role = finding->verdict == RULE_FAILS ? ROLE_ERROR : ROLE_TEXT});
    result_add(table, (ResultRow){.key = "chairs", .kind = RESULT_COUNT, .number = place ? (double)place->chairs : 0});
    result_add(table,
               (ResultRow){.key = "stopped", .kind = RESULT_COUNT, .number = place ? (double)place->stopped : 0});
    result_add(table, (ResultRow){.label = "chairs through", .text = chairs_words(place, arena)});
    if (inspection->population)
        add_drivers(table, place);
    for (int k = 0; k < 4; k++) {
        static const char *const keys[] = {"from.x", "from.y", "to.x", "to.y"};
        const double ends[] = {finding->from.x, finding->from.y, finding->to.x, finding->to.y};
        result_add(table,
                   (ResultRow){.key = keys[k], .kind = RESULT_NUMBER, .number = ends[k], .omitted = !finding->drawn});
    }
    result_end(table);
}

ResultTable result_rules_findings(const Inspection *inspection, FindingGroup group) {
    ResultTable table = {.numbers = RESULT_MICRO};
    for (size_t i = 0; i < inspection->finding_count; i++)
        if (inspection_group(inspection, &inspection->findings[i]) == group)
            add_finding(&table, inspection, &inspection->findings[i]);
    return table;
}

ResultTable result_rules_all(const Inspection *inspection) {
    ResultTable table = {.numbers = RESULT_MICRO};
    for (size_t i = 0; i < inspection->finding_count; i++)
        add_finding(&table, inspection, &inspection->findings[i]);
    return table;
}

ResultTable result_rules_stops(const Inspection *inspection) {
    ResultTable table = {.numbers = RESULT_MICRO};
    for (size_t p = 0; p < inspection->place_count && !inspection->interrupted; p++) {
        const RulePlace *place = &inspection->places[p];
        char widths[ROUTE_WIDTHS];
        if (!place->stopped)
            continue;
        route_widths(&place->blockage, widths, sizeof widths);
        result_add(&table, (ResultRow){.key = "place", .label = "place", .text = place->name});
        result_add(&table, (ResultRow){.key = "chairs",
                                       .label = "chairs that come",
                                       .kind = RESULT_COUNT,
                                       .number = (double)place->chairs});
        result_add(&table, (ResultRow){.key = "stopped",
                                       .label = "stopped",
                                       .kind = RESULT_COUNT,
                                       .number = (double)place->stopped,
                                       .role = ROLE_ERROR});
        result_add(&table, (ResultRow){.key = "carried",
                                       .label = "of them a helper could lift through",
                                       .kind = RESULT_COUNT,
                                       .number = (double)place->carried});
        result_add(&table, (ResultRow){.key = "who", .label = "first", .text = place->who});
        result_add(&table, (ResultRow){.key = "at",
                                       .label = "stopped at",
                                       .text = text_in_arena(&table.arena, "%s", place->blockage.what)});
        result_add(&table, (ResultRow){.label = "its width", .text = text_in_arena(&table.arena, "%s", widths)});
        result_end(&table);
    }
    return table;
}

ResultTable result_rules_sets(const Inspection *inspection, const RuleSets *sets) {
    ResultTable table = {.numbers = RESULT_MICRO};
    for (size_t s = 0; s < sets->count; s++) {
        const RuleSet *set = &sets->sets[s];
        size_t counts[RULE_VERDICTS] = {0};
        for (size_t i = 0; i < inspection->finding_count; i++)
            if (inspection->findings[i].set == set)
                counts[inspection->findings[i].verdict]++;
        result_add(&table, (ResultRow){.key = "id", .label = "rules", .text = set->id});
        result_add(&table, (ResultRow){.key = "title", .label = "title", .text = set->title});
        result_add(&table, (ResultRow){.key = "applies", .label = "for", .text = set->applies});
        result_add(&table, (ResultRow){.key = "edition", .label = "edition", .text = set->edition});
        for (int v = 0; v < RULE_VERDICTS; v++) {
            static const char *const labels[RULE_VERDICTS] = {"pass", "fail", "open"};
            result_add(&table, (ResultRow){.key = verdict_word(v),
                                           .label = labels[v],
                                           .kind = RESULT_COUNT,
                                           .number = (double)counts[v],
                                           .omitted = inspection->interrupted});
        }
        result_add(&table, (ResultRow){.key = "note", .text = set->note});
        result_end(&table);
    }
    return table;
}
