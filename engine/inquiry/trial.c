#include "inquiry/trial.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "house/run.h"

/* One variant of one case with one seed, and the answers to the questions of that case's checks. */
typedef struct Trial {
    const Verification *verification;
    const char *house;     /* path */
    const char **settings; /* (setting_count) */
    size_t setting_count;
    size_t variant;
    int seed; /* from 0, added to the first */
    bool done;
    MeasureAnswer *answers; /* (2 x check_count): what is asked, and what it is compared with */
    Fault fault;
} Trial;

typedef struct Trials {
    const TrialOptions *options;
    Trial *trials; /* (count) */
    size_t count, done;
    pthread_mutex_t lock; /* of `done` and of who reports progress */
} Trials;

/* What a check asks of its side 0, or of side 1, which it is compared with. */
static MeasureQuestion question_of(const VerificationCheck *check, int side) {
    MeasureQuestion question = check->question;
    if (side && check->than_of.count)
        question.of = check->than_of;
    if (side && check->than_area.count)
        question.area = check->than_area;
    return question;
}

/* A check asks a trial for its variant and for as many seeds as it has. */
static bool concerns(const VerificationCheck *check, int side, const Trial *trial) {
    return (side == 0 || check->is_ratio) && check->sides[side] == trial->variant && trial->seed < check->seeds;
}

static bool stopped(const TrialOptions *options) {
    return parallel_stopped(options->stop);
}

static void run_trial(Trial *trial, const TrialOptions *options) {
    House house = {0};
    HouseOptions house_options = {.profiles = options->profiles,
                                  .settings = trial->settings,
                                  .setting_count = trial->setting_count,
                                  .seed = options->seed + (uint64_t)trial->seed,
                                  .driving = -1};
    if (!house_read(&house, trial->house, &house_options, &trial->fault))
        return;
    Observation observation;
    RunOptions run = {.route = SIZE_MAX, .jobs = 1, .stop = options->stop};
    run_house(&observation, &house, &run);
    trial->done = !stopped(options);
    const Verification *verification = trial->verification;
    for (size_t c = 0; c < verification->check_count && trial->done; c++) {
        const VerificationCheck *check = &verification->checks[c];
        for (int side = 0; side < 2; side++) {
            MeasureQuestion question = question_of(check, side);
            if (concerns(check, side, trial))
                check->measure->take(&trial->answers[2 * c + (size_t)side], &house, &observation, &question);
        }
    }
    observation_free(&observation);
    house_free(&house);
}

static void run_one(void *context, size_t index) {
    Trials *trials = context;
    const TrialOptions *options = trials->options;
    if (!stopped(options))
        run_trial(&trials->trials[index], options);
    pthread_mutex_lock(&trials->lock);
    trials->done++;
    if (options->progress)
        options->progress(options->context, trials->done, trials->count);
    pthread_mutex_unlock(&trials->lock);
}

/* How many seeds the checks of a case ask a variant for. */
static int seeds_of(const Verification *verification, size_t variant) {
    int most = 0;
    for (size_t c = 0; c < verification->check_count; c++) {
        const VerificationCheck *check = &verification->checks[c];
        bool asks = check->sides[0] == variant || (check->is_ratio && check->sides[1] == variant);
        most = asks && check->seeds > most ? check->seeds : most;
    }
    return most;
}

static void add_trials(Trials *trials, size_t *capacity, Verification *verification) {
    for (size_t v = 0; v < verification->variant_count && verification->applies; v++) {
        const char **settings;
        size_t setting_count = verification_settings(verification, &verification->variants[v], &settings);
        int seeds = seeds_of(verification, v);
        for (int seed = 0; seed < seeds; seed++) {
            trials->trials = memory_reserve(trials->trials, capacity, trials->count + 1, sizeof *trials->trials);
            trials->trials[trials->count++] = (Trial){
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

/* The mean over the seeds of one side of a check. False: not all of it has been run. */
static bool mean_of(double *mean, VerificationCheck *check, size_t c, int side, const Verification *verification,
                    const Trials *trials) {
    int found = 0;
    *mean = 0;
    for (size_t t = 0; t < trials->count; t++) {
        const Trial *trial = &trials->trials[t];
        if (trial->verification != verification || !trial->done || !concerns(check, side, trial))
            continue;
        const MeasureAnswer *answer = &trial->answers[2 * c + (size_t)side];
        *mean += answer->value / check->seeds;
        found++;
        if (!*check->note)
            snprintf(check->note, sizeof check->note, "%s", answer->note);
    }
    return found == check->seeds;
}

static void judge(VerificationCheck *check, size_t c, const Verification *verification, const Trials *trials) {
    double value, other = 1;
    check->value = (double)NAN;
    check->verdict = VERDICT_NOT_RUN;
    *check->note = 0;
    if (!mean_of(&value, check, c, 0, verification, trials) ||
        (check->is_ratio && !mean_of(&other, check, c, 1, verification, trials)))
        return;
    check->value = value / other;
    check->verdict = check->value >= check->low && check->value <= check->high ? VERDICT_PASSED : VERDICT_FAILED;
}

/* The same house is wrong in the same way with every seed. */
static void add_new_faults(Fault *fault, const Fault *more) {
    for (size_t l = 0; l < more->count; l++) {
        bool known = false;
        for (size_t k = 0; k < fault->count && !known; k++)
            known = strcmp(fault->lines[k], more->lines[l]) == 0;
        if (!known)
            fault_add(fault, "%s", more->lines[l]);
    }
}

void trial_run(Verification *cases, size_t count, const TrialOptions *options, Fault *fault) {
    Trials trials = {.options = options, .lock = PTHREAD_MUTEX_INITIALIZER};
    size_t capacity = 0;
    for (size_t i = 0; i < count; i++)
        add_trials(&trials, &capacity, &cases[i]);
    parallel_for(options->jobs, trials.count, run_one, &trials);
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < cases[i].check_count; c++)
            judge(&cases[i].checks[c], c, &cases[i], &trials);
    for (size_t t = 0; t < trials.count; t++) {
        Trial *trial = &trials.trials[t];
        add_new_faults(fault, &trial->fault);
        fault_clear(&trial->fault);
        memory_free(trial->answers);
    }
    memory_free(trials.trials);
}

Verdict trial_verdict(const Verification *verification) {
    if (!verification->applies)
        return VERDICT_DOES_NOT_APPLY;
    Verdict verdict = VERDICT_PASSED;
    for (size_t c = 0; c < verification->check_count; c++) {
        Verdict one = verification->checks[c].verdict;
        if (one == VERDICT_FAILED)
            return VERDICT_FAILED;
        verdict = one == VERDICT_NOT_RUN ? one : verdict;
    }
    return verdict;
}
