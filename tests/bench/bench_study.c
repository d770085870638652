/* The memory and time of a study of very many trials of nothing: bench_study FOLDER [TRIALS] runs it in two shards,
 * merges them and summarises, then a map of as many cells, with all its files in FOLDER. */
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/stopwatch.h"
#include "study/store.h"
#include "study/study_csv.h"
#include "study/summary.h"
#include "toy.h"
#include "visual/study/study_plots.h"

enum { POINTS = 100, TRIALS = 10000000, MEMORY_MOST = 1000 /* MB */, PATH = 4200 };

/* Returns the largest resident memory so far, MB. */
static long memory_so_far(void) {
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

static void tell(const char *step, double *since) {
    double now = stopwatch_now();
    printf("%-32s %7.1f s, at most %ld MB so far\n", step, now - *since, memory_so_far());
    fflush(stdout);
    *since = now;
}

static void remove_folder(const char *folder) {
    DIR *directory = opendir(folder);
    char path[2 * PATH];
    for (const struct dirent *entry; directory && (entry = readdir(directory));)
        if (entry->d_name[0] != '.') {
            snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
            unlink(path);
        }
    if (directory)
        closedir(directory);
    rmdir(folder);
}

/* Runs a square map of so many cells, carried upwards too if `passes` is 2, and writes its plots. */
static bool run_map(const Experiment *experiment, const char *folder, size_t cells, size_t passes) {
    size_t side = (size_t)sqrt((double)cells / (double)passes);
    Study study = {.experiment = experiment,
                   .axes = {{"x", 0, 3, side}, {"y", 1, 2, side}},
                   .axis_count = 2,
                   .passes = {STUDY_RESET, STUDY_UP},
                   .pass_count = passes,
                   .runs = 1,
                   .seed = 1};
    Fault fault = {0};
    double since = stopwatch_now();
    char path[PLOT_WRITE_PATH], plots[PLOT_WRITE_PATH];
    snprintf(plots, sizeof plots, "%s/bench-study-XXXXXX", folder);
    if (!mkdtemp(plots) || !study_begin_in(&study, folder, &fault))
        return false;
    study_run(&study, &(StudyOptions){.jobs = 2});
    tell("a map", &since);
    int error = study_plots_write(&study, NULL, plots, &(PlotSheet){1280, 720, THEME_PAPER, NULL}, path);
    tell("its plots", &since);
    remove_folder(plots);
    study_clear(&study);
    return !error;
}

int main(int count_of_words, char **words) {
    const char *folder = count_of_words > 1 ? words[1] : ".";
    size_t trials = count_of_words > 2 ? strtoul(words[2], NULL, 10) : TRIALS;
    char paths[3][PATH], table[PATH];
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = {.experiment = &experiment,
                   .axes = {{"x", 0, 3, POINTS}},
                   .axis_count = 1,
                   .spreads = {{"y", 0.05}},
                   .spread_count = 1,
                   .passes = {STUDY_RESET},
                   .pass_count = 1,
                   .runs = trials / POINTS,
                   .seed = 1};
    Fault fault = {0};
    StoreFound found;
    double since = stopwatch_now(), begun = since;
    snprintf(table, sizeof table, "%s/bench-study.csv", folder);
    for (size_t s = 0; s < 3; s++) {
        snprintf(paths[s], sizeof paths[s], "%s/bench-study-%zu.sqlite", folder, s);
        unlink(paths[s]);
    }
    for (size_t s = 0; s < 2; s++) {
        study.shard = (StudyShard){s + 1, 2};
        if (!study_begin_in(&study, folder, &fault))
            return 2;
        Store *store = store_open(paths[s], STORE_WITH_READERS, &study, study_digest(&study, 7), &found, &fault);
        study_run(&study, &(StudyOptions){.jobs = 2, .keep = store_write, .keeper = store});
        store_close(store, &fault);
        study_clear(&study);
        tell("a shard of two", &since);
    }
    study.shard = (StudyShard){0};
    if (!study_begin_in(&study, folder, &fault))
        return 2;
    Store *store = store_open(paths[2], STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    bool merged = store_merge(store, &study, paths[0], &fault) == STORE_MERGED &&
                  store_merge(store, &study, paths[1], &fault) == STORE_MERGED;
    store_close(store, &fault);
    tell("the merge", &since);
    SummaryCount count = summary_count(&study);
    size_t ranges;
    memory_free(summary_ranges(&study, 0, 0, &ranges));
    printf("digest %016llx, %zu done, %zu regular, %zu ranges\n", (unsigned long long)summary_digest(&study),
           count.done, count.regular, ranges);
    tell("counts, ranges and the digest", &since);
    study_csv_write_points(&study, table);
    tell("the table of points", &since);
    study_csv_write_trials(&study, table);
    tell("the table of trials", &since);
    unlink(table);
    study_clear(&study);
    for (size_t s = 0; s < 3; s++)
        unlink(paths[s]);
    bool mapped = run_map(&experiment, folder, trials, 1) && run_map(&experiment, folder, trials, 2);
    tell("in all", &begun);
    fault_clear(&fault);
    return merged && mapped && count.done == trials && memory_so_far() < MEMORY_MOST ? 0 : 1;
}
