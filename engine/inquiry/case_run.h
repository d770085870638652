/* Runs what the checks of verification cases ask for, each variant of a house with each seed once, and judges them. */
#pragma once

#include <signal.h>
#include <stddef.h>
#include <stdint.h>

#include "base/fault.h"
#include "inquiry/verification.h"

typedef struct CaseRunOptions {
    const char *profiles; /* directory of the shipped profiles */
    uint64_t seed;        /* the first */
    int jobs;             /* threads */
    const volatile sig_atomic_t *stop;
    void (*progress)(void *context, size_t done, size_t all); /* runs; from one thread at a time; NULL: none */
    void *context;
} CaseRunOptions;

/* Fills verdicts and values of all checks of all cases (count). A house whose people cannot be placed, or whose profile
 * is missing, shows only here: that goes to `fault`, and its checks are not run. The same seed gives the same values
 * for any number of jobs. */
void case_run_all(Verification *cases, size_t count, const CaseRunOptions *options, Fault *fault);

/* The whole case: failed when a check is, passed when all are. */
Verdict case_run_verdict(const Verification *verification);
