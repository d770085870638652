#include "study/bunch.h"

#include <math.h>

Bunch bunch_create(const Experiment *experiment, const char *const *names, size_t name_count, size_t count) {
    size_t observables = experiment->observable_count;
    Bunch bunch = {.trials = memory_zeroed(count, sizeof(Trial)),
                   .count = count,
                   .name_count = name_count,
                   .at = memory_zeroed(count * name_count, sizeof(double)),
                   .observed = memory_zeroed(count * observables, sizeof(double))};
    for (size_t i = 0; i < count; i++) {
        bunch.trials[i] = (Trial){.at = bunch.at + i * name_count, .observed = bunch.observed + i * observables};
        for (size_t n = 0; n < name_count; n++)
            bunch_set(&bunch, i, n, experiment->nominal(experiment->given, names[n]));
        for (size_t k = 0; k < observables; k++)
            bunch.trials[i].observed[k] = NAN;
    }
    return bunch;
}

void bunch_clear(Bunch *bunch) {
    for (size_t i = 0; i < bunch->count; i++)
        trial_clear(&bunch->trials[i]);
    memory_free(bunch->trials);
    memory_free(bunch->at);
    memory_free(bunch->observed);
    *bunch = (Bunch){0};
}
