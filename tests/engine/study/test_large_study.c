#include "study/study.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/random.h"
#include "base/text.h"
#include "check.h"
#include "scratch.h"
#include "study/montecarlo.h"
#include "study/store.h"
#include "study/study_csv.h"
#include "study/summary.h"
#include "toy.h"

/* The study with all features, with faults where x is above 50. */
static Study faulty_study(const Experiment *experiment) {
    Study study = toy_study(experiment);
    study.axes[0].to = 60;
    study.axes[0].steps = 13;
    return study;
}

static void new_path(char path[SCRATCH_PATH]) {
    scratch_write(path, "");
}

static const char *folder_of(char path[SCRATCH_PATH]) {
    char *end = strrchr(path, '/');
    *end = 0;
    return path;
}

/* True if two tables are the same, byte for byte. */
static bool same_tables(const Study *a, const Study *b, int (*write)(const Study *study, const char *path)) {
    char first[SCRATCH_PATH], second[SCRATCH_PATH];
    size_t sizes[2] = {0};
    new_path(first);
    new_path(second);
    CHECK(write(a, first) == 0 && write(b, second) == 0);
    char *one = text_read_file(first, 1 << 24, &sizes[0]), *other = text_read_file(second, 1 << 24, &sizes[1]);
    bool same = one && other && sizes[0] == sizes[1] && memcmp(one, other, sizes[0]) == 0;
    memory_free(one);
    memory_free(other);
    unlink(first);
    unlink(second);
    return same;
}

TEST(a_study_in_a_file_has_the_results_of_one_in_memory) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study held = faulty_study(&experiment), large = held;
    char path[SCRATCH_PATH], store_path[SCRATCH_PATH];
    Fault fault = {0};
    StoreFound found;
    new_path(path);
    new_path(store_path);
    unlink(path);
    study_begin(&held);
    CHECK(study_begin_in(&large, folder_of(path), &fault) && large.large);
    Store *store = store_open(store_path, STORE_ALONE, &large, study_digest(&large, 7), &found, &fault);
    study_run(&held, &(StudyOptions){.jobs = 2});
    study_run(&large, &(StudyOptions){.jobs = 2, .keep = store_write, .keeper = store});
    CHECK(store_close(store, &fault));
    CHECK(summary_digest(&held) == summary_digest(&large) && study_done(&large) == large.trial_count);
    CHECK(same_tables(&held, &large, study_csv_write_trials) && same_tables(&held, &large, study_csv_write_series) &&
          same_tables(&held, &large, study_csv_write_points));
    study_clear(&large);

    CHECK(study_begin_in(&large, path, &fault));
    store = store_open(store_path, STORE_ALONE, &large, study_digest(&large, 7), &found, &fault);
    CHECK(store && found.done == large.trial_count && summary_digest(&held) == summary_digest(&large));
    CHECK(store_close(store, &fault));
    study_forget(&large);
    CHECK(study_done(&large) == 0);
    study_clear(&large);
    study_clear(&held);
    unlink(store_path);
}

TEST(without_its_series_an_experiment_keeps_none) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    experiment.series = NULL;
    Study study = faulty_study(&experiment);
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 1});
    size_t listed = 0;
    for (size_t t = 0; t < study.trial_count; t++)
        listed += study_nth(&study, t)->series_count;
    CHECK(listed == 0 && study_done(&study) == study.trial_count);
    study_clear(&study);
}

TEST(a_folder_that_cannot_hold_the_results_is_named) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = faulty_study(&experiment);
    Fault fault = {0};
    CHECK(!study_begin_in(&study, "/nowhere", &fault) && fault.total == 1);
    CHECK(strstr(fault.lines[0], "/nowhere cannot hold the results of 351 runs"));
    CHECK(!study.trials && !study.large);
    fault_clear(&fault);
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

static double listed_at(const void *of, size_t i) {
    return ((const double *)of)[i];
}

TEST(quantiles_that_are_counted_are_those_that_are_sorted) {
    enum { MANY = 3001 };
    double *numbers = memory_zeroed(MANY, sizeof *numbers);
    Random random = random_seed(5, 1);
    for (size_t i = 0; i < MANY; i++) /* with equal ones, both zeros, and some that are no numbers */
        numbers[i] = i % 7 == 0    ? floor(random_normal(&random, 0, 2))
                     : i % 11 == 0 ? (double)NAN
                     : i % 13 == 0 ? -0.0
                                   : random_normal(&random, -3, 1e3);
    Distribution sorted = montecarlo_distribution(numbers, MANY);
    size_t last = sorted.count - 1, ranks[] = {0, last / 2, last - last / 2, last};
    double found[4];
    Numbers all = {listed_at, numbers, MANY};
    numbers_find(&all, ranks, 4, found);
    CHECK(found[0] == sorted.least && found[3] == sorted.greatest);
    CHECK_NEAR(found[1] + (found[2] - found[1]) / 2, sorted.median, 1e-12);
    memory_free(numbers);
}

static double wave_at(const void *of, size_t i) {
    (void)of;
    return i % 101 == 0 ? (double)NAN : (double)((i * 2654435761u) % 1000003u) - 5e5;
}

LONG_TEST(a_distribution_of_more_than_a_million_numbers_is_the_sorted_one) {
    Numbers many = {wave_at, NULL, MONTECARLO_SORTED + 1000};
    double *held = memory_zeroed(many.count, sizeof *held);
    for (size_t i = 0; i < many.count; i++)
        held[i] = numbers_at(&many, i);
    Distribution streamed = montecarlo_of(&many), sorted = montecarlo_distribution(held, many.count);
    CHECK(streamed.count == sorted.count && streamed.least == sorted.least && streamed.greatest == sorted.greatest);
    CHECK(streamed.low == sorted.low && streamed.median == sorted.median && streamed.high == sorted.high);
    CHECK(streamed.quarters[0] == sorted.quarters[0] && streamed.quarters[1] == sorted.quarters[1]);
    CHECK_NEAR(streamed.mean, sorted.mean, 1e-6);
    CHECK_NEAR(streamed.deviation, sorted.deviation, 1e-6);
    memory_free(held);
}
