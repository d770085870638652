#include "result/fit.h"

#include "base/text.h"

#define CORRELATED 0.9 /* 1, from which on two parameters need each other */
#define POOR 3.0 /* 1, of the sum of squares by the number of values, from which on the model does not explain them */
#define FEW 40   /* effective samples, below which an interval is rough */
#define ODD_SIGNS 1.96 /* 1, deviation of the number of runs of signs that is no chance */

static size_t told(const Fit *fit) {
    size_t count = 0;
    for (size_t i = 0; i < fit->unknown_count; i++)
        count += fit->unknowns[i].told;
    return count;
}

const char *result_fit_sentence(const Fit *fit, Arena *arena) {
    size_t known = told(fit), all = fit->unknown_count;
    if (fit->interrupted)
        return "The fit was interrupted: there is no result";
    if (!known)
        return text_in_arena(arena, "The data do not tell any of the %zu parameters: all keep what was known before",
                             all);
    return text_in_arena(arena,
                         known < all ? "%zu of %zu parameters are told by %zu measured values; the others keep "
                                       "what was known before"
                                     : "%zu of %zu parameters are told by %zu measured values",
                         known, all, fit->row_count);
}

const char **result_fit_remarks(const Fit *fit, size_t *count, Arena *arena) {
    const char **remarks = arena_allocate(arena, (FIT_UNKNOWNS_MOST * FIT_UNKNOWNS_MOST + 4) * sizeof *remarks);
    *count = 0;
    for (size_t i = 0; i < fit->unknown_count; i++)
        for (size_t j = 0; j < i; j++) {
            double correlation = fit_correlation(fit, i, j);
            if (correlation > CORRELATED || correlation < -CORRELATED)
                remarks[(*count)++] =
                    text_in_arena(arena, "%s and %s cannot be told apart by these data: correlation %.2f",
                                  fit->unknowns[j].name, fit->unknowns[i].name, correlation);
        }
    if (fit->sum > POOR * (double)fit->row_count)
        remarks[(*count)++] = text_in_arena(arena,
                                            "the residuals are %.1f times as large as the measurements scatter: the "
                                            "model does not explain the data, and the intervals are too narrow",
                                            sqrt(fit->sum / (double)fit->row_count));
    if (fit->jumps && !fit->interrupted && fit->effective < FEW)
        remarks[(*count)++] = text_in_arena(arena,
                                            "the intervals rest on %.0f effective samples only: fit fewer parameters, "
                                            "or give narrower priors",
                                            fit->effective);
    if (fit->basins > 1)
        remarks[(*count)++] = text_in_arena(
            arena, "%zu separate sets of values explain the data about as well; the best one is given", fit->basins);
    if (fit->leave_out && !fit->interrupted)
        remarks[(*count)++] = text_in_arena(arena,
                                            "predicted from the others alone, a value is off by %.2f of its standard "
                                            "deviation (root mean square); before the fit by %.2f",
                                            fit->error, fit->error_before);
    if (fit->sign_runs < -ODD_SIGNS) /* more runs than by chance come from the order of repeated measurements */
        remarks[(*count)++] = text_in_arena(
            arena,
            "equal signs of the residuals follow each other more often than by chance (%.1f standard deviations): the "
            "model lacks something",
            -fit->sign_runs);
    return remarks;
}

static void add_number(ResultTable *table, const char *key, const char *label, double number, int significant) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = number,
                                  .significant = significant,
                                  .omitted = isnan(number)});
}

static const char *told_words(const FitUnknown *unknown) {
    return !unknown->told ? "the data do not tell" : unknown->skew ? "told, interval by profile" : "told";
}

ResultTable result_fit_unknowns(const Fit *fit, const Experiment *experiment) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t i = 0; i < fit->unknown_count; i++) {
        const FitUnknown *unknown = &fit->unknowns[i];
        const Parameter *row = experiment->parameter(experiment->given, unknown->name);
        result_add(&table, (ResultRow){.key = "name", .label = "parameter", .text = unknown->name});
        result_add(&table, (ResultRow){.key = "unit", .label = "unit", .text = row ? parameters_unit(row) : ""});
        add_number(&table, "prior", "before", unknown->prior, 4);
        add_number(&table, "spread", "spread before", unknown->spread, 2);
        add_number(&table, "best", "best", unknown->best, 4);
        add_number(&table, "low", "90 % from", unknown->low, 4);
        add_number(&table, "high", "to", unknown->high, 4);
        add_number(&table, "low_95", "95 % from", unknown->least, 4);
        add_number(&table, "high_95", "to", unknown->most, 4);
        add_number(&table, "deviation", "spread after", unknown->deviation, 2);
        add_number(&table, "learned", "learned", unknown->learned, 2);
        result_add(&table, (ResultRow){.key = "told", .kind = RESULT_FLAG, .number = unknown->told, .label = NULL});
        result_add(&table, (ResultRow){.label = "answer",
                                       .text = told_words(unknown),
                                       .role = unknown->told ? ROLE_TEXT : ROLE_DIM_TEXT});
        add_number(&table, "value", "to be used", unknown->value, 4);
        result_end(&table);
    }
    return table;
}

ResultTable result_fit_rows(const Fit *fit) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    for (size_t r = 0; r < fit->row_count; r++) {
        const FitRow *row = &fit->rows[r];
        const Observable *observable = &row->experiment->observables[row->observable];
        result_add(&table, (ResultRow){.key = "label", .label = "measured", .text = row->label});
        result_add(&table, (ResultRow){.key = "observable", .label = "quantity", .text = observable->name});
        result_add(&table, (ResultRow){.key = "unit", .label = "unit", .text = observable->unit});
        add_number(&table, "observed", "observed", row->observed, 4);
        result_add(&table, (ResultRow){.key = "relative", .kind = RESULT_FLAG, .number = row->relative});
        add_number(&table, "deviation", NULL, row->deviation, 3);
        add_number(&table, "before", "before", row->before, 4);
        add_number(&table, "simulated", "fitted", row->simulated, 4);
        add_number(&table, "residual", "residual", row->residual, 2);
        add_number(&table, "left_out", "left out", row->left_out, 4);
        result_end(&table);
    }
    return table;
}

ResultTable result_fit_whole(const Fit *fit) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    add_number(&table, "sum_before", "sum of squares before", fit->sum_before, 4);
    add_number(&table, "sum", "sum of squares, fitted", fit->sum, 4);
    result_add(&table, (ResultRow){.key = "singular_values",
                                   .label = "singular values",
                                   .kind = RESULT_LIST,
                                   .list = fit->singular,
                                   .count = fit->unknown_count,
                                   .significant = 3});
    result_add(&table, (ResultRow){.key = "minima",
                                   .label = "minima",
                                   .kind = RESULT_COUNT,
                                   .number = (double)fit->basins,
                                   .omitted = fit->jumps});
    if (fit->jumps)
        add_number(&table, "effective_samples", "effective samples", fit->effective, 3);
    result_add(&table,
               (ResultRow){.key = "runs", .label = "simulations", .kind = RESULT_COUNT, .number = (double)fit->runs});
    add_number(&table, "sign_runs", NULL, fit->sign_runs, 3);
    add_number(&table, "left_out_error", NULL, fit->leave_out ? fit->error : (double)NAN, 3);
    add_number(&table, "left_out_error_before", NULL, fit->leave_out ? fit->error_before : (double)NAN, 3);
    result_end(&table);
    return table;
}
