#include "study/store.h"

#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "check.h"
#include "scratch.h"
#include "study/summary.h"
#include "toy.h"

static uint64_t results_in_one_go(void) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = toy_study(&experiment);
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 1});
    uint64_t digest = summary_digest(&study);
    study_clear(&study);
    return digest;
}

/* Runs one shard of the study with all features into a file of its own. Returns the number of its trials. */
static size_t run_shard(const char *path, StudyShard shard) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = toy_study(&experiment);
    StoreFound found;
    Fault fault = {0};
    study.shard = shard;
    study_begin(&study);
    Store *store = store_open(path, STORE_WITH_READERS, &study, study_digest(&study, 7), &found, &fault);
    CHECK(store && !found.done);
    study_run(&study, &(StudyOptions){.jobs = 2, .keep = store_write, .keeper = store});
    CHECK(store_close(store, &fault));
    size_t done = study_done(&study);
    CHECK(done == study_room(&study));
    study_clear(&study);
    return done;
}

TEST(the_shards_of_a_study_share_its_trials_without_cutting_a_chain) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = toy_study(&experiment);
    study_begin(&study);
    for (size_t count = 1; count < 40; count += 6) {
        size_t trials = 0;
        for (size_t number = 1; number <= count; number++) {
            size_t place = 0;
            study.shard = (StudyShard){number, count};
            for (size_t t = 0; t < study.trial_count; t++)
                CHECK(!study_has(&study, t) || study_place(&study, t) == place++);
            CHECK(study_room(&study) == place);
            trials += place;
        }
        CHECK(trials == study.trial_count);
        study.shard = (StudyShard){0};
        for (size_t t = study.trial_count / 3; t < study.trial_count; t++)
            CHECK(study_shard_of(&study, count, t) == study_shard_of(&study, count, t - t % 7));
    }
    CHECK(study_has(&study, 5) && study_room(&study) == 189);
    study_clear(&study);
}

/* The whole study needs more room than a file may have here, a shard of it does not. */
TEST(a_shard_reserves_room_for_its_own_trials_only) {
    char path[SCRATCH_PATH], folder[SCRATCH_PATH];
    scratch_write(path, "");
    snprintf(folder, sizeof folder, "%.*s", (int)(strrchr(path, '/') - path), path);
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = {.experiment = &experiment,
                   .axes = {{"x", 0, 3, 1000}},
                   .axis_count = 1,
                   .passes = {STUDY_RESET, STUDY_UP},
                   .pass_count = 2,
                   .runs = 1000,
                   .seed = 1};
    Fault fault = {0};
    struct rlimit before, small = {128 << 20, RLIM_INFINITY};
    getrlimit(RLIMIT_FSIZE, &before);
    small.rlim_max = before.rlim_max;
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    CHECK(!study_begin_in(&study, folder, &fault) && fault.total == 1);
    fault_clear(&fault);
    study.shard = (StudyShard){7, 100};
    CHECK(study_begin_in(&study, folder, &fault) && study_room(&study) == 20000);
    setrlimit(RLIMIT_FSIZE, &before);
    size_t last = study_index(&study, 1, 906, 0, 999); /* the chain of run 906 of the second pass is of the shard */
    CHECK(study_has(&study, last) && study_place(&study, last) == 19999);
    CHECK(study_nth(&study, last)->seed == 907 && study_nth(&study, last)->at[0] == 3 &&
          isnan(study_nth(&study, last)->observed[0]));
    study_clear(&study);
    unlink(path);
}

TEST(merged_shards_are_the_study_of_one_go_bit_for_bit) {
    enum { SHARDS = 5 };
    char paths[SHARDS][SCRATCH_PATH], path[SCRATCH_PATH];
    size_t stored = 0;
    for (size_t s = 0; s < SHARDS; s++) {
        scratch_write(paths[s], "");
        stored += run_shard(paths[s], (StudyShard){s + 1, SHARDS});
    }
    CHECK(stored == 189);
    scratch_write(path, "");
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = toy_study(&experiment);
    StoreFound found;
    Fault fault = {0};
    study_begin(&study);
    Store *store = store_open(path, STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    for (size_t s = SHARDS; s-- > 0;)
        CHECK(store_merge(store, &study, paths[s], &fault) == STORE_MERGED);
    CHECK(store_merge(store, &study, paths[1], &fault) == STORE_MERGED && fault.count == 0);
    CHECK(toy.run == 0 && summary_digest(&study) == results_in_one_go());
    CHECK(store_merge(store, &study, "/nowhere/study-1-of-2.sqlite", &fault) == STORE_REFUSED && fault.count == 1);
    CHECK(strstr(fault.lines[0], "cannot be"));
    fault_clear(&fault);
    store_abandon(store);
    study_clear(&study);
    study_begin(&study);
    store = store_open(path, STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    CHECK(store && found.done == 0); /* nothing was committed */
    store_abandon(store);
    study_clear(&study);
    for (size_t s = 0; s < SHARDS; s++)
        unlink(paths[s]);
    unlink(path);
}

TEST(a_shard_has_one_writer_and_any_number_of_readers) {
    char path[SCRATCH_PATH], other[SCRATCH_PATH];
    scratch_write(path, "");
    scratch_write(other, "");
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = toy_study(&experiment), merged = study;
    StoreFound found;
    Fault fault = {0};
    study_begin(&study);
    study_begin(&merged);
    Store *store = store_open(path, STORE_WITH_READERS, &study, study_digest(&study, 7), &found, &fault);
    study_run(&study, &(StudyOptions){.jobs = 1, .keep = store_write, .keeper = store});
    CHECK(!store_open(path, STORE_WITH_READERS, &study, study_digest(&study, 7), &found, &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "is in use by another program"));
    fault_clear(&fault);
    Store *all = store_open(other, STORE_ALONE, &merged, study_digest(&merged, 7), &found, &fault);
    CHECK(all && store_merge(all, &merged, path, &fault) == STORE_REFUSED); /* nothing is committed yet */
    fault_clear(&fault);
    CHECK(store_close(store, &fault));
    CHECK(store_merge(all, &merged, path, &fault) == STORE_MERGED && study_done(&merged) == 189);
    CHECK(store_close(all, &fault));
    study_clear(&study);
    study_clear(&merged);
    unlink(path);
    unlink(other);
}
