#include "result/drivers.h"
#include "result/shares.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/text.h"
#include "experiment/danger.h"
#include "house/touch.h"
#include "result/danger.h"
#include "result/grade.h"
#include "plan/observed_times.h"
#include "result/names.h"
#include "study/montecarlo.h"
#include "study/random_effects.h"
#include "study/welch.h"

/* The drivers of one person. */
typedef struct Fleet {
    size_t person, count;
    Share out, touch;
    Distribution time, impact;
    double energy;  /* J, mean over all drivers */
    double back;    /* m, mean way driven backwards */
    char where[96]; /* the worst place (danger.h); "": nobody touches anything */
    int part;       /* BodyPart, of the fastest impact there */
    Share hands;    /* of those with hands at the rims, whose hand space meets something */
    double squeeze; /* N, greatest */
} Fleet;

/* Finds the worst place, and who of the drivers has a hand that meets something. */
static void find_danger(Fleet *fleet, const House *house, const Drivers *drivers) {
    Danger danger = danger_of_drivers(house, drivers, fleet->person);
    fleet->hands = danger.hands;
    if (danger.count && danger.places[0].part != PART_HAND) {
        fleet->part = danger.places[0].part;
        memcpy(fleet->where, danger.places[0].what, sizeof fleet->where);
    }
    for (size_t p = 0; p < danger.count; p++)
        fleet->squeeze = fmax(fleet->squeeze, danger.places[p].squeeze);
    danger_free(&danger);
}

/* Returns the drivers of a person; count 0: the person is not of the population. */
static Fleet fleet_of(const House *house, const Drivers *drivers, size_t person) {
    Fleet fleet = {.person = person};
    double *times = memory_zeroed(2 * drivers->count, sizeof *times), *impacts = times + drivers->count;
    size_t out = 0, touch = 0;
    for (size_t k = 0; k < drivers->count; k++) {
        const DriverRun *run = &drivers->runs[k * drivers->person_count + person];
        times[k] = impacts[k] = (double)NAN;
        if (!run->varies)
            continue;
        fleet.count++;
        out += run->completed;
        touch += run->contacts > 0;
        times[k] = run->completed ? run->time : (double)NAN;
        impacts[k] = run->contacts > 0 ? run->impact : (double)NAN;
        fleet.energy += run->energy;
        fleet.back += run->back_length;
    }
    fleet.out = montecarlo_share(out, fleet.count);
    fleet.touch = montecarlo_share(touch, fleet.count);
    fleet.time = montecarlo_distribution(times, drivers->count);
    fleet.impact = montecarlo_distribution(impacts, drivers->count);
    if (fleet.count) {
        fleet.energy /= (double)fleet.count;
        fleet.back /= (double)fleet.count;
    }
    find_danger(&fleet, house, drivers);
    memory_free(times);
    return fleet;
}

static bool has_band(const Fleet *fleet) {
    return fleet->time.count >= MONTECARLO_BAND;
}

static void add_share(ResultTable *table, const char *const *keys, const char *label, const Share *share) {
    result_add(table, (ResultRow){.key = keys[0],
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = share->value,
                                  .text = result_shares_text(&table->arena, share)});
    result_add(table, (ResultRow){.key = keys[1], .kind = RESULT_NUMBER, .number = share->low});
    result_add(table, (ResultRow){.key = keys[2], .kind = RESULT_NUMBER, .number = share->high});
}

static void add_no_share(ResultTable *table, const char *const *keys) {
    for (int k = 0; k < 3; k++)
        result_add(table, (ResultRow){.key = keys[k], .kind = RESULT_NUMBER, .omitted = true});
}

static void add_fleet(ResultTable *table, const House *house, double nominal, const Fleet *fleet) {
    static const char *const outs[] = {"out.share", "out.low", "out.high"};
    static const char *const touches[] = {"touch.share", "touch.low", "touch.high"};
    static const char *const hands[] = {"hand.share", "hand.low", "hand.high"};
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = house->people[fleet->person].id});
    result_add_number(table, "nominal", "nominal driver", nominal, "s", 2);
    result_add(table,
               (ResultRow){.key = "count", .label = "drivers", .kind = RESULT_COUNT, .number = (double)fleet->count});
    result_add(table, (ResultRow){.key = "out.count", .kind = RESULT_COUNT, .number = (double)fleet->out.good});
    add_share(table, outs, "out", &fleet->out);
    result_add_number(table, "time.mean", "mean", fleet->time.mean, "s", 2);
    result_add_number(table, "time.deviation", "deviation", fleet->time.deviation, "s", 2);
    result_add_number(table, "time.low", has_band(fleet) ? "5 %" : NULL, fleet->time.low, "s", 1);
    result_add_number(table, "time.median", "median", fleet->time.median, "s", 1);
    result_add_number(table, "time.high", has_band(fleet) ? "95 %" : NULL, fleet->time.high, "s", 1);
    result_add_number(table, "time.least", has_band(fleet) ? NULL : "least", fleet->time.least, "s", 1);
    result_add_number(table, "time.greatest", has_band(fleet) ? NULL : "greatest", fleet->time.greatest, "s", 1);
    add_share(table, touches, "touch something", &fleet->touch);
    result_add_number(table, "impact.speed95", "impact 95 %", fleet->impact.high, "m/s", 2);
    result_add_number(table, "impact.energy", "mean energy", fleet->energy, "J", 2);
    result_add_number(table, "squeeze", "squeeze", fleet->squeeze, "N", 0);
    if (fleet->hands.all)
        add_share(table, hands, "a hand meets something", &fleet->hands);
    else
        add_no_share(table, hands);
    result_add_number(table, "backwards.distance", "backwards", fleet->back, "m", 2);
    bool hit = *fleet->where;
    result_add(table, (ResultRow){.key = "impact.what",
                                  .label = "worst at",
                                  .text = hit ? text_in_arena(&table->arena, "%s", fleet->where) : NULL,
                                  .omitted = !hit});
    result_add(table, (ResultRow){.key = "impact.part",
                                  .label = "with the",
                                  .text = hit ? touch_part(fleet->part) : NULL,
                                  .omitted = !hit});
    result_end(table);
}

static double nominal_time(const Observation *nominal, size_t person) {
    return nominal->people[person].completed ? nominal->people[person].time : (double)NAN;
}

ResultTable result_drivers_table(const House *house, const Observation *nominal, const Drivers *drivers) {
    ResultTable table = {0};
    for (size_t i = 0; i < drivers->person_count; i++) {
        Fleet fleet = fleet_of(house, drivers, i);
        if (fleet.count)
            add_fleet(&table, house, nominal_time(nominal, i), &fleet);
    }
    return table;
}

/* Routes ---------------------------------------------------------------------------------------------------------- */

/* Returns the time of a route with driver k, s; NAN: not all of it get out, or none of them is of the population. */
static double route_time(const House *house, const Drivers *drivers, size_t k, const PlanRoute *route) {
    double time = -HUGE_VAL;
    bool varies = false;
    for (size_t i = 0; i < drivers->person_count; i++) {
        const DriverRun *run = &drivers->runs[k * drivers->person_count + i];
        if (house->people[i].route != route || !run->took_part)
            continue;
        if (!run->completed)
            return (double)NAN;
        varies |= run->varies;
        time = fmax(time, run->time);
    }
    return varies ? time : (double)NAN;
}

static const char *words_of_verdict(Arena *arena, const Welch *welch, const WelchSample *measured) {
    switch (welch->verdict) {
    case WELCH_AGREES:
        return "agrees within 10 %";
    case WELCH_DIFFERS:
        return text_in_arena(arena, "differs, by %.1f to %.1f s", welch->low, welch->high);
    case WELCH_CANNOT_TELL:
        return text_in_arena(arena, "cannot be told with n = %zu", measured->count);
    default:
        return measured->count ? "too few runs" : NULL;
    }
}

static void add_comparison(ResultTable *table, const PlanRoute *route, const Distribution *times) {
    ObservedTimes observed = observed_times_of(&route->observed);
    bool measured = observed.runs > 0;
    WelchSample a = {observed.mean, observed.deviation, (size_t)observed.runs};
    WelchSample c = {times->mean, times->deviation, times->count};
    Welch welch = welch_compare(&a, &c, 0.1);
    const char *verdict = words_of_verdict(&table->arena, &welch, &a);
    result_add(table, (ResultRow){.key = "id", .label = "route", .text = route->id});
    result_add_number(table, "mean", "mean (a)", measured ? a.mean : (double)NAN, "s", 2);
    result_add_number(table, "deviation", "deviation (b)", measured && a.count > 1 ? a.deviation : (double)NAN, "s", 2);
    result_add(table, (ResultRow){.key = "runs",
                                  .label = "n",
                                  .kind = RESULT_COUNT,
                                  .number = measured ? (double)a.count : (double)NAN});
    result_add_number(table, "simulation", "simulated mean (c)", c.mean, "s", 2);
    result_add_number(table, "simulated_deviation", "deviation (d)", c.deviation, "s", 2);
    result_add(table, (ResultRow){.key = "drivers", .label = "N", .kind = RESULT_COUNT, .number = (double)c.count});
    result_add(table, (ResultRow){.key = "error",
                                  .label = "((c)-(a))/(a)",
                                  .kind = RESULT_NUMBER,
                                  .number = measured ? (c.mean - a.mean) / a.mean : (double)NAN,
                                  .unit = "%",
                                  .factor = 100,
                                  .decimals = 1,
                                  .sign = true});
    result_add_number(table, "error_low", NULL, measured ? welch.low / a.mean : (double)NAN, NULL, 3);
    result_add_number(table, "error_high", NULL, measured ? welch.high / a.mean : (double)NAN, NULL, 3);
    WelchScatter scatter = welch_scatter(&a, &c);
    result_add_number(table, "scatter", "(d)/(b)", scatter.ratio, NULL, 2);
    result_add_number(table, "scatter_low", NULL, scatter.low, NULL, 2);
    result_add_number(table, "scatter_high", NULL, scatter.high, NULL, 2);
    result_add(table, (ResultRow){.key = "verdict", .label = "verdict", .text = verdict, .omitted = !verdict});
    result_end(table);
}

ResultTable result_drivers_routes(const House *house, const Drivers *drivers) {
    ResultTable table = {0};
    double *times = memory_zeroed(drivers->count, sizeof *times);
    for (size_t r = 0; r < house->plan.route_count; r++) {
        for (size_t k = 0; k < drivers->count; k++)
            times[k] = route_time(house, drivers, k, &house->plan.routes[r]);
        Distribution distribution = montecarlo_distribution(times, drivers->count);
        if (distribution.count)
            add_comparison(&table, &house->plan.routes[r], &distribution);
    }
    memory_free(times);
    return table;
}

/* Adds what the single runs of a route tell beside the simulated times. */
static void add_measured(ResultTable *table, const Observed *observed, const char *id, const double *times,
                         size_t count, Share touch) {
    size_t runs = observed->times.count, inside = 0, slower = 0, out = 0;
    Distribution simulated = montecarlo_distribution(times, count);
    for (size_t i = 0; i < runs; i++)
        inside += observed->times.at[i] >= simulated.low && observed->times.at[i] <= simulated.high;
    double one = observed_times_of(observed).runs == 1 ? observed_times_of(observed).mean : (double)NAN;
    for (size_t k = 0; k < count; k++) {
        out += isfinite(times[k]);
        slower += times[k] > one;
    }
    RandomEffects effects = {.within = NAN, .between = NAN};
    if (observed->drivers.count) {
        size_t *person = memory_zeroed(runs, sizeof *person);
        for (size_t i = 0; i < runs; i++)
            person[i] = observed_times_person(observed, i);
        effects = random_effects_of(observed->times.at, person, runs);
        memory_free(person);
    }
    bool people = effects.groups > 0, counted = observed->touches >= 0, alone = isfinite(one);
    Share hit = montecarlo_share(counted ? (size_t)observed->touches : 0, (size_t)observed_times_of(observed).runs);
    Arena *arena = &table->arena;
    result_add(table, (ResultRow){.key = "id", .label = "route", .text = id});
    result_add(table, (ResultRow){.key = "people",
                                  .label = "people who drove",
                                  .kind = RESULT_COUNT,
                                  .number = people ? (double)effects.groups : (double)NAN,
                                  .omitted = !people});
    result_add_number(table, "within", "deviation of one person", effects.within, "s", 2);
    result_add_number(table, "between", "between people", effects.between, "s", 2);
    result_add(table, (ResultRow){.key = "inside",
                                  .kind = RESULT_COUNT,
                                  .number = runs ? (double)inside : (double)NAN,
                                  .omitted = !runs});
    result_add(table, (ResultRow){.label = "inside the simulated 90 %",
                                  .text = runs ? text_in_arena(arena, "%zu of %zu", inside, runs) : NULL});
    result_add(table, (ResultRow){.key = "rank",
                                  .label = "rank",
                                  .text = alone ? text_in_arena(arena, "quicker than %zu of %zu", slower, out) : NULL,
                                  .omitted = !alone});
    result_add(table, (ResultRow){.key = "touches",
                                  .kind = RESULT_COUNT,
                                  .number = counted ? (double)observed->touches : (double)NAN,
                                  .omitted = !counted});
    result_add(table, (ResultRow){.label = "touched", .text = counted ? result_shares_text(arena, &hit) : NULL});
    result_add(table,
               (ResultRow){.label = "touched, simulated", .text = counted ? result_shares_text(arena, &touch) : NULL});
    result_end(table);
}

/* Returns the share of drivers with whom somebody on the route touches something. */
static Share route_touch(const House *house, const Drivers *drivers, const PlanRoute *route) {
    size_t touch = 0, all = 0;
    for (size_t k = 0; k < drivers->count; k++) {
        bool varies = false, touches = false;
        for (size_t i = 0; i < drivers->person_count; i++) {
            const DriverRun *run = &drivers->runs[k * drivers->person_count + i];
            if (house->people[i].route != route)
                continue;
            varies |= run->varies;
            touches |= run->varies && run->contacts > 0;
        }
        all += varies;
        touch += touches;
    }
    return montecarlo_share(touch, all);
}

ResultTable result_drivers_measured(const House *house, const Drivers *drivers) {
    ResultTable table = {0};
    double *times = memory_zeroed(drivers->count, sizeof *times);
    for (size_t r = 0; r < house->plan.route_count; r++) {
        const PlanRoute *route = &house->plan.routes[r];
        const Observed *observed = &route->observed;
        size_t out = 0;
        for (size_t k = 0; k < drivers->count; k++) {
            times[k] = route_time(house, drivers, k, route);
            out += isfinite(times[k]);
        }
        bool single = observed->times.count || observed->touches >= 0 || observed_times_of(observed).runs == 1;
        if (out && single)
            add_measured(&table, observed, route->id, times, drivers->count, route_touch(house, drivers, route));
    }
    memory_free(times);
    return table;
}

/* Pairs ----------------------------------------------------------------------------------------------------------- */

static void add_count(ResultTable *table, const char *key, const char *label, size_t count) {
    result_add(table, (ResultRow){.key = key, .label = label, .kind = RESULT_COUNT, .number = (double)count});
}

/* One person in two houses with the same drivers. */
typedef struct Pair {
    size_t all, out[2], touch[2], quicker;
    Distribution difference; /* s, b - a, of those who get out of both */
    double both[2];          /* s, the mean times of those */
    size_t only[2];          /* who get out of a alone, of b alone */
    double alone[2];         /* s, their mean times; NAN: nobody */
} Pair;

/* Compares a person, who is `other` in the second house. */
static Pair pair_of(const Drivers drivers[2], size_t person, size_t other) {
    size_t count = drivers[0].count < drivers[1].count ? drivers[0].count : drivers[1].count;
    Pair pair = {.all = 0};
    double *differences = memory_zeroed(count, sizeof *differences), sums[2] = {0}, alone[2] = {0};
    for (size_t k = 0; k < count; k++) {
        const DriverRun *runs[2] = {&drivers[0].runs[k * drivers[0].person_count + person],
                                    &drivers[1].runs[k * drivers[1].person_count + other]};
        differences[k] = (double)NAN;
        if (!runs[0]->varies || !runs[1]->varies)
            continue;
        pair.all++;
        bool both = runs[0]->completed && runs[1]->completed;
        for (int h = 0; h < 2; h++) {
            pair.out[h] += runs[h]->completed;
            pair.touch[h] += runs[h]->contacts > 0;
            pair.only[h] += runs[h]->completed && !both;
            alone[h] += runs[h]->completed && !both ? runs[h]->time : 0;
            sums[h] += both ? runs[h]->time : 0;
        }
        if (both)
            differences[k] = runs[1]->time - runs[0]->time;
        pair.quicker += differences[k] < 0;
    }
    pair.difference = montecarlo_distribution(differences, count);
    for (int h = 0; h < 2; h++) {
        pair.both[h] = pair.difference.count ? sums[h] / (double)pair.difference.count : (double)NAN;
        pair.alone[h] = pair.only[h] ? alone[h] / (double)pair.only[h] : (double)NAN;
    }
    memory_free(differences);
    return pair;
}

/* Returns half of the 95 % interval of the mean difference, s; NAN: too few. */
static double half_width(const Pair *pair) {
    const Distribution *both = &pair->difference;
    return both->count > 1 ? welch_student(0.975, (double)both->count - 1) * both->error : (double)NAN;
}

static void add_pair(ResultTable *table, const House *house, const Pair *pair, size_t person) {
    const Distribution *both = &pair->difference;
    double wide = half_width(pair);
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = house->people[person].id});
    add_count(table, "drivers", "drivers", pair->all);
    add_count(table, "out_a", "out of a", pair->out[0]);
    add_count(table, "out_b", "out of b", pair->out[1]);
    add_count(table, "touch_a", "touch in a", pair->touch[0]);
    add_count(table, "touch_b", "touch in b", pair->touch[1]);
    add_count(table, "both", "out of both", both->count);
    result_add_number(table, "mean_a", "these in a", pair->both[0], "s", 2);
    result_add_number(table, "mean_b", "these in b", pair->both[1], "s", 2);
    result_add_number(table, "difference", "b - a", both->mean, "s", 2);
    result_add_number(table, "low", "from", both->mean - wide, "s", 2);
    result_add_number(table, "high", "to (95 %)", both->mean + wide, "s", 2);
    add_count(table, "quicker", "quicker in b", pair->quicker);
    add_count(table, "only_a.count", NULL, pair->only[0]);
    result_add_number(table, "only_a.mean", NULL, pair->alone[0], "s", 2);
    add_count(table, "only_b.count", NULL, pair->only[1]);
    result_add_number(table, "only_b.mean", NULL, pair->alone[1], "s", 2);
    result_end(table);
}

void result_drivers_paired_say(Text *text, const House houses[2], const Drivers drivers[2]) {
    for (size_t i = 0; i < drivers[0].person_count; i++) {
        size_t other = house_find_person(&houses[1], houses[0].people[i].id);
        Pair pair = other == SIZE_MAX ? (Pair){.all = 0} : pair_of(drivers, i, other);
        if (!pair.all)
            continue;
        text_format(text, "%s  %zu of %zu get out of both", houses[0].people[i].id, pair.difference.count, pair.all);
        if (pair.difference.count)
            text_format(text, ", in %.1f s and %.1f s in the mean: only these are compared", pair.both[0],
                        pair.both[1]);
        for (int h = 0; h < 2; h++)
            if (pair.only[h])
                text_format(text, "; %zu get out of %s alone, in %.1f s, and change the mean of all who get out",
                            pair.only[h], h ? "b" : "a", pair.alone[h]);
        text_add(text, "\n");
    }
}

ResultTable result_drivers_paired(const House houses[2], const Drivers drivers[2]) {
    ResultTable table = {0};
    for (size_t i = 0; i < drivers[0].person_count; i++) {
        size_t other = house_find_person(&houses[1], houses[0].people[i].id);
        Pair pair = other == SIZE_MAX ? (Pair){.all = 0} : pair_of(drivers, i, other);
        if (pair.all)
            add_pair(&table, &houses[0], &pair, i);
    }
    return table;
}

static void add_range(Text *text, const Fleet *fleet) {
    if (fleet->time.count && has_band(fleet))
        text_format(text, "90 %% of drivers take %.1f to %.1f s; ", fleet->time.low, fleet->time.high);
    else if (fleet->time.count)
        text_format(text, "drivers %.1f to %.1f s; ", fleet->time.least, fleet->time.greatest);
}

const char *result_drivers_brief(const House *house, const Drivers *drivers, size_t person, Arena *arena) {
    Fleet fleet = fleet_of(house, drivers, person);
    Text text = {0};
    if (!fleet.count)
        return NULL;
    add_range(&text, &fleet);
    text_format(&text, "%zu of %zu out", fleet.out.good, fleet.count);
    if (fleet.touch.good)
        text_format(&text, "; %.0f %% touch, worst at %s, at most %s", 100 * fleet.touch.value,
                    names_text(house, fleet.where, arena), result_danger_words(fleet.impact.greatest, arena));
    else
        text_add(&text, "; none touches anything");
    const char *said = text_in_arena(arena, "%s", text.text);
    memory_free(text.text);
    return said;
}

void result_drivers_say(Text *text, const House *house, const Observation *nominal, const Drivers *drivers) {
    for (size_t i = 0; i < drivers->person_count; i++) {
        Fleet fleet = fleet_of(house, drivers, i);
        if (!fleet.count)
            continue;
        text_format(text, "%s  ", house->people[i].id);
        if (nominal->people[i].completed)
            text_format(text, "%.1f s; ", nominal->people[i].time);
        add_range(text, &fleet);
        text_format(text, "%zu of %zu out; %.0f %% touch something (%.0f to %.0f)", fleet.out.good, fleet.count,
                    100 * fleet.touch.value, 100 * fleet.touch.low, 100 * fleet.touch.high);
        Arena arena = {0};
        if (fleet.impact.count)
            text_format(text, ", worst at %s, at most %s", fleet.where,
                        result_danger_words(fleet.impact.greatest, &arena));
        if (fleet.hands.good)
            text_format(text, "; %.0f %% have a hand at the rim that would meet something", 100 * fleet.hands.value);
        arena_clear(&arena);
        text_format(text, "\n");
    }
}

/* Returns "65" or "93 to 100". */
static const char *from_to(double low, double high, Arena *arena) {
    return text_in_arena(arena, high - low < 0.5 ? "%.0f" : "%.0f to %.0f", low, high);
}

/* 1: from this share of touches on, a grade that does not expect them is contradicted. */
static const double CONTRADICTED = 0.10;

/* True if the drivers of a person touch more often than the grade of the person's way says. */
static bool contradicts(const Fleet *fleet, const Grade *grade) {
    return fleet->count > 0 && grade->letter <= GRADE_C && fleet->touch.value >= CONTRADICTED;
}

void result_drivers_say_grades(Text *text, const House *house, const Drivers *drivers, const Grade *grades) {
    for (size_t i = 0; i < drivers->person_count && drivers->count; i++) {
        Fleet fleet = fleet_of(house, drivers, i);
        if (contradicts(&fleet, &grades[i]))
            text_format(text,
                        "%s  grade %s, %s, is that of the room alone: %.0f %% of the drivers touch something (%.0f to "
                        "%.0f)\n",
                        house->people[i].id, grade_letter(grades[i].letter), grade_words(grades[i].letter),
                        100 * fleet.touch.value, 100 * fleet.touch.low, 100 * fleet.touch.high);
    }
}

const char *result_drivers_headline(const House *house, const Drivers *drivers, const Grade *grades, Arena *arena) {
    Text text = {0};
    size_t people = 0;
    double out[2] = {HUGE_VAL, 0}, touch[2] = {HUGE_VAL, 0}, count = 0;
    Fleet fleet = {.count = 0};
    bool contradicted = false;
    for (size_t i = 0; i < drivers->person_count && drivers->count; i++) {
        Fleet next = fleet_of(house, drivers, i);
        if (!next.count)
            continue;
        contradicted |= grades && contradicts(&next, &grades[i]);
        fleet = next;
        people++;
        count = (double)fleet.count;
        out[0] = fmin(out[0], (double)fleet.out.good);
        out[1] = fmax(out[1], (double)fleet.out.good);
        touch[0] = fmin(touch[0], 100 * fleet.touch.value);
        touch[1] = fmax(touch[1], 100 * fleet.touch.value);
    }
    if (people)
        text_format(&text, "%s of %.0f drivers get out%s, %s %% touch something", from_to(out[0], out[1], arena), count,
                    people > 1 ? " of each start" : "", from_to(touch[0], touch[1], arena));
    if (people == 1 && fleet.time.count)
        text_format(&text, ", %.1f s in the mean", fleet.time.mean);
    const char *grade = grades ? result_grade_phrase(house, grades, arena) : "";
    if (*grade)
        text_format(&text, "%s%s%s", people ? ", " : "", grade, contradicted ? ", by room alone" : "");
    const char *said = text_in_arena(arena, "%s", text.text ? text.text : "");
    memory_free(text.text);
    return said;
}
