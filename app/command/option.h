/* The options of the command line: one row each, for the verbs that take it. */
#pragma once

#include "options/options.h"

/* The verbs, a bit each. */
enum {
    FOR_RUN = 1,
    FOR_CHECK = 2,
    FOR_COMPARE = 4,
    FOR_LOCI = 8,
    FOR_SCHEMA = 16,
    FOR_CASES = 32,
    FOR_STUDY = 64,
    FOR_OPEN = 128,
    FOR_IMPORT = 256,
    FOR_EXPORT = 512
};
enum { FOR_HOUSES = FOR_RUN | FOR_CHECK | FOR_COMPARE | FOR_LOCI | FOR_STUDY, FOR_FILMS = FOR_RUN | FOR_COMPARE };

typedef struct Option {
    const char *name;
    const char *argument; /* NULL: none */
    int marks;            /* the verbs that take it */
    const char *meaning;
    bool (*take)(Options *options, const char *value); /* false: `argument` does not describe the value */
} Option;

enum { OPTIONS_MOST = 64 };

/* (option_count) one name may stand in several rows, for different verbs. */
extern const Option option_rows[];
extern const size_t option_count;
