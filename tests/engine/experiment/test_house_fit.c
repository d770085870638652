/* Tests the fit of a chair to times of shipped houses: known values are found again from simulated times. */

#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "check.h"
#include "experiment/house_experiment.h"
#include "scratch.h"
#include "study/fit.h"

enum { HOUSES = 2, NAMES = 3 };

static const char *const names[NAMES] = {"profile.manual-chair.free_speed", "profile.manual-chair.steering_time",
                                         "profile.manual-chair.reversing_time"};

TEST(the_prior_of_an_unknown_number_is_that_of_the_profile) {
    char profiles[4096], path[4096];
    Experiment experiment;
    Fault fault = {0};
    snprintf(profiles, sizeof profiles, "%s", scratch_source("assets/profiles"));
    snprintf(path, sizeof path, "%s/houses/straight-corridor.json", check_source());
    const HouseOptions options = {.profiles = profiles,
                                  .seed = 1,
                                  .driving = -1,
                                  .settings = (const char *[]){"profile.manual-chair.free_speed=0.77"},
                                  .setting_count = 1};
    CHECK(house_experiment_open(&experiment, path, &options, NULL, &fault));
    check_say(&fault);
    CHECK_NEAR(experiment.nominal(experiment.given, names[0]), 0.77, 1e-12);
    house_experiment_close(&experiment);
}

LONG_TEST(free_speed_and_steering_time_are_found_again_and_what_is_not_used_is_not_told) {
    static const char *const files[HOUSES] = {"straight-corridor", "corner-1.80-1.80"};
    const double truth[] = {0.8, 0.5};
    char paths[HOUSES][4096], profiles[4096];
    Experiment experiments[HOUSES];
    FitRow rows[HOUSES];
    Fault fault = {0};
    snprintf(profiles, sizeof profiles, "%s", scratch_source("assets/profiles"));
    const HouseOptions options = {.profiles = profiles, .seed = 1, .driving = -1};
    for (size_t h = 0; h < HOUSES; h++) {
        snprintf(paths[h], sizeof paths[h], "%s/houses/%s.json", check_source(), files[h]);
        CHECK(house_experiment_open(&experiments[h], paths[h], &options, NULL, &fault));
        check_say(&fault);
        double observed[HOUSE_OBSERVABLES];
        Trial trial = {.at = truth, .observed = observed};
        experiments[h].run(experiments[h].given, names, 2, &trial, 1, false, NULL);
        CHECK(trial.done && !trial.fault && observed[HOUSE_COMPLETED] == 1);
        rows[h] = (FitRow){.experiment = &experiments[h],
                           .observable = HOUSE_TIME,
                           .way = HOUSE_WAY,
                           .observed = observed[HOUSE_TIME],
                           .deviation = 0.1,
                           .group = h,
                           .label = files[h]};
        trial_clear(&trial);
    }
    FitUnknown unknowns[NAMES];
    for (size_t u = 0; u < NAMES; u++)
        unknowns[u] = (FitUnknown){
            .name = names[u], .prior = experiments[0].nominal(experiments[0].given, names[u]), .spread = 0.5};
    Fit fit = {.unknowns = unknowns, .unknown_count = NAMES, .rows = rows, .row_count = HOUSES, .starts = 1};
    CHECK(fit_run(&fit, &fault));
    check_say(&fault);
    printf("free speed %.4f of 0.8 m/s, steering time %.3f of 0.5 s, %zu runs\n", unknowns[0].best, unknowns[1].best,
           fit.runs);
    CHECK(fabs(unknowns[0].best / truth[0] - 1) < 0.06 && unknowns[0].told);
    CHECK(fabs(unknowns[1].best / truth[1] - 1) < 0.15 && unknowns[1].told);
    CHECK(!unknowns[2].told && unknowns[2].value == unknowns[2].prior);
    CHECK(fit.sum < fit.sum_before);
    for (size_t h = 0; h < HOUSES; h++)
        house_experiment_close(&experiments[h]);
}
