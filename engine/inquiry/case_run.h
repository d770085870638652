/* Runs the variants of houses that the checks of verification cases need, each once per seed, and judges the checks. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/stop.h"
#include "inquiry/verification.h"

typedef struct CaseRunOptions {
    const char *profiles; /* directory of the shipped profiles */
    uint64_t seed;        /* first seed */
    int jobs;             /* number of threads */
    const Stop *stop;
    void (*progress)(void *context, size_t done,
                     size_t all); /* number of runs; called from one thread at a time; NULL: none */
    void *context;
} CaseRunOptions;

/* Fills in verdicts and values of all checks of all cases (count). Some errors of a house are only found here (its
 * people cannot be placed, or a profile is missing): they go to `fault`, and its checks are not run. The same seed
 * gives the same values for any number of jobs. */
void case_run_all(Verification *cases, size_t count, const CaseRunOptions *options, Fault *fault);

/* Returns the verdict of the whole case: failed if a check failed, passed if all passed. */
Verdict case_run_verdict(const Verification *verification);
