/* The request for a study, read from the options of the command line. */
#pragma once

#include "base/memory.h"
#include "study/study.h"

enum { STUDY_SHARDS_MOST = 100000, STUDY_SHARD_NAMED = 100 };

typedef struct StudyRequest {
    StudyAxis axes[STUDY_AXES_MOST];
    size_t axis_count;
    StudySpread spreads[STUDY_SPREADS_MOST];
    size_t spread_count;
    StudyPass passes[STUDY_PASSES];
    size_t pass_count; /* 0: not given */
    uint64_t runs;     /* 0: not given */
    uint64_t shakes;   /* runs that begin with an earthquake; 0: none */

    StudyShard shard;                    /* the part to run; count 0: none */
    char shard_named[STUDY_SHARD_NAMED]; /* the variables that named it, or "" */
    bool merge;                          /* join the files of all shards */
    bool no_series;                      /* the values that a run lists are not kept */
    bool no_run;                         /* without running what they lack */
    uint64_t print_shards;               /* number of shards to print scripts for; 0: none */
} StudyRequest;

/* Read NAME=FROM:TO:STEPS, NAME=SHARE, and a list of reset, up, down. False: the text is not of that form, or one too
 * many. The arena keeps the names. */
bool study_request_vary(StudyRequest *request, const char *words, Arena *arena);
bool study_request_spread(StudyRequest *request, const char *words, Arena *arena);
bool study_request_sweep(StudyRequest *request, const char *words);

/* Reads I/N; NULL: the variables that Slurm, Grid Engine or Open MPI set for a task of an array. False, too: there are
 * no such variables, or they do not number the tasks from 1 to N or from 0 to N - 1. */
bool study_request_shard(StudyRequest *request, const char *words);
