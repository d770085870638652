/* Summarises a study: where the response is regular, and where the measure is least or greatest. */
#pragma once

#include "study/study.h"

/* The state of a set of runs. */
typedef enum SummaryState {
    SUMMARY_NOTHING,   /* no run is done and valid */
    SUMMARY_REGULAR,   /* all whose response is known, at least half of the runs */
    SUMMARY_IRREGULAR, /* no run whose response is known */
    SUMMARY_MIXED,     /* some */
    SUMMARY_UNDECIDED, /* the response of most runs is undetermined */
} SummaryState;

/* "nothing", "regular", "not regular", "mixed", "cannot be told" */
const char *summary_state_name(SummaryState state);

typedef struct SummaryCount {
    size_t trials, done, faults;
    size_t regular, irregular, undecided; /* counts of valid completed runs */
} SummaryCount;

/* Neighbouring values of an axis with equal state. */
typedef struct SummaryRange {
    size_t first, last; /* steps of the axis */
    SummaryState state;
} SummaryRange;

/* Returns how many completed trials have each verdict of the experiment (verdict_count); the caller releases it. NULL:
 * it has none. */
size_t *summary_verdicts(const Study *study);

/* True if an observable is a class, whose values have neither a mean nor a spread. */
bool summary_is_class(const Experiment *experiment, size_t observable);

SummaryCount summary_count(const Study *study);

/* Returns the state of all runs of a point. */
SummaryState summary_point(const Study *study, size_t pass, size_t i1, size_t i0);

/* Returns the run of a point with the worst rank, the first one of those with the same; NULL: no run has one. */
const Trial *summary_worst_rank(const Study *study, size_t pass, size_t i1, size_t i0);

/* Returns the ranges of an axis from its first value to its last, each over all values of the other axis. The caller
 * releases them with memory_free. */
SummaryRange *summary_ranges(const Study *study, size_t pass, size_t axis, size_t *count);

/* True if the passes end in different responses at a point: one regular and another irregular, different outcomes,
 * or both regular with measures more than 1 % apart. Several responses then coexist, and the history decides between
 * them. */
bool summary_passes_differ(const Study *study, size_t i1, size_t i0);

/* Returns the index of the trial with the least or greatest measure, the first of equal ones, or SIZE_MAX. */
size_t summary_extreme(const Study *study, bool greatest);

/* Returns the digest of all results, bit for bit. */
uint64_t summary_digest(const Study *study);
