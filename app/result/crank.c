#include "result/crank.h"

#include "base/text.h"
#include "result/survival.h"

static void add_number(ResultTable *table, const char *key, const char *label, double number, const char *unit,
                       int significant, bool unknown) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = number,
                                  .unit = unit,
                                  .significant = significant,
                                  .unknown = unknown});
}

ResultTable result_crank_motion(const Crank *crank, const Response *response) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const ChaosExponent *exponent = &response->exponent;
    bool periodic = response->orbit.period > 0, known = isfinite(exponent->value);
    const char *words =
        known ? text_in_arena(&table.arena, "%+.3f \u00b1 %.3f", exponent->value, exponent->error) : NULL;
    result_add(&table, (ResultRow){.key = "frequency",
                                   .label = "speed of the crank",
                                   .kind = RESULT_NUMBER,
                                   .number = crank->frequency,
                                   .text = text_in_arena(&table.arena, "%.4g rpm = %.4g", 60 * crank->frequency,
                                                         crank->frequency),
                                   .unit = "Hz"});
    result_add(&table, (ResultRow){.key = "clearance",
                                   .label = "clearance, radial",
                                   .kind = RESULT_NUMBER,
                                   .number = crank->clearance,
                                   .factor = 1000,
                                   .unit = "mm",
                                   .significant = 4});
    result_add(&table, (ResultRow){.key = "verdict", .label = "response", .text = response_name(response)});
    result_add(&table, (ResultRow){.key = "quick",
                                   .label = "quick verdict",
                                   .kind = RESULT_FLAG,
                                   .number = response_is_quick(response)});
    result_add(&table, (ResultRow){.key = "period",
                                   .label = "period in revolutions",
                                   .kind = RESULT_COUNT,
                                   .number = (double)response->orbit.period,
                                   .unknown = !response->orbit.period});
    result_add(&table, (ResultRow){.key = "settled",
                                   .label = "settled",
                                   .kind = RESULT_FLAG,
                                   .number = response->settled,
                                   .unknown = !periodic});
    result_add(&table, (ResultRow){.key = "lyapunov",
                                   .label = "largest exponent per revolution",
                                   .kind = RESULT_NUMBER,
                                   .number = exponent->value,
                                   .text = words});
    result_add(&table, (ResultRow){.key = "lyapunov_error", .kind = RESULT_NUMBER, .number = exponent->error});
    result_add(&table, (ResultRow){.key = "zero_one",
                                   .label = "K of the 0-1 test",
                                   .kind = RESULT_NUMBER,
                                   .number = response->zero_one,
                                   .decimals = 3});
    result_survival_add(&table, response, "revolution");
    result_add(&table, (ResultRow){.key = "cycles",
                                   .label = "revolutions analysed",
                                   .kind = RESULT_COUNT,
                                   .number = (double)response->cycles});
    result_end(&table);
    return table;
}

ResultTable result_crank_forces(const Tree *tree, const Response *response, double ideal) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    const SectionPeaks *peaks = &response->peaks;
    bool periodic = response->orbit.period > 0, touches = peaks->count > 0;
    result_add(&table, (ResultRow){.key = "multiplier",
                                   .label = "largest multiplier",
                                   .kind = RESULT_NUMBER,
                                   .number = periodic ? response->orbit.largest : NAN,
                                   .decimals = 3});
    add_number(&table, "peaks.min", "smallest peak", peaks->min, "N", 4, !touches);
    add_number(&table, "peaks.max", "largest peak", peaks->max, "N", 4, !touches);
    add_number(&table, "peaks.mean", "mean peak", peaks->mean, "N", 4, !touches);
    result_add(
        &table,
        (ResultRow){.key = "peaks.count", .label = "peaks", .kind = RESULT_COUNT, .number = (double)peaks->count});
    add_number(&table, "ideal_force", "largest force without clearance", ideal, "N", 4, !isfinite(ideal));
    result_add(&table, (ResultRow){.key = "switches",
                                   .label = "switches per revolution",
                                   .kind = RESULT_NUMBER,
                                   .number = response->switches,
                                   .decimals = 2,
                                   .unknown = !touches});
    result_add(&table, (ResultRow){.key = "contact_share",
                                   .label = "time in contact",
                                   .kind = RESULT_NUMBER,
                                   .number = response->contact_share,
                                   .unit = "%",
                                   .factor = 100,
                                   .decimals = 1,
                                   .unknown = !touches});
    double bending = tree->bending ? tree_bending_frequency(tree, 0) : NAN;
    add_number(&table, "bending_frequency", "first bending of the coupler", bending, "Hz", 4, !tree->bending);
    double *supports = arena_allocate(&table.arena, 3 * sizeof *supports);
    for (size_t i = 0; i < 3; i++)
        supports[i] = tree_support_frequency(tree, i);
    result_add(&table, (ResultRow){.key = "support_frequencies",
                                   .label = "supports, x, y and z",
                                   .kind = RESULT_LIST,
                                   .list = supports,
                                   .count = 3,
                                   .unit = "Hz",
                                   .decimals = 1});
    result_end(&table);
    return table;
}
