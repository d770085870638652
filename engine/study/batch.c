#include "study/batch.h"

#include <math.h>

Batch batch_create(const Experiment *experiment, const char *const *names, size_t name_count, size_t count) {
    size_t observables = experiment->observable_count;
    Batch batch = {.trials = memory_zeroed(count, sizeof(Trial)),
                   .count = count,
                   .name_count = name_count,
                   .at = memory_zeroed(count * name_count, sizeof(double)),
                   .observed = memory_zeroed(count * observables, sizeof(double))};
    for (size_t i = 0; i < count; i++) {
        batch.trials[i] = (Trial){.at = batch.at + i * name_count, .observed = batch.observed + i * observables};
        for (size_t n = 0; n < name_count; n++)
            batch_set(&batch, i, n, experiment->nominal(experiment->given, names[n]));
        for (size_t k = 0; k < observables; k++)
            batch.trials[i].observed[k] = NAN;
    }
    return batch;
}

void batch_clear(Batch *batch) {
    for (size_t i = 0; i < batch->count; i++)
        trial_clear(&batch->trials[i]);
    memory_free(batch->trials);
    memory_free(batch->at);
    memory_free(batch->observed);
    *batch = (Batch){0};
}
