/* A batch of trials with the memory of their numbers: run together, read and released. */
#pragma once

#include "study/experiment.h"

typedef struct Batch {
    Trial *trials; /* (count) */
    size_t count;
    size_t name_count;
    double *at;       /* (count x names) memory of the trials' `at` */
    double *observed; /* (count x observables) */
} Batch;

/* Creates `count` trials with the nominal values of the names (name_count) and seed 0; the clear function releases
 * them. */
Batch batch_create(const Experiment *experiment, const char *const *names, size_t name_count, size_t count);
void batch_clear(Batch *batch);

/* Sets a trial's value of one name. */
static inline void batch_set(Batch *batch, size_t trial, size_t name, double value) {
    batch->at[trial * batch->name_count + name] = value;
}
