/* What a study shows as a whole: where the answer is regular and where not, and where the measure is best. */
#pragma once

#include "study/study.h"

/* Of all runs that were looked at. */
typedef enum SummaryState {
    SUMMARY_NOTHING,   /* none is done, or none could be run */
    SUMMARY_REGULAR,   /* all that can be told, at least half of them */
    SUMMARY_IRREGULAR, /* none of those */
    SUMMARY_MIXED,     /* some */
    SUMMARY_UNTOLD,    /* it cannot be told of most */
} SummaryState;

/* "nothing", "regular", "not regular", "mixed", "cannot be told" */
const char *summary_state_name(SummaryState state);

typedef struct SummaryCount {
    size_t trials, done, faults;
    size_t regular, irregular, untold; /* of those done without a fault */
} SummaryCount;

/* Neighbouring values of an axis with the same state. */
typedef struct SummaryRange {
    size_t first, last; /* steps of the axis */
    SummaryState state;
} SummaryRange;

SummaryCount summary_count(const Study *study);

/* Of all runs of a point. */
SummaryState summary_point(const Study *study, size_t pass, size_t i1, size_t i0);

/* The ranges of an axis, from its first value to its last, each over all that is beside the axis. memory_free them. */
SummaryRange *summary_ranges(const Study *study, size_t pass, size_t axis, size_t *count);

/* Do the passes end in different answers at a point: one regular and another not, other outcomes, or, both regular,
 * measures more than a hundredth apart? Then several answers exist there, and it depends on the past which one comes.
 */
bool summary_passes_differ(const Study *study, size_t i1, size_t i0);

/* The index of the trial whose measure is least, or greatest; the first of several. SIZE_MAX: there is none. */
size_t summary_extreme(const Study *study, bool greatest);

/* Of all results, bit for bit. */
uint64_t summary_digest(const Study *study);
