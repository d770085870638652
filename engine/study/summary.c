#include "study/summary.h"

#include <math.h>

#include "base/digest.h"
#include "base/memory.h"

const char *summary_state_name(SummaryState state) {
    static const char *const names[] = {[SUMMARY_NOTHING] = "nothing",
                                        [SUMMARY_REGULAR] = "regular",
                                        [SUMMARY_IRREGULAR] = "not regular",
                                        [SUMMARY_MIXED] = "mixed",
                                        [SUMMARY_UNDECIDED] = "cannot be told"};
    return names[state];
}

static void count_trial(SummaryCount *count, const Study *study, const Trial *trial) {
    double regular = trial->observed[study->experiment->regular];
    bool seen = trial->done && !trial->fault;
    count->trials++;
    count->done += trial->done;
    count->faults += trial->done && trial->fault;
    count->undecided += seen && isnan(regular);
    count->regular += seen && regular == 1;
    count->irregular += seen && !isnan(regular) && regular != 1;
}

SummaryCount summary_count(const Study *study) {
    SummaryCount count = {0};
    for (size_t t = 0; t < study->trial_count; t++)
        count_trial(&count, study, study_nth(study, t));
    return count;
}

size_t *summary_verdicts(const Study *study) {
    const Experiment *experiment = study->experiment;
    if (!experiment->verdict_count)
        return NULL;
    size_t *counts = memory_zeroed(experiment->verdict_count, sizeof *counts);
    for (size_t t = 0; t < study->trial_count; t++)
        if (!study->trials[t].fault && trial_verdict(&study->trials[t], experiment))
            counts[(size_t)study->trials[t].observed[experiment->verdict]]++;
    return counts;
}

bool summary_is_class(const Experiment *experiment, size_t observable) {
    return (experiment->verdict_count && observable == experiment->verdict) ||
           (experiment->rank_count && observable == experiment->rank) ||
           (experiment->periods && observable == experiment->outcome);
}

static SummaryState state_of(const SummaryCount *count) {
    if (count->undecided > count->regular + count->irregular)
        return SUMMARY_UNDECIDED;
    if (count->regular && count->irregular)
        return SUMMARY_MIXED;
    return count->regular ? SUMMARY_REGULAR : count->irregular ? SUMMARY_IRREGULAR : SUMMARY_NOTHING;
}

static void count_point(SummaryCount *count, const Study *study, size_t pass, size_t i1, size_t i0) {
    for (size_t run = 0; run < study->runs; run++)
        count_trial(count, study, study_trial(study, pass, run, i1, i0));
}

SummaryState summary_point(const Study *study, size_t pass, size_t i1, size_t i0) {
    SummaryCount count = {0};
    count_point(&count, study, pass, i1, i0);
    return state_of(&count);
}

SummaryRange *summary_ranges(const Study *study, size_t pass, size_t axis, size_t *count) {
    size_t steps = study_steps(study, axis), across = study_steps(study, 1 - axis);
    SummaryRange *ranges = memory_zeroed(steps, sizeof *ranges);
    *count = 0;
    for (size_t i = 0; i < steps; i++) {
        SummaryCount counted = {0};
        for (size_t k = 0; k < across; k++)
            count_point(&counted, study, pass, axis == 0 ? k : i, axis == 0 ? i : k);
        SummaryState state = state_of(&counted);
        if (*count && ranges[*count - 1].state == state)
            ranges[*count - 1].last = i;
        else
            ranges[(*count)++] = (SummaryRange){i, i, state};
    }
    return ranges;
}

const Trial *summary_worst_rank(const Study *study, size_t pass, size_t i1, size_t i0) {
    const Experiment *experiment = study->experiment;
    const Trial *worst = NULL;
    for (size_t run = 0; run < study->runs && experiment->rank_count; run++) {
        const Trial *trial = study_trial(study, pass, run, i1, i0);
        if (trial_rank(trial, experiment) &&
            (!worst || trial->observed[experiment->rank] > worst->observed[experiment->rank]))
            worst = trial;
    }
    return worst;
}

/* 1: relative difference below which measures belong to one response that is still settling */
static const double SAME_MEASURE = 0.01;

static bool answers_differ(const Experiment *experiment, const Trial *a, const Trial *b) {
    const double *x = a->observed, *y = b->observed;
    double regular = x[experiment->regular], other = y[experiment->regular];
    if (!a->done || !b->done || a->fault || b->fault || isnan(regular) || isnan(other))
        return false;
    if (regular != other || regular != 1)
        return regular != other;
    double measure = x[experiment->measure], apart = fabs(measure - y[experiment->measure]);
    return x[experiment->outcome] != y[experiment->outcome] || apart > SAME_MEASURE * fabs(measure);
}

bool summary_passes_differ(const Study *study, size_t i1, size_t i0) {
    for (size_t pass = 1; pass < study->pass_count; pass++)
        for (size_t run = 0; run < study->runs; run++)
            if (answers_differ(study->experiment, study_trial(study, 0, run, i1, i0),
                               study_trial(study, pass, run, i1, i0)))
                return true;
    return false;
}

size_t summary_extreme(const Study *study, bool greatest) {
    const Experiment *experiment = study->experiment;
    size_t found = SIZE_MAX;
    for (size_t t = 0; t < study->trial_count; t++) {
        const Trial *trial = study_nth(study, t);
        double measure = trial->observed[experiment->measure];
        if (!trial->done || trial->fault || isnan(measure))
            continue;
        double best = found < SIZE_MAX ? study_nth(study, found)->observed[experiment->measure] : 0;
        if (found == SIZE_MAX || (greatest ? measure > best : measure < best))
            found = t;
    }
    return found;
}

uint64_t summary_digest(const Study *study) {
    uint64_t digest = DIGEST_START;
    for (size_t t = 0; t < study->trial_count; t++) {
        const Trial *trial = study_nth(study, t);
        digest = digest_mix(digest, trial->done);
        digest = digest_bytes(digest, trial->at, study->name_count * sizeof *trial->at);
        digest = digest_bytes(digest, trial->observed, study->experiment->observable_count * sizeof *trial->observed);
        digest = digest_bytes(digest, trial->series, trial->series_count * sizeof *trial->series);
        digest = digest_text(digest, trial->fault ? trial->fault : "");
        digest = trial->note ? digest_text(digest, trial->note) : digest;
    }
    return digest;
}
