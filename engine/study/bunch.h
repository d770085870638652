/* Trials with the room of their numbers: a handful that is made at once, looked at and thrown away. */
#pragma once

#include "study/experiment.h"

typedef struct Bunch {
    Trial *trials; /* (count) */
    size_t count;
    size_t name_count;
    double *at;       /* (count x names) what the trials' `at` point at */
    double *observed; /* (count x observables) */
} Bunch;

/* Trials (count) of the nominal values of the names (name_count) and seed 0; bunch_clear releases them. */
Bunch bunch_create(const Experiment *experiment, const char *const *names, size_t name_count, size_t count);
void bunch_clear(Bunch *bunch);

/* Gives a trial its own value of one name. */
static inline void bunch_set(Bunch *bunch, size_t trial, size_t name, double value) {
    bunch->at[trial * bunch->name_count + name] = value;
}
