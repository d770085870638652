#include "result/ablation.h"

#include <stdint.h>
#include <string.h>

#include "study/montecarlo.h"
#include "study/welch.h"

/* The drivers of one person in one variant. */
typedef struct Tally {
    size_t all, out, touch, contacts;
    Distribution time, impact, narrowest;
    double back; /* m, mean way driven backwards */
} Tally;

/* The drivers of one person in two variants. */
typedef struct Pairing {
    size_t both;            /* who get out of both */
    double mean, low, high; /* s, of the difference, with its 95 % interval; NAN: too few */
} Pairing;

static const DriverRun *run_of(const Ablation *ablation, int variant, size_t k, size_t person) {
    return &ablation->drivers[variant].runs[k * ablation->drivers[variant].person_count + person];
}

/* Returns the variant that this one is compared with. */
static int base_of(int variant) {
    return variant > ABLATION_PAPER ? ABLATION_PAPER : ABLATION_WHOLE;
}

/* True if the driver has a way to begin with. */
static bool sets_off(const DriverRun *run) {
    return !observation_reason_is_planned(run->reason) && run->reason != REASON_NO_EXIT;
}

static Tally tally_of(const Ablation *ablation, int variant, size_t person) {
    size_t count = ablation->drivers[variant].count;
    double *numbers = memory_zeroed(3 * count, sizeof *numbers);
    Tally tally = {0};
    for (size_t k = 0; k < count; k++) {
        const DriverRun *run = run_of(ablation, variant, k, person);
        tally.all += run->varies;
        tally.out += run->varies && run->completed;
        tally.touch += run->varies && run->contacts > 0;
        tally.contacts += run->varies ? (size_t)run->contacts : 0;
        tally.back += run->varies ? run->back_length : 0;
        numbers[k] = run->varies && run->completed ? run->time : (double)NAN;
        numbers[count + k] = run->varies && run->contacts > 0 ? run->impact : (double)NAN;
        numbers[2 * count + k] = run->varies && sets_off(run) ? run->narrowest : (double)NAN;
    }
    tally.back /= (double)tally.all;
    tally.time = montecarlo_distribution(numbers, count);
    tally.impact = montecarlo_distribution(numbers + count, count);
    tally.narrowest = montecarlo_distribution(numbers + 2 * count, count);
    memory_free(numbers);
    return tally;
}

static Pairing pair_with_base(const Ablation *ablation, int variant, size_t person) {
    size_t count = ablation->drivers[variant].count;
    double *differences = memory_zeroed(count, sizeof *differences);
    for (size_t k = 0; k < count; k++) {
        const DriverRun *run = run_of(ablation, variant, k, person);
        const DriverRun *base = run_of(ablation, base_of(variant), k, person);
        bool both = run->varies && run->completed && base->completed;
        differences[k] = both ? run->time - base->time : (double)NAN;
    }
    Distribution of = montecarlo_distribution(differences, count);
    memory_free(differences);
    double wide = of.count > 1 ? welch_student(0.975, (double)of.count - 1) * of.error : (double)NAN;
    return (Pairing){of.count, of.mean, of.mean - wide, of.mean + wide};
}

static void add_count(ResultTable *table, const char *key, const char *label, size_t count) {
    result_add(table, (ResultRow){.key = key, .label = label, .kind = RESULT_COUNT, .number = (double)count});
}

static void add_variant(ResultTable *table, const Ablation *ablation, int variant, size_t person) {
    Tally tally = tally_of(ablation, variant, person);
    Pairing pairing = pair_with_base(ablation, variant, person);
    bool base = variant == ABLATION_WHOLE;
    result_add(table, (ResultRow){.key = "variant", .label = "variant", .text = ablation_rows[variant].name});
    result_add_number(table, "time.mean", "mean", tally.time.mean, "s", 2);
    result_add_number(table, "time.deviation", "deviation", tally.time.deviation, "s", 2);
    add_count(table, "count", NULL, tally.all);
    add_count(table, "out", NULL, tally.out);
    result_add(table,
               (ResultRow){.label = "out", .text = text_in_arena(&table->arena, "%zu of %zu", tally.out, tally.all)});
    add_count(table, "touch", NULL, tally.touch);
    result_add(table, (ResultRow){.key = "touch_share",
                                  .label = "touch",
                                  .kind = RESULT_NUMBER,
                                  .number = (double)tally.touch / (double)tally.all,
                                  .unit = "%",
                                  .factor = 100});
    add_count(table, "contacts", "touches", tally.contacts);
    result_add_number(table, "impact.speed95", "impact 95 %", tally.impact.high, "m/s", 2);
    result_add(table, (ResultRow){.key = "narrowest.low",
                                  .label = "narrowest 5 %",
                                  .kind = RESULT_NUMBER,
                                  .number = tally.narrowest.low,
                                  .unit = "cm",
                                  .factor = 100,
                                  .decimals = 1});
    result_add_number(table, "backwards", "backwards", tally.back, "m", 2);
    result_add(table, (ResultRow){.key = "against",
                                  .label = "against",
                                  .text = base ? NULL : ablation_rows[base_of(variant)].name,
                                  .omitted = base});
    result_add(table, (ResultRow){.key = "difference",
                                  .label = "difference",
                                  .kind = RESULT_NUMBER,
                                  .number = base ? (double)NAN : pairing.mean,
                                  .unit = "s",
                                  .decimals = 2,
                                  .sign = true});
    result_add_number(table, "low", "from", base ? (double)NAN : pairing.low, "s", 2);
    result_add_number(table, "high", "to", base ? (double)NAN : pairing.high, "s", 2);
    result_end(table);
}

ResultTable result_ablation_table(const Ablation *ablation, size_t person) {
    ResultTable table = {.numbers = RESULT_REAL};
    for (int variant = 0; variant < ABLATIONS; variant++)
        if (tally_of(ablation, variant, person).all)
            add_variant(&table, ablation, variant, person);
    return table;
}

ResultTable result_ablation_variants(const Population *population) {
    ResultTable table = {0};
    for (int variant = 0; variant < ABLATIONS; variant++) {
        const AblationRow *row = &ablation_rows[variant];
        Text settings = {0};
        if (row->driving == DRIVING_MIURA)
            text_add(&settings, "--driving miura ");
        for (size_t s = 0; s < ABLATION_SETTINGS && row->settings[s]; s++) {
            const char *setting = row->settings[s], *gap = strstr(setting, "%s");
            text_add(&settings, "--set ");
            if (gap)
                text_format(&settings, "%.*s%s%s ", (int)(gap - setting), setting, population->profile, gap + 2);
            else
                text_format(&settings, "%s ", setting);
        }
        result_add(&table, (ResultRow){.key = "name", .label = "variant", .text = row->name});
        result_add(&table, (ResultRow){.key = "meaning", .label = "meaning", .text = row->meaning});
        bool any = settings.used > 0;
        result_add(&table,
                   (ResultRow){.key = "options",
                               .label = "options of run --drivers",
                               .text = any ? text_in_arena(&table.arena, "%.*s", (int)settings.used - 1, settings.text)
                                           : NULL});
        result_end(&table);
        memory_free(settings.text);
    }
    return table;
}

/* s: times that differ by less are told as the same. */
static const double SAME = 0.01;

/* Words ----------------------------------------------------------------------------------------------------------- */

static void say_touches(Text *text, const Tally *with, const Tally *without) {
    size_t before = with->contacts, now = without->contacts;
    if (now == before)
        text_format(text, "as many touches (%zu)", now);
    else if (before > 0 && now > before)
        text_format(text, "%.1f times as many touches (%zu instead of %zu, by %zu of %zu drivers instead of %zu)",
                    (double)now / (double)before, now, before, without->touch, without->all, with->touch);
    else
        text_format(text,
                    now == 1 ? "%zu touch instead of %zu, by %zu of %zu drivers instead of %zu"
                             : "%zu touches instead of %zu, by %zu of %zu drivers instead of %zu",
                    now, before, without->touch, without->all, with->touch);
}

static void say_time(Text *text, const Pairing *pairing) {
    if (!isfinite(pairing->low))
        text_add(text, pairing->both ? "one driver gets out of both, too few for an interval of times"
                                     : "nobody gets out of both, so that times are not compared");
    else if (fmax(fabs(pairing->low), fabs(pairing->high)) < SAME)
        text_add(text, "the same times to 0.01 s");
    else if (pairing->low <= 0 && pairing->high >= 0)
        text_format(text, "no difference of time that can be told from chance (%+.2f s, %.2f to %.2f)",
                    fabs(pairing->mean) < SAME ? 0 : pairing->mean, pairing->low, pairing->high);
    else
        text_format(text, "%.2f s %s (%.2f to %.2f)", fabs(pairing->mean), pairing->mean > 0 ? "slower" : "quicker",
                    fmin(fabs(pairing->low), fabs(pairing->high)), fmax(fabs(pairing->low), fabs(pairing->high)));
}

void result_ablation_say(Text *text, const Ablation *ablation, size_t person) {
    for (int variant = ABLATION_WHOLE + 1; variant < ABLATIONS; variant++) {
        Tally with = tally_of(ablation, base_of(variant), person), without = tally_of(ablation, variant, person);
        Pairing pairing = pair_with_base(ablation, variant, person);
        if (!without.all)
            continue;
        text_format(text, "%s, against %s: ", ablation_rows[variant].name, ablation_rows[base_of(variant)].name);
        say_touches(text, &with, &without);
        text_add(text, "; ");
        say_time(text, &pairing);
        if (without.out != with.out)
            text_format(text, "; %zu of %zu get out instead of %zu", without.out, without.all, with.out);
        text_add(text, "\n");
    }
}
