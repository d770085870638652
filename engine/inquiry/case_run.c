#include "inquiry/case_run.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "house/run.h"

/* One variant of one case with one seed, and the answers to the questions of that case's checks. */
typedef struct CaseRun {
    const Verification *verification;
    const char *house;     /* path of the house */
    const char **settings; /* (setting_count) */
    size_t setting_count;
    size_t variant;
    int seed; /* counted from 0, added to the first seed */
    bool done;
    MeasureAnswer *answers; /* (2 x check_count): answers for both sides of each check */
    Fault fault;
} CaseRun;

typedef struct CaseRuns {
    const CaseRunOptions *options;
    CaseRun *runs; /* (count) */
    size_t count, done;
    pthread_mutex_t lock; /* protects `done` and progress reports */
} CaseRuns;

/* Returns the question of a check for side 0, or for side 1, which side 0 is compared with. */
static MeasureQuestion question_of(const VerificationCheck *check, int side) {
    MeasureQuestion question = check->condition.question;
    if (side && check->than_of.count)
        question.of = check->than_of;
    if (side && check->than_area.count)
        question.area = check->than_area;
    return question;
}

/* True if the check needs the run: its variant, and one of as many seeds as the check has. */
static bool concerns(const VerificationCheck *check, int side, const CaseRun *run) {
    return (side == 0 || check->is_ratio) && check->sides[side] == run->variant && run->seed < check->seeds;
}

static bool stopped(const CaseRunOptions *options) {
    return stop_requested(options->stop);
}

static void make_run(CaseRun *run, const CaseRunOptions *options) {
    House house = {0};
    HouseOptions house_options = {.profiles = options->profiles,
                                  .settings = run->settings,
                                  .setting_count = run->setting_count,
                                  .seed = options->seed + (uint64_t)run->seed,
                                  .driving = -1};
    if (!house_read(&house, run->house, &house_options, &run->fault))
        return;
    Observation observation;
    RunOptions run_options = {.route = SIZE_MAX, .jobs = 1, .stop = options->stop};
    run_house(&observation, &house, &run_options);
    run->done = !observation.interrupted;
    const Verification *verification = run->verification;
    for (size_t c = 0; c < verification->check_count && run->done; c++) {
        const VerificationCheck *check = &verification->checks[c];
        for (int side = 0; side < 2; side++) {
            MeasureQuestion question = question_of(check, side);
            if (concerns(check, side, run))
                check->condition.measure->take(&run->answers[2 * c + (size_t)side], &house, &observation, &question);
        }
    }
    observation_free(&observation);
    house_free(&house);
}

static void run_one(void *context, size_t index) {
    CaseRuns *runs = context;
    const CaseRunOptions *options = runs->options;
    if (!stopped(options))
        make_run(&runs->runs[index], options);
    pthread_mutex_lock(&runs->lock);
    runs->done++;
    if (options->progress)
        options->progress(options->context, runs->done, runs->count);
    pthread_mutex_unlock(&runs->lock);
}

/* Returns the largest number of seeds that the checks of a case need of a variant. */
static int seeds_of(const Verification *verification, size_t variant) {
    int most = 0;
    for (size_t c = 0; c < verification->check_count; c++) {
        const VerificationCheck *check = &verification->checks[c];
        bool asks = check->sides[0] == variant || (check->is_ratio && check->sides[1] == variant);
        most = asks && check->seeds > most ? check->seeds : most;
    }
    return most;
}

static void add_runs(CaseRuns *runs, size_t *capacity, Verification *verification) {
    for (size_t v = 0; v < verification->variant_count && verification->applies; v++) {
        const char **settings;
        size_t setting_count = verification_settings(verification, &verification->variants[v], &settings);
        int seeds = seeds_of(verification, v);
        for (int seed = 0; seed < seeds; seed++) {
            runs->runs = memory_reserve(runs->runs, capacity, runs->count + 1, sizeof *runs->runs);
            runs->runs[runs->count++] = (CaseRun){
                .verification = verification,
                .house = verification->variants[v].house,
                .settings = settings,
                .setting_count = setting_count,
                .variant = v,
                .seed = seed,
                .answers = memory_zeroed(2 * verification->check_count, sizeof(MeasureAnswer)),
            };
        }
    }
}

/* Computes the mean over the seeds of one side of a check. Returns false if a run is missing. */
static bool mean_of(double *mean, VerificationCheck *check, size_t c, int side, const Verification *verification,
                    const CaseRuns *runs) {
    int found = 0;
    *mean = 0;
    for (size_t t = 0; t < runs->count; t++) {
        const CaseRun *run = &runs->runs[t];
        if (run->verification != verification || !run->done || !concerns(check, side, run))
            continue;
        const MeasureAnswer *answer = &run->answers[2 * c + (size_t)side];
        *mean += answer->value / check->seeds;
        found++;
        if (!*check->condition.note)
            snprintf(check->condition.note, sizeof check->condition.note, "%s", answer->note);
    }
    return found == check->seeds;
}

static void judge(VerificationCheck *check, size_t c, const Verification *verification, const CaseRuns *runs) {
    double value, other = 1;
    check->condition.value = (double)NAN;
    check->condition.verdict = VERDICT_NOT_RUN;
    *check->condition.note = 0;
    if (!mean_of(&value, check, c, 0, verification, runs) ||
        (check->is_ratio && !mean_of(&other, check, c, 1, verification, runs))) {
        *check->condition.note = 0;
        return;
    }
    condition_judge(&check->condition, value / other);
}

/* Adds errors that are new: a house has the same errors with every seed. */
static void add_new_faults(Fault *fault, const Fault *more) {
    for (size_t l = 0; l < more->count; l++) {
        bool known = false;
        for (size_t k = 0; k < fault->count && !known; k++)
            known = strcmp(fault->lines[k], more->lines[l]) == 0;
        if (!known)
            fault_add(fault, "%s", more->lines[l]);
    }
}

void case_run_all(Verification *cases, size_t count, const CaseRunOptions *options, Fault *fault) {
    CaseRuns runs = {.options = options, .lock = PTHREAD_MUTEX_INITIALIZER};
    size_t capacity = 0;
    for (size_t i = 0; i < count; i++)
        add_runs(&runs, &capacity, &cases[i]);
    parallel_for(options->jobs, runs.count, run_one, &runs);
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < cases[i].check_count; c++)
            judge(&cases[i].checks[c], c, &cases[i], &runs);
    for (size_t t = 0; t < runs.count; t++) {
        CaseRun *run = &runs.runs[t];
        add_new_faults(fault, &run->fault);
        fault_clear(&run->fault);
        memory_free(run->answers);
    }
    memory_free(runs.runs);
}

Verdict case_run_verdict(const Verification *verification) {
    if (!verification->applies)
        return VERDICT_DOES_NOT_APPLY;
    Verdict verdict = VERDICT_PASSED;
    for (size_t c = 0; c < verification->check_count; c++) {
        Verdict one = verification->checks[c].condition.verdict;
        if (one == VERDICT_FAILED)
            return VERDICT_FAILED;
        verdict = one == VERDICT_NOT_RUN ? one : verdict;
    }
    return verdict;
}
