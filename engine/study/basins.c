#include "study/basins.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/real.h"
#include "study/types.h"

bool basins_exist(const Study *study) {
    bool afresh = false;
    for (size_t pass = 0; pass < study->pass_count; pass++)
        afresh |= study->passes[pass] == STUDY_RESET;
    return afresh && study->axis_count == 1 && study->runs > 1 && !study->spread_count &&
           study->experiment->verdict_count;
}

/* Tells a trial; false: it has no answer. */
static bool tell(const Study *study, const Trial *trial, Basin *basin) {
    const Experiment *experiment = study->experiment;
    double verdict = trial->observed[experiment->verdict], regular = trial->observed[experiment->regular];
    if (!trial->done || trial->fault || isnan(verdict) || isnan(regular))
        return false;
    *basin = (Basin){.verdict = (int)verdict, .regular = regular > 0};
    basin->measure = trial->observed[experiment->measure];
    basin->outcome = basin->regular ? trial->observed[experiment->outcome] : 0;
    basin->contact = basin->measure > 0;
    return true;
}

static bool is_same(const Basin *a, const Basin *b) {
    if (a->regular != b->regular || a->verdict != b->verdict || a->outcome != b->outcome)
        return false;
    return !a->regular || fabs(a->measure - b->measure) <= TYPES_SAME * fabs(a->measure);
}

static Basin *find(Basins *basins, const Basin *told) {
    for (size_t i = 0; i < basins->count; i++)
        if (is_same(&basins->of[i], told))
            return &basins->of[i];
    if (basins->count == BASINS_MOST)
        return NULL;
    basins->of[basins->count] = *told;
    return &basins->of[basins->count++];
}

/* Adds the answer from the special start. */
static void add_special(Basins *basins, const Study *study, size_t step) {
    const Experiment *experiment = study->experiment;
    double at = study_value(&study->axes[0], step);
    double *observed = memory_zeroed(experiment->observable_count, sizeof *observed);
    Trial trial = {.at = &at, .observed = observed, .seed = experiment->special};
    if (experiment->special && !experiment->slow) {
        Basin told, *known;
        experiment->run(experiment->given, &(const char *){study->axes[0].name}, 1, &trial, 1, false, NULL);
        known = tell(study, &trial, &told) ? find(basins, &told) : NULL;
        if (known)
            known->others++;
        trial_clear(&trial);
    }
    memory_free(observed);
}

/* The largest share first, then the largest measure. */
static int compare(const void *a, const void *b) {
    const Basin *p = a, *q = b;
    if (p->share.good != q->share.good)
        return p->share.good < q->share.good ? 1 : -1;
    return (p->measure < q->measure) - (p->measure > q->measure);
}

Basins basins_at(const Study *study, size_t step) {
    Basins basins = {.count = 0};
    for (size_t pass = 0; pass < study->pass_count; pass++)
        for (size_t run = 0; run < study->runs; run++) {
            Basin told, *known;
            if (!tell(study, study_trial(study, pass, run, 0, step), &told))
                continue;
            bool afresh = study->passes[pass] == STUDY_RESET;
            basins.starts += afresh;
            known = find(&basins, &told);
            if (known && afresh)
                known->share.good++;
            else if (known)
                known->others++;
        }
    add_special(&basins, study, step);
    for (size_t i = 0; i < basins.count; i++)
        basins.of[i].share = montecarlo_share(basins.of[i].share.good, basins.starts);
    qsort(basins.of, basins.count, sizeof *basins.of, compare);
    basins.unseen_below = basins.starts ? 1 - real_exp(real_log(0.05) / (double)basins.starts) : 1;
    return basins;
}

void basins_name(const Study *study, const Basin *basin, char *name, size_t size) {
    if (basin->regular && !basin->contact)
        snprintf(name, size, "no contact");
    else if (basin->outcome > 0)
        snprintf(name, size, "period %g", basin->outcome);
    else
        snprintf(name, size, "%s", study->experiment->verdicts[basin->verdict]);
}
