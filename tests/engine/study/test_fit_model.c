/* Tests the fit of parameters to measurements: known values are found again, intervals hold what they say, and what the
 * data do not tell is said. */

#include "study/fit.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "base/real.h"
#include "beam/beam.h"
#include "check.h"
#include "experiment/beam_frequencies.h"
#include "scratch.h"

/* A synthetic experiment: y = a exp(-b x) + 0 c, and d only by its product with a; way 1 where a > 3. */
enum { DECAY_Y, DECAY_WAY, DECAY_OBSERVABLES };

static const Parameter decay_rows[] = {
    {.name = "a", .kind = PARAMETER_NUMBER, .unit = "1"}, {.name = "b", .kind = PARAMETER_NUMBER, .unit = "1"},
    {.name = "c", .kind = PARAMETER_NUMBER, .unit = "1"}, {.name = "d", .kind = PARAMETER_NUMBER, .unit = "1"},
    {.name = "x", .kind = PARAMETER_NUMBER, .unit = "1"},
};

static const Observable decay_observables[DECAY_OBSERVABLES] = {{"y", "1", "height"}, {"way", "1", "way"}};

static const Parameter *decay_find(const void *given, const char *name) {
    (void)given;
    for (size_t i = 0; i < sizeof decay_rows / sizeof *decay_rows; i++)
        if (strcmp(decay_rows[i].name, name) == 0)
            return &decay_rows[i];
    return NULL;
}

static void decay_run(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count,
                      bool carry, const Stop *stop) {
    (void)given;
    (void)carry;
    (void)stop;
    for (size_t t = 0; t < count; t++) {
        double values[] = {1, 1, 1, 1, 0};
        for (size_t n = 0; n < name_count; n++)
            values[decay_find(NULL, names[n]) - decay_rows] = trials[t].at[n];
        trials[t].observed[DECAY_Y] = values[0] * values[3] * real_exp(-values[1] * values[4]);
        trials[t].observed[DECAY_WAY] = values[0] > 3;
        trials[t].done = true;
    }
}

static Experiment decay(void) {
    return (Experiment){.kind = "decay",
                        .observables = decay_observables,
                        .observable_count = DECAY_OBSERVABLES,
                        .batch = 3,
                        .parameter = decay_find,
                        .run = decay_run};
}

enum { PLACES = 12 };

typedef struct Decay {
    Experiment experiment;
    FitRow rows[PLACES];
    double places[PLACES];
    FitUnknown unknowns[4];
} Decay;

static const char *const place_name[] = {"x"};

/* Rows at x = 0, 0.2 ... of a = 2, b = 1.5, off by normal deviates of a share of 0.05; unknowns a, b, c, d. */
static void make_decay(Decay *made, uint64_t seed, size_t unknowns) {
    static const char *const names[] = {"a", "b", "c", "d"};
    Random random = random_seed(seed, 1);
    *made = (Decay){.experiment = decay()};
    for (size_t r = 0; r < PLACES; r++) {
        made->places[r] = 0.2 * (double)r;
        double truth = 2 * real_exp(-1.5 * made->places[r]);
        made->rows[r] = (FitRow){.experiment = &made->experiment,
                                 .observable = DECAY_Y,
                                 .way = SIZE_MAX,
                                 .names = place_name,
                                 .at = &made->places[r],
                                 .name_count = 1,
                                 .observed = truth * real_exp(seed ? random_normal(&random, 0, 0.05) : 0),
                                 .deviation = 0.05,
                                 .relative = true,
                                 .group = r,
                                 .label = "x"};
    }
    for (size_t u = 0; u < unknowns; u++)
        made->unknowns[u] = (FitUnknown){.name = names[u], .prior = 1, .spread = 1};
}

static Fit fit_of(Decay *made, size_t unknowns) {
    return (Fit){.unknowns = made->unknowns, .unknown_count = unknowns, .rows = made->rows, .row_count = PLACES};
}

TEST(values_without_scatter_are_found_again) {
    Decay made;
    Fault fault = {0};
    make_decay(&made, 0, 2);
    Fit fit = fit_of(&made, 2);
    CHECK(fit_run(&fit, &fault));
    CHECK_NEAR(made.unknowns[0].best, 2, 0.01); /* the prior, 1, draws a little */
    CHECK_NEAR(made.unknowns[1].best, 1.5, 0.01);
    CHECK(fit.basins == 1 && fit.sum < fit.sum_before && made.unknowns[0].told && made.unknowns[1].told);
    CHECK(fit_correlation(&fit, 0, 1) > 0.5 && fit.singular[0] > fit.singular[1]);
}

TEST(intervals_of_90_percent_hold_the_truth_in_about_90_of_100) {
    size_t held[2] = {0, 0}, wide[2] = {0, 0};
    const double truth[2] = {2, 1.5};
    for (uint64_t seed = 1; seed <= 100; seed++) {
        Decay made;
        Fault fault = {0};
        make_decay(&made, seed, 2);
        Fit fit = fit_of(&made, 2);
        fit.starts = 1;
        CHECK(fit_run(&fit, &fault));
        for (size_t u = 0; u < 2; u++) {
            const FitUnknown *unknown = &made.unknowns[u];
            double reach = 1.959963984540054 * unknown->deviation;
            held[u] += truth[u] >= unknown->low && truth[u] <= unknown->high;
            wide[u] += fabs(real_log(truth[u] / unknown->best)) <= reach;
        }
    }
    printf("of 100 seeds: 90 %% intervals hold a %zu, b %zu; 95 %% a %zu, b %zu\n", held[0], held[1], wide[0], wide[1]);
    for (size_t u = 0; u < 2; u++)
        CHECK(held[u] >= 80 && held[u] <= 97 && wide[u] >= 90);
}

TEST(what_the_data_do_not_tell_keeps_its_prior) {
    Decay made;
    Fault fault = {0};
    make_decay(&made, 7, 3);
    Fit fit = fit_of(&made, 3);
    CHECK(fit_run(&fit, &fault));
    CHECK(!made.unknowns[2].told && made.unknowns[2].learned < 0.01);
    CHECK(made.unknowns[2].value == made.unknowns[2].prior);
    CHECK(fit.singular[2] < 1e-6);
}

TEST(two_that_only_count_together_are_correlated) {
    Decay made;
    Fault fault = {0};
    make_decay(&made, 7, 4);
    Fit fit = fit_of(&made, 4);
    CHECK(fit_run(&fit, &fault));
    CHECK(fit_correlation(&fit, 0, 3) < -0.9);
    CHECK_NEAR(made.unknowns[0].best * made.unknowns[3].best, 2, 0.15);
}

TEST(one_wild_row_moves_a_robust_fit_less) {
    Decay made;
    Fault fault = {0};
    double off[2];
    for (int robust = 0; robust < 2; robust++) {
        make_decay(&made, 0, 2);
        made.rows[4].observed *= 3;
        Fit fit = fit_of(&made, 2);
        fit.robust = robust;
        CHECK(fit_run(&fit, &fault));
        off[robust] = fabs(made.unknowns[1].best - 1.5);
    }
    CHECK(off[1] < 0.2 * off[0]);
}

TEST(the_number_of_jobs_does_not_matter) {
    Decay one, two;
    Fault fault = {0};
    make_decay(&one, 3, 3);
    make_decay(&two, 3, 3);
    Fit first = fit_of(&one, 3), second = fit_of(&two, 3);
    first.leave_out = second.leave_out = true;
    second.jobs = 4;
    CHECK(fit_run(&first, &fault) && fit_run(&second, &fault));
    CHECK(memcmp(one.unknowns, two.unknowns, 3 * sizeof *one.unknowns) == 0 && first.runs == second.runs);
    CHECK(first.error < first.error_before && first.error == second.error);
}

TEST(derivatives_do_not_cross_a_change_of_way) {
    Decay made;
    Fault fault = {0};
    make_decay(&made, 0, 2);
    for (size_t r = 0; r < PLACES; r++) {
        made.rows[r].way = DECAY_WAY;
        made.rows[r].observed *= 1.49; /* a = 2.98, next to the change */
    }
    Fit fit = fit_of(&made, 2);
    CHECK(fit_run(&fit, &fault));
    CHECK_NEAR(made.unknowns[0].best, 2.98, 0.02);
}

TEST(a_stop_ends_a_fit) {
    Decay made;
    Fault fault = {0};
    Stop stop = {0};
    make_decay(&made, 1, 2);
    Fit fit = fit_of(&made, 2);
    fit.stop = &stop;
    stop_request(&stop);
    CHECK(fit_run(&fit, &fault) && fit.interrupted);
}

/* Beams --------------------------------------------------------------------------------------------------------------
 */

enum { MODES = 5 };

/* Fits two numbers of the shipped beam to its first frequencies, off by 0.2 %; `names` differ from the file by factors.
 */
static Fit fit_frequencies(const Experiment *experiment, const double truth[MODES], uint64_t seed, FitUnknown *unknowns,
                           size_t count, FitRow rows[MODES]) {
    Random random = random_seed(seed, 1);
    for (size_t m = 0; m < MODES; m++)
        rows[m] = (FitRow){.experiment = experiment,
                           .observable = m,
                           .way = SIZE_MAX,
                           .observed = truth[m] * real_exp(random_normal(&random, 0, 0.002)),
                           .deviation = 0.002,
                           .relative = true,
                           .group = m,
                           .label = "f"};
    return (Fit){.unknowns = unknowns, .unknown_count = count, .rows = rows, .row_count = MODES, .starts = 1};
}

TEST(a_beams_shaker_is_found_by_its_frequencies_in_90_of_100) {
    Beam beam = {0};
    Fault fault = {0};
    Experiment experiment;
    size_t held[2] = {0, 0};
    CHECK(beam_read(&beam, scratch_source("assets/beams/ibs-r.json"), NULL, 0, &fault));
    check_say(&fault);
    beam_frequencies_open(&experiment, &beam);
    double truth[BEAM_FREQUENCIES];
    Trial trial = {.observed = truth};
    experiment.run(experiment.given, NULL, 0, &trial, 1, false, NULL);
    CHECK(trial.done && !trial.fault && truth[0] > 0 && truth[4] > truth[3]);
    for (uint64_t seed = 1; seed <= 100; seed++) {
        FitRow rows[MODES];
        FitUnknown unknowns[2] = {{.name = "shaker.moving_mass", .prior = 1.3 * beam.shaker_mass, .spread = 0.5},
                                  {.name = "shaker.position", .prior = 0.9 * beam.shaker_position, .spread = 0.3}};
        Fit fit = fit_frequencies(&experiment, truth, seed, unknowns, 2, rows);
        CHECK(fit_run(&fit, &fault));
        const double true_values[2] = {beam.shaker_mass, beam.shaker_position};
        for (size_t u = 0; u < 2; u++)
            held[u] += fabs(real_log(true_values[u] / unknowns[u].best)) <= 1.959963984540054 * unknowns[u].deviation;
    }
    printf("of 100 seeds: 95 %% intervals hold the shaker's mass %zu, its position %zu\n", held[0], held[1]);
    CHECK(held[0] >= 90 && held[1] >= 90);
    beam_free(&beam);
}
