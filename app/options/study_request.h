/* The request for a study, read from the options of the command line. */
#pragma once

#include "base/memory.h"
#include "study/study.h"

typedef struct StudyRequest {
    StudyAxis axes[STUDY_AXES_MOST];
    size_t axis_count;
    StudySpread spreads[STUDY_SPREADS_MOST];
    size_t spread_count;
    StudyPass passes[STUDY_PASSES];
    size_t pass_count; /* 0: not given */
    uint64_t runs;     /* 0: not given */
    uint64_t shakes;   /* runs that begin with an earthquake; 0: none */
} StudyRequest;

/* Read NAME=FROM:TO:STEPS, NAME=SHARE, and a list of reset, up, down. False: the text is not of that form, or one too
 * many. The arena keeps the names. */
bool study_request_vary(StudyRequest *request, const char *words, Arena *arena);
bool study_request_spread(StudyRequest *request, const char *words, Arena *arena);
bool study_request_sweep(StudyRequest *request, const char *words);
