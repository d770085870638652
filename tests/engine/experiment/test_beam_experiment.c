#include "experiment/beam_experiment.h"

#include <math.h>
#include <string.h>

#include "check.h"
#include "scratch.h"
#include "base/stop.h"
#include "study/basins.h"

enum { TRIALS = 24, NAMES_MOST = 3 };

/* Trials with the memory of their numbers. */
typedef struct Batch {
    Trial trials[TRIALS];
    double at[TRIALS][NAMES_MOST];
    double observed[TRIALS][BEAM_OBSERVABLES];
} Batch;

static void batch_init(Batch *batch) {
    memset(batch, 0, sizeof *batch);
    for (size_t i = 0; i < TRIALS; i++) {
        batch->trials[i] = (Trial){.at = batch->at[i], .observed = batch->observed[i]};
        for (size_t k = 0; k < BEAM_OBSERVABLES; k++)
            batch->observed[i][k] = -12345;
    }
}

static void batch_clear(Batch *batch) {
    for (size_t i = 0; i < TRIALS; i++)
        trial_clear(&batch->trials[i]);
}

static Experiment open_beam(const char *name, const char *setting) {
    char path[100];
    Experiment experiment = {0};
    Fault fault = {0};
    snprintf(path, sizeof path, "assets/beams/%s.json", name);
    CHECK(beam_experiment_open(&experiment, scratch_source(path), &setting, setting ? 1 : 0, &fault));
    fault_clear(&fault);
    return experiment;
}

static bool same_number(double a, double b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

static void check_same(const Trial *a, const Trial *b) {
    for (size_t k = 0; k < BEAM_OBSERVABLES; k++)
        CHECK(same_number(a->observed[k], b->observed[k]));
    CHECK(a->series_count == b->series_count);
    for (size_t k = 0; k < a->series_count && k < b->series_count; k++)
        CHECK(same_number(a->series[k], b->series[k]));
}

TEST(the_beam_of_set_b_is_told_as_it_is_known) {
    Experiment experiment = open_beam("ibs", NULL);
    static const double frequencies[] = {190, 290, 300}, peaks[] = {568, 1032, 956}, tolerances[] = {1, 1, 48};
    const char *names[] = {"drive.frequency"};
    Batch batch;
    batch_init(&batch);
    for (size_t i = 0; i < 3; i++)
        batch.at[i][0] = frequencies[i];
    experiment.run(experiment.given, names, 1, batch.trials, 3, false, NULL);
    for (size_t i = 0; i < 3; i++) {
        const double *observed = batch.observed[i];
        CHECK(batch.trials[i].done && !batch.trials[i].fault);
        CHECK_NEAR(observed[BEAM_REGULAR], i < 2, 0);
        CHECK_NEAR(observed[BEAM_PERIOD], i < 2, 0);
        CHECK_NEAR(observed[BEAM_PEAK_MAX], peaks[i], tolerances[i]);
        CHECK_NEAR(observed[BEAM_TOUCHES], (double)batch.trials[i].series_count / 100, 1e-12);
        CHECK(observed[BEAM_PEAK_MIN] <= observed[BEAM_PEAK_MEAN] && observed[BEAM_PEAK_MEAN] <= peaks[i] + 48);
        CHECK(isnan(observed[BEAM_LYAPUNOV]));
    }
    CHECK(batch.trials[0].series_count == 200);
    batch_clear(&batch);
    beam_experiment_close(&experiment);
}

/* Trials of one beam and of others, with given and random initial states. */
static void fill(Batch *batch) {
    batch_init(batch);
    for (size_t i = 0; i < TRIALS; i++) {
        batch->at[i][0] = 180 + 5.0 * (double)i;
        batch->at[i][1] = i % 3 ? 0.2812 : 0.2812 + 1e-3 * (double)(i / 6);
        batch->at[i][2] = i % 2 ? 0.127e-3 : 0.15e-3;
        batch->trials[i].seed = i % 4;
    }
}

TEST(what_comes_of_a_trial_depends_neither_on_the_others_nor_on_their_order) {
    Experiment experiment = open_beam("ibs", "run.transient_cycles=60");
    const char *names[] = {"drive.frequency", "beam.length", "joint.clearance"};
    Batch together, apart;
    fill(&together);
    fill(&apart);
    experiment.run(experiment.given, names, 3, together.trials, TRIALS, false, NULL);
    for (size_t i = TRIALS; i-- > 0;)
        experiment.run(experiment.given, names, 3, &apart.trials[i], 1, false, NULL);
    for (size_t i = 0; i < TRIALS; i++)
        check_same(&together.trials[i], &apart.trials[i]);
    batch_clear(&together);
    batch_clear(&apart);
    beam_experiment_close(&experiment);
}

TEST(seeds_are_other_starts_and_the_same_each_time) {
    Experiment experiment = open_beam("ibs", "run.transient_cycles=0");
    Batch batch;
    batch_init(&batch);
    for (size_t i = 0; i < 8; i++)
        batch.trials[i].seed = i / 2;
    experiment.run(experiment.given, NULL, 0, batch.trials, 8, false, NULL);
    for (size_t i = 0; i < 8; i += 2)
        check_same(&batch.trials[i], &batch.trials[i + 1]);
    for (size_t i = 2; i < 8; i += 2)
        CHECK(batch.trials[i].series[0] != batch.trials[i - 2].series[0]);
    batch_clear(&batch);
    beam_experiment_close(&experiment);
}

/* Without a drive, a beam at rest stays at rest, and a beam bent into the wall or pushed touches it. */
TEST(a_start_is_the_tips) {
    Experiment experiment = open_beam("ibs", "run.transient_cycles=0");
    const char *names[] = {"start.deflection", "start.velocity", "drive.force"};
    Batch batch;
    batch_init(&batch);
    batch.at[1][0] = 0.2e-3; /* 0.073 mm into the wall */
    batch.at[2][1] = 0.5;
    experiment.run(experiment.given, names, 3, batch.trials, 3, false, NULL);
    CHECK(batch.trials[0].series_count == 0 && batch.observed[0][BEAM_REGULAR] == 1);
    CHECK(batch.trials[1].series_count > 0);
    if (batch.trials[1].series_count)
        CHECK(batch.trials[1].series[0] >= 1.5e7 * 0.073e-3 * (1 - 1e-6));
    CHECK(batch.trials[2].series_count > 0);
    batch_clear(&batch);
    beam_experiment_close(&experiment);
}

TEST(carried_on_a_beam_keeps_its_orbit_where_one_from_rest_finds_another) {
    Experiment experiment = open_beam("ibs", "run.transient_cycles=0");
    const char *names[] = {"drive.frequency"};
    Batch carried, reset;
    batch_init(&carried);
    batch_init(&reset);
    for (size_t i = 0; i < 3; i++)
        carried.at[i][0] = reset.at[i][0] = 290;
    experiment.run(experiment.given, names, 1, carried.trials, 3, true, NULL);
    experiment.run(experiment.given, names, 1, reset.trials, 3, false, NULL);
    check_same(&carried.trials[0], &reset.trials[0]);
    check_same(&reset.trials[0], &reset.trials[2]);
    CHECK(carried.trials[2].series[0] != reset.trials[2].series[0]);
    CHECK_NEAR(carried.observed[2][BEAM_PEAK_MIN], 1032, 1); /* its transient is over after 200 cycles */
    CHECK(reset.observed[2][BEAM_PEAK_MIN] < 1000);
    batch_clear(&carried);
    batch_clear(&reset);
    beam_experiment_close(&experiment);
}

TEST(carried_to_a_beam_a_little_longer_the_motion_goes_on) {
    Experiment experiment = open_beam("ibs", "drive.frequency=190");
    const char *names[] = {"beam.length"};
    Batch batch;
    batch_init(&batch);
    batch.at[0][0] = 0.2812;
    batch.at[1][0] = 0.2812 * (1 + 1e-9);
    experiment.run(experiment.given, names, 1, batch.trials, 2, true, NULL);
    CHECK_NEAR(batch.trials[1].series[0], batch.trials[0].series[batch.trials[0].series_count - 2], 1e-3);
    batch_clear(&batch);
    beam_experiment_close(&experiment);
}

TEST(values_that_do_not_fit_are_the_trials_fault) {
    Experiment experiment = open_beam("ibs", NULL);
    const char *names[] = {"beam.length"};
    Batch batch;
    batch_init(&batch);
    batch.at[0][0] = -1;
    batch.at[1][0] = 0.1; /* the shaker lies beyond the beam's end */
    batch.at[2][0] = NAN;
    experiment.run(experiment.given, names, 1, batch.trials, 3, false, NULL);
    for (size_t i = 0; i < 3; i++) {
        CHECK(batch.trials[i].fault && batch.trials[i].done);
        CHECK(isnan(batch.observed[i][BEAM_REGULAR]) && isnan(batch.observed[i][BEAM_PEAK_MAX]));
    }
    CHECK_TEXT(batch.trials[0].fault, "beam.length is -1, must be from 0.001 to 100 m");
    CHECK_TEXT(batch.trials[1].fault, "ibs: shaker.position is 0.1406 m, at most the length, 0.1 m");
    batch_clear(&batch);
    beam_experiment_close(&experiment);
}

TEST(modes_and_cycles_are_numbers_too_and_whole) {
    Experiment experiment = open_beam("ibs", "drive.frequency=290");
    const char *names[] = {"beam.modes", "run.cycles"};
    Batch batch;
    batch_init(&batch);
    static const double modes[] = {12, 8, 12, 8.5}, cycles[] = {50, 60, 70, 50};
    for (size_t i = 0; i < 4; i++) {
        batch.at[i][0] = modes[i];
        batch.at[i][1] = cycles[i];
    }
    experiment.run(experiment.given, names, 2, batch.trials, 4, false, NULL);
    for (size_t i = 0; i < 3; i++)
        CHECK(batch.trials[i].done && (double)batch.trials[i].series_count == 2 * cycles[i]);
    CHECK(batch.observed[0][BEAM_PEAK_MAX] != batch.observed[1][BEAM_PEAK_MAX]);
    CHECK(batch.trials[3].fault);
    batch_clear(&batch);
    beam_experiment_close(&experiment);
}

TEST(a_stop_leaves_trials_undone) {
    Experiment experiment = open_beam("ibs", NULL);
    const Stop stop = {1};
    Batch batch;
    batch_init(&batch);
    experiment.run(experiment.given, NULL, 0, batch.trials, 3, false, &stop);
    for (size_t i = 0; i < 3; i++)
        CHECK(!batch.trials[i].done && isnan(batch.observed[i][BEAM_REGULAR]));
    batch_clear(&batch);
    beam_experiment_close(&experiment);
}

TEST(numbers_of_a_beam_and_its_start_are_parameters) {
    Experiment experiment = open_beam("ibs", "drive.force=200");
    CHECK_NEAR(experiment.nominal(experiment.given, "drive.force"), 200, 0);
    CHECK_NEAR(experiment.nominal(experiment.given, "start.velocity"), 0, 0);
    CHECK_TEXT(experiment.parameter(experiment.given, "joint.clearance")->unit, "m");
    CHECK_TEXT(experiment.parameter(experiment.given, "start.deflection")->unit, "m");
    CHECK(!experiment.parameter(experiment.given, "joint.release"));
    CHECK_NEAR(experiment.nominal(experiment.given, "beam.modes"), 12, 0);
    CHECK(!experiment.parameter(experiment.given, "nothing"));
    beam_experiment_close(&experiment);
}

/* A thorough trial agrees with the quick one and has more results. */
TEST(a_thorough_trial_tells_exponents) {
    Experiment quick = open_beam("ibs", NULL), thorough = {0};
    Beam beam = {0};
    Fault fault = {0};
    CHECK(beam_read(&beam, scratch_source("assets/beams/ibs.json"), NULL, 0, &fault));
    CHECK(beam_experiment_of(&thorough, &beam, "ibs", &fault));
    beam_experiment_be_thorough(&thorough, BEAM_EXPERIMENT_LANES, BEAM_EXPERIMENT_CYCLES);
    const char *names[] = {"drive.frequency"};
    Batch batch;
    batch_init(&batch);
    batch.at[0][0] = 290;
    batch.at[1][0] = 300;
    thorough.run(thorough.given, names, 1, batch.trials, 2, false, NULL);
    CHECK(batch.observed[0][BEAM_REGULAR] == 1 && batch.observed[0][BEAM_LYAPUNOV] < 0);
    CHECK(batch.observed[1][BEAM_REGULAR] == 0 && batch.observed[1][BEAM_LYAPUNOV] > 0.7);
    CHECK(batch.observed[1][BEAM_ZERO_ONE] > 0.95);
    CHECK_TEXT(trial_verdict(&batch.trials[0], &thorough), "periodic");
    CHECK_TEXT(trial_verdict(&batch.trials[1], &thorough), "chaotic");
    CHECK_NEAR(batch.observed[0][BEAM_ATTRACTOR_PEAK], batch.observed[0][BEAM_PEAK_MAX], 1e-3);
    CHECK(isnan(batch.observed[1][BEAM_ATTRACTOR_PEAK]) && isnan(batch.observed[0][BEAM_HALF_LIFE]));
    batch_clear(&batch);
    beam_experiment_close(&thorough);
    beam_experiment_close(&quick);
    beam_free(&beam);
}

/* Set B at 250 Hz and 60 N: from all random starts 744 N, and beside it the motion without contact, in closed form
 * 0.1208 mm of 0.127 mm, whose branch ends at 63.0773 N. */
TEST(the_motion_without_contact_is_found_where_random_starts_miss_it) {
    Experiment experiment = open_beam("ibs", "drive.frequency=250");
    Study study = {.experiment = &experiment,
                   .axes = {{"drive.force", 60, 66, 2}},
                   .axis_count = 1,
                   .passes = {STUDY_RESET},
                   .pass_count = 1,
                   .runs = 16,
                   .seed = 1};
    char name[40];
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 2});
    CHECK(basins_exist(&study));
    Basins both = basins_at(&study, 0), one = basins_at(&study, 1);
    CHECK(both.count == 2 && both.starts == 16 && one.count == 1);
    CHECK(both.of[0].share.good == 16 && both.of[0].share.low > 0.8 && both.of[0].others == 0);
    CHECK_NEAR(both.of[0].measure, 744.4, 0.5);
    CHECK(both.of[1].share.good == 0 && both.of[1].others == 1 && !both.of[1].contact);
    basins_name(&study, &both.of[0], name, sizeof name);
    CHECK_TEXT(name, "period 1");
    basins_name(&study, &both.of[1], name, sizeof name);
    CHECK_TEXT(name, "no contact");
    CHECK_NEAR(both.unseen_below, 1 - pow(0.05, 1.0 / 16), 1e-12);
    study_clear(&study);
    beam_experiment_close(&experiment);
}
