#include "result/verdict.h"

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

static void add_survival(ResultTable *table, const Survival *survival, const char *cycle) {
    Arena *arena = &table->arena;
    const HalfLife *half = &survival->half_life;
    add_count(table, "survival.lanes", "motions watched", survival->lanes, false);
    add_count(table, "survival.cycles", text_in_arena(arena, "%ss of each", cycle), survival->cycles, false);
    add_count(table, "survival.settled", "of these settled", survival->settled, false);
    add_attractors(table, survival);
    add_number(table, "survival.half_life", text_in_arena(arena, "half-life in %ss", cycle), half->value, NULL);
    add_number(table, "survival.half_life_low", "half-life, at least", half->low, NULL);
    add_number(table, "survival.half_life_high", "half-life, at most", half->high, NULL);
    add_number(table, "survival.largest", "largest peak of all", survival->largest, "N");
    add_number(table, "survival.cycles_to_95", text_in_arena(arena, "%ss to 95 %% of it", cycle),
               survival->within[0].median, NULL);
    add_number(table, "survival.cycles_to_95_most", "of 95 % of the motions", survival->within[0].most, NULL);
    add_number(table, "survival.cycles_to_99", text_in_arena(arena, "%ss to 99 %% of it", cycle),
               survival->within[1].median, NULL);
    add_number(table, "survival.cycles_to_99_most", "of 95 % of the motions", survival->within[1].most, NULL);
    const Extreme *extreme = &survival->extreme;
    add_number(table, "survival.million", text_in_arena(arena, "largest in a million %ss", cycle),
               extreme->known ? extreme->level : NAN, "N");
    add_number(table, "survival.million_low", "at least", extreme->known ? extreme->low : NAN, "N");
    add_number(table, "survival.million_high", "at most", extreme->known ? extreme->high : NAN, "N");
}

/* Adds the shape of the motion and the results of the watched ones. */
static void add_shape(ResultTable *table, const Response *response, const char *cycle) {
    add_count(table, "zero_one_step", text_in_arena(&table->arena, "K of every so many %ss", cycle),
              response->zero_one_step, isnan(response->zero_one));
    result_add(table, (ResultRow){.key = "rotation",
                                  .label = "rotation number",
                                  .kind = RESULT_NUMBER,
                                  .number = response->rotation.value,
                                  .decimals = 6});
    result_add(table, (ResultRow){.key = "rotation_error", .kind = RESULT_NUMBER, .number = response->rotation.error});
    result_add(table, (ResultRow){.key = "second_exponent",
                                  .label = text_in_arena(&table->arena, "second exponent per %s", cycle),
                                  .kind = RESULT_NUMBER,
                                  .number = response->second.value,
                                  .decimals = 3});
    add_count(table, "bands", "bands", response->bands, !response->bands);
    if (response->survival.lanes)
        add_survival(table, &response->survival, cycle);
}

void result_verdict_add(ResultTable *table, const Response *response, const char *cycle) {
    Arena *arena = &table->arena;
    const ChaosExponent *exponent = &response->exponent;
    bool periodic = response->orbit.period > 0, known = isfinite(exponent->value),
         interrupted = response->verdict == RESPONSE_INTERRUPTED;
    const char *words = known ? text_in_arena(arena, "%+.3f \u00b1 %.3f", exponent->value, exponent->error) : NULL;
    result_add(table, (ResultRow){.key = "verdict", .label = "response", .text = response_name(response)});
    result_add(table, (ResultRow){.key = "quick",
                                  .label = "quick verdict",
                                  .kind = RESULT_FLAG,
                                  .number = response_is_quick(response),
                                  .omitted = interrupted});
    result_add(table, (ResultRow){.key = "period",
                                  .label = text_in_arena(arena, "period in %ss", cycle),
                                  .kind = RESULT_COUNT,
                                  .number = interrupted ? (double)NAN : (double)response->orbit.period,
                                  .unknown = !periodic});
    result_add(table, (ResultRow){.key = "settled",
                                  .label = "settled",
                                  .kind = RESULT_FLAG,
                                  .number = response->settled,
                                  .unknown = !periodic,
                                  .omitted = interrupted});
    result_add(table, (ResultRow){.key = "lyapunov",
                                  .label = text_in_arena(arena, "largest exponent per %s", cycle),
                                  .kind = RESULT_NUMBER,
                                  .number = exponent->value,
                                  .text = words});
    result_add(table, (ResultRow){.key = "lyapunov_error", .kind = RESULT_NUMBER, .number = exponent->error});
    result_add(table, (ResultRow){.key = "zero_one",
                                  .label = "K of the 0-1 test",
                                  .kind = RESULT_NUMBER,
                                  .number = response->zero_one,
                                  .decimals = 3});
    add_shape(table, response, cycle);
    add_count(table, "cycles", text_in_arena(arena, "%ss analysed", cycle), response->cycles, false);
}

/* Adds a peak of the recorded cycles, which is none if there are none. */
static void add_peak(ResultTable *table, const char *key, const char *label, double peak, const Response *response) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = response->section.count ? peak : (double)NAN,
                                  .unit = "N",
                                  .significant = 4,
                                  .unknown = !response->peaks.count});
}

void result_verdict_add_peaks(ResultTable *table, const Response *response) {
    const SectionPeaks *peaks = &response->peaks;
    result_add(table, (ResultRow){.key = "multiplier",
                                  .label = "largest multiplier",
                                  .kind = RESULT_NUMBER,
                                  .number = response->orbit.period ? response->orbit.largest : NAN,
                                  .decimals = 3});
    add_peak(table, "peaks.min", "smallest peak", peaks->min, response);
    add_peak(table, "peaks.max", "largest peak", peaks->max, response);
    add_peak(table, "peaks.mean", "mean peak", peaks->mean, response);
    add_count(table, "peaks.count", "peaks", peaks->count, false);
}

/* Words -------------------------------------------------------------------------------------------------------------
 */

void result_verdict_name(Text *text, const Response *response, const char *cycle) {
    const char *many = response->bands > 1 ? "s that are visited in turn" : "";
    switch (response->verdict) {
    case RESPONSE_PERIODIC:
        if (!response->peaks.count)
            text_add(text, "Without contact");
        else
            text_format(text, "Periodic, period %zu", response->orbit.period);
        if (response->orbit.period > ORBIT_PERIOD_MOST)
            text_add(text, ", probably a locked torus");
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
        text_format(text, "Undetermined after %zu %ss", response->cycles, cycle);
        break;
    case RESPONSE_CHATTERS:
        text_format(text, "Chatter, too many switches in one %s to follow, after %zu %ss", cycle, response->cycles,
                    cycle);
        break;
    case RESPONSE_DIVERGED:
        text_format(text, "The numbers diverged after %zu %ss", response->cycles, cycle);
        break;
    case RESPONSE_STIFF:
        text_format(text, "Too stiff to follow, after %zu %ss", response->cycles, cycle);
        break;
    case RESPONSE_INTERRUPTED:
        text_format(text, "Interrupted before a verdict, after %zu recorded %ss", response->section.count, cycle);
        break;
    }
    if (response_is_quick(response))
        text_add(text, " (quick verdict)");
}

static void say_tried(Text *text, const Response *response, const char *cycle) {
    if (response->verdict != RESPONSE_UNDETERMINED)
        return;
    text_format(
        text,
        "Tried: orbits of up to %d %ss near the motion, the largest exponent (%+.4f \u00b1 %.4f a %s) and K of the 0-1 "
        "test (%.2f at most, of every %s to every 8th)\n",
        ORBIT_PERIOD_MOST, cycle, response->exponent.value, response->exponent.error, cycle, response->zero_one, cycle);
    if (response->exponent.value < 0)
        text_add(text, "It shrinks: a larger run.transient_cycles lets it settle\n");
}

static void say_lasting(Text *text, const Survival *survival, const char *cycle) {
    const HalfLife *half = &survival->half_life;
    if (!survival->settled) {
        text_format(text, "It lasted for %zu x %zu %ss: none of %zu motions that were started on it settled; ",
                    survival->lanes, survival->cycles, cycle, survival->lanes);
        text_format(text, "a half-life, if there is one, is above %.0f %ss (95 %%)\n", half->low, cycle);
        return;
    }
    text_format(text, "%zu of %zu motions that were started on it settled within %zu %ss: ", survival->settled,
                survival->lanes, survival->cycles, cycle);
    for (size_t i = 0; i < survival->attractor_count; i++) {
        const SurvivalAttractor *one = &survival->attractors[i];
        text_format(text, "%s%zu into period %zu, %.2f N", i ? ", " : "", one->lanes, one->period, one->peak);
    }
    if (isfinite(half->value))
        text_format(text, "; half-life %.0f %ss (95 %%: %.0f to %.0f)\n", half->value, cycle, half->low, half->high);
    else
        text_format(text, "; the half-life is too short to tell\n");
}

static void say_wait(Text *text, const SurvivalWait *wait, const char *share, const char *cycle) {
    if (isfinite(wait->median))
        text_format(text, "; %s of it takes %.0f %ss in the median", share, wait->median, cycle);
    if (isfinite(wait->median) && isfinite(wait->most))
        text_format(text, " and %.0f in 95 %% of the motions", wait->most);
}

static void say_peaks(Text *text, const Survival *survival, const char *cycle) {
    const Extreme *extreme = &survival->extreme;
    if (survival->largest <= 0)
        return;
    text_format(text, "The largest peak of all these motions is %.1f N", survival->largest);
    say_wait(text, &survival->within[0], "95 %", cycle);
    say_wait(text, &survival->within[1], "99 %", cycle);
    text_add(text, "\n");
    if (extreme->known)
        text_format(text, "The largest in a million %ss, extrapolated, is %.0f N (95 %%: %.0f to %.0f)\n", cycle,
                    extreme->level, extreme->low, extreme->high);
}

void result_verdict_say(Text *text, const Response *response, const char *cycle) {
    say_tried(text, response, cycle);
    if (response->image == ORBIT_IMAGE_OTHER)
        text_add(text,
                 "Its mirror image, with the forces of the two sides exchanged, is another orbit: they are a pair\n");
    if (!response->survival.lanes)
        return;
    say_lasting(text, &response->survival, cycle);
    say_peaks(text, &response->survival, cycle);
}
