#include "experiment/crank_experiment.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "base/stop.h"
#include "check.h"
#include "scratch.h"

enum { TRIALS = 4 };

static Experiment open_crank(const char *const *settings, size_t count) {
    Experiment experiment = {0};
    Fault fault = {0};
    CHECK(crank_experiment_open(&experiment, scratch_source("assets/cranks/ssc.json"), settings, count, &fault));
    check_say(&fault);
    return experiment;
}

/* Runs trials of one parameter into `observed`. */
static void run(const Experiment *experiment, const char *name, const double *values, const uint64_t *seeds,
                size_t count, double observed[TRIALS][CRANK_OBSERVABLES], bool carry) {
    Trial trials[TRIALS] = {0};
    for (size_t i = 0; i < count; i++)
        trials[i] = (Trial){.at = &values[i], .seed = seeds ? seeds[i] : 0, .observed = observed[i]};
    experiment->run(experiment->given, &name, 1, trials, count, carry, NULL);
    for (size_t i = 0; i < count; i++) {
        CHECK(trials[i].done && !trials[i].fault);
        trial_clear(&trials[i]);
    }
}

static const char *const calm[] = {"joint.clearance=1e-4", "run.transient_cycles=20", "run.cycles=40"};

TEST(peaks_of_regular_speeds_are_the_known_ones) {
    Experiment experiment = open_crank(calm, 3);
    static const double speeds[] = {5, 10, 15};
    double observed[TRIALS][CRANK_OBSERVABLES];
    run(&experiment, "drive.frequency", speeds, NULL, 3, observed, false);
    CHECK_NEAR(observed[0][CRANK_PEAK_MAX], 20, 0.5);
    CHECK_NEAR(observed[1][CRANK_PEAK_MAX], 51.1608, 0.01);
    CHECK_NEAR(observed[2][CRANK_PEAK_MAX], 111, 0.5);
    for (size_t i = 0; i < 3; i++) {
        CHECK(observed[i][CRANK_REGULAR] == 1 && observed[i][CRANK_PERIOD] == 1);
        CHECK_NEAR(observed[i][CRANK_CLEARANCE_RATIO], 0.0025, 1e-15);
        CHECK(isnan(observed[i][CRANK_LYAPUNOV]));
    }
    crank_experiment_close(&experiment);
}

TEST(a_trial_depends_neither_on_the_others_nor_on_their_order) {
    Experiment experiment = open_crank(calm, 3);
    static const double speeds[] = {10, 10, 12, 10};
    static const uint64_t seeds[] = {7, 0, 7, 7};
    double observed[TRIALS][CRANK_OBSERVABLES];
    run(&experiment, "drive.frequency", speeds, seeds, TRIALS, observed, false);
    CHECK(memcmp(observed[0], observed[3], sizeof observed[0]) == 0);
    CHECK_NEAR(observed[0][CRANK_PEAK_MAX], observed[1][CRANK_PEAK_MAX], 1e-3); /* one orbit from both starts */
    crank_experiment_close(&experiment);
}

TEST(a_carried_trial_begins_where_the_last_one_ended) {
    static const char *const short_run[] = {"joint.clearance=1e-4", "run.transient_cycles=0", "run.cycles=4"};
    Experiment experiment = open_crank(short_run, 3);
    static const double speeds[] = {10, 10, 10};
    double fresh[TRIALS][CRANK_OBSERVABLES], carried[TRIALS][CRANK_OBSERVABLES];
    run(&experiment, "drive.frequency", speeds, NULL, 3, fresh, false);
    run(&experiment, "drive.frequency", speeds, NULL, 3, carried, true);
    CHECK(fresh[1][CRANK_PEAK_MAX] == fresh[0][CRANK_PEAK_MAX]);
    CHECK(carried[0][CRANK_PEAK_MAX] == fresh[0][CRANK_PEAK_MAX]);
    CHECK_NEAR(fresh[0][CRANK_PEAK_MAX], 168.4, 0.1); /* the first revolution */
    CHECK_NEAR(carried[2][CRANK_PEAK_MAX], 51.16, 0.1);
    crank_experiment_close(&experiment);
}

TEST(a_value_that_does_not_close_gives_its_reason) {
    Experiment experiment = open_crank(NULL, 0);
    const char *name = "coupler.length";
    double value = 0.12, observed[CRANK_OBSERVABLES];
    Trial trial = {.at = &value, .observed = observed};
    experiment.run(experiment.given, &name, 1, &trial, 1, false, NULL);
    CHECK(trial.done && trial.fault && strstr(trial.fault, "does not close"));
    trial_clear(&trial);
    crank_experiment_close(&experiment);
}

TEST(an_interrupted_trial_is_not_done) {
    Experiment experiment = open_crank(NULL, 0);
    const char *name = "drive.frequency";
    double value = 10, observed[CRANK_OBSERVABLES];
    Stop stop = {0};
    stop_request(&stop);
    Trial trial = {.at = &value, .observed = observed};
    experiment.run(experiment.given, &name, 1, &trial, 1, false, &stop);
    CHECK(!trial.done);
    trial_clear(&trial);
    crank_experiment_close(&experiment);
}
