#include "result/beam_survival.h"

#include <math.h>

/* Rows --------------------------------------------------------------------------------------------------------------
 */

static void add_number(ResultTable *table, const char *key, const char *label, double number, const char *unit) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = isfinite(number) ? number : NAN,
                                  .unit = unit,
                                  .significant = 4});
}

static void add_count(ResultTable *table, const char *key, const char *label, size_t count, bool unknown) {
    result_add(table,
               (ResultRow){.key = key, .label = label, .kind = RESULT_COUNT, .number = unknown ? NAN : (double)count});
}

static void add_attractors(ResultTable *table, const Survival *survival) {
    const char **texts = arena_allocate(&table->arena, (survival->attractor_count + 1) * sizeof *texts);
    Text all = {0};
    for (size_t i = 0; i < survival->attractor_count; i++) {
        const SurvivalAttractor *one = &survival->attractors[i];
        texts[i] = text_in_arena(&table->arena, "period %zu, %.2f N: %zu of %zu", one->period, one->peak, one->lanes,
                                 survival->lanes);
        text_format(&all, "%s%s", i ? "; " : "", texts[i]);
    }
    result_add(table, (ResultRow){.key = "survival.attractors",
                                  .label = "settles into",
                                  .kind = RESULT_TEXTS,
                                  .texts = texts,
                                  .count = survival->attractor_count,
                                  .text = all.text ? arena_text(&table->arena, all.text) : "-"});
    memory_free(all.text);
}

static void add_survival(ResultTable *table, const Survival *survival) {
    const HalfLife *half = &survival->half_life;
    add_count(table, "survival.lanes", "motions watched", survival->lanes, false);
    add_count(table, "survival.cycles", "cycles of each", survival->cycles, false);
    add_count(table, "survival.settled", "of these settled", survival->settled, false);
    add_attractors(table, survival);
    add_number(table, "survival.half_life", "half-life in cycles", half->value, NULL);
    add_number(table, "survival.half_life_low", "half-life, at least", half->low, NULL);
    add_number(table, "survival.half_life_high", "half-life, at most", half->high, NULL);
    add_number(table, "survival.largest", "largest peak of all", survival->largest, "N");
    add_number(table, "survival.cycles_to_95", "cycles to 95 % of it", survival->within[0].median, NULL);
    add_number(table, "survival.cycles_to_95_most", "of 95 % of the motions", survival->within[0].most, NULL);
    add_number(table, "survival.cycles_to_99", "cycles to 99 % of it", survival->within[1].median, NULL);
    add_number(table, "survival.cycles_to_99_most", "of 95 % of the motions", survival->within[1].most, NULL);
    const Extreme *extreme = &survival->extreme;
    add_number(table, "survival.million", "largest in a million cycles", extreme->known ? extreme->level : NAN, "N");
    add_number(table, "survival.million_low", "at least", extreme->known ? extreme->low : NAN, "N");
    add_number(table, "survival.million_high", "at most", extreme->known ? extreme->high : NAN, "N");
}

void result_beam_survival_add(ResultTable *table, const Response *response) {
    add_count(table, "zero_one_step", "K of every so many cycles", response->zero_one_step, isnan(response->zero_one));
    result_add(table, (ResultRow){.key = "rotation",
                                  .label = "rotation number",
                                  .kind = RESULT_NUMBER,
                                  .number = response->rotation.value,
                                  .decimals = 6});
    result_add(table, (ResultRow){.key = "rotation_error", .kind = RESULT_NUMBER, .number = response->rotation.error});
    result_add(table, (ResultRow){.key = "second_exponent",
                                  .label = "second exponent per cycle",
                                  .kind = RESULT_NUMBER,
                                  .number = response->second.value,
                                  .decimals = 3});
    add_count(table, "bands", "bands", response->bands, !response->bands);
    if (response->survival.lanes)
        add_survival(table, &response->survival);
}

/* Words -------------------------------------------------------------------------------------------------------------
 */

void result_beam_survival_name(Text *text, const Response *response) {
    const char *many = response->bands > 1 ? "s that are visited in turn" : "";
    switch (response->verdict) {
    case RESPONSE_PERIODIC:
        if (!response->peaks.count)
            text_add(text, "Without contact");
        else
            text_format(text, "Periodic, period %zu", response->orbit.period);
        break;
    case RESPONSE_QUASI_PERIODIC:
        text_add(text, "Quasi-periodic");
        if (response->bands > 1)
            text_format(text, " on %zu closed curve%s", response->bands, many);
        if (isfinite(response->rotation.value))
            text_format(text, ", rotation number %.6f \u00b1 %.0e", response->rotation.value, response->rotation.error);
        break;
    case RESPONSE_CHAOTIC:
        text_add(text, "Chaotic");
        if (response->bands > 1)
            text_format(text, " in %zu band%s", response->bands, many);
        break;
    case RESPONSE_TRANSIENT:
        text_add(text, "Transient");
        if (response->survival.attractor_count)
            text_format(text, ", settles into period %zu with %.2f N", response->survival.attractors[0].period,
                        response->survival.attractors[0].peak);
        else
            text_format(text, ", has settled into period %zu", response->orbit.period);
        break;
    case RESPONSE_UNDETERMINED:
        text_format(text, "Undetermined after %zu cycles", response->cycles);
        break;
    case RESPONSE_CHATTERS:
        text_format(text, "Chatter, too many switches in one cycle to follow, after %zu cycles", response->cycles);
        break;
    case RESPONSE_DIVERGED:
        text_format(text, "The numbers diverged after %zu cycles", response->cycles);
        break;
    case RESPONSE_INTERRUPTED:
        text_format(text, "Interrupted before a verdict, after %zu recorded cycles", response->section.count);
        break;
    }
    if (response_is_quick(response))
        text_add(text, " (quick verdict)");
}

static void say_tried(Text *text, const Response *response) {
    if (response->verdict != RESPONSE_UNDETERMINED)
        return;
    text_format(
        text,
        "Tried: orbits of up to %d cycles near the motion, the largest exponent (%+.4f \u00b1 %.4f a cycle) and K "
        "of the 0-1 test (%.2f at most, of every cycle to every 8th)\n",
        ORBIT_PERIOD_MOST, response->exponent.value, response->exponent.error, response->zero_one);
    if (response->exponent.value < 0)
        text_add(text, "It shrinks: a larger run.transient_cycles lets it settle\n");
}

static void say_lasting(Text *text, const Survival *survival) {
    const HalfLife *half = &survival->half_life;
    if (!survival->settled) {
        text_format(text, "It lasted for %zu x %zu cycles: none of %zu motions that were started on it settled; ",
                    survival->lanes, survival->cycles, survival->lanes);
        text_format(text, "a half-life, if there is one, is above %.0f cycles (95 %%)\n", half->low);
        return;
    }
    text_format(text, "%zu of %zu motions that were started on it settled within %zu cycles: ", survival->settled,
                survival->lanes, survival->cycles);
    for (size_t i = 0; i < survival->attractor_count; i++) {
        const SurvivalAttractor *one = &survival->attractors[i];
        text_format(text, "%s%zu into period %zu, %.2f N", i ? ", " : "", one->lanes, one->period, one->peak);
    }
    if (isfinite(half->value))
        text_format(text, "; half-life %.0f cycles (95 %%: %.0f to %.0f)\n", half->value, half->low, half->high);
    else
        text_format(text, "; the half-life is too short to tell\n");
}

static void say_wait(Text *text, const SurvivalWait *wait, const char *share) {
    if (isfinite(wait->median))
        text_format(text, "; %s of it takes %.0f cycles in the median", share, wait->median);
    if (isfinite(wait->median) && isfinite(wait->most))
        text_format(text, " and %.0f in 95 %% of the motions", wait->most);
}

static void say_peaks(Text *text, const Survival *survival) {
    const Extreme *extreme = &survival->extreme;
    if (survival->largest <= 0)
        return;
    text_format(text, "The largest peak of all these motions is %.1f N", survival->largest);
    say_wait(text, &survival->within[0], "95 %");
    say_wait(text, &survival->within[1], "99 %");
    text_add(text, "\n");
    if (extreme->known)
        text_format(text, "The largest in a million cycles, extrapolated, is %.0f N (95 %%: %.0f to %.0f)\n",
                    extreme->level, extreme->low, extreme->high);
}

void result_beam_survival_say(Text *text, const Response *response) {
    say_tried(text, response);
    if (!response->survival.lanes)
        return;
    say_lasting(text, &response->survival);
    say_peaks(text, &response->survival);
}
