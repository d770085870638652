/* The verbs of the command line as data: one row each. What they do is in the table of command/command.c. */
#pragma once

#include <stddef.h>

typedef enum VerbId {
    VERB_OPEN,
    VERB_RUN,
    VERB_CHECK,
    VERB_COMPARE,
    VERB_ABLATE,
    VERB_STUDY,
    VERB_LOCI,
    VERB_FIT,
    VERB_RULES,
    VERB_CASES,
    VERB_LESSON,
    VERB_IMPORT,
    VERB_EXPORT,
    VERB_SCHEMA,
    VERB_HELP,
    VERBS
} VerbId;

/* The verbs as bits, for the options that they take. */
enum {
    FOR_OPEN = 1 << VERB_OPEN,
    FOR_RUN = 1 << VERB_RUN,
    FOR_CHECK = 1 << VERB_CHECK,
    FOR_COMPARE = 1 << VERB_COMPARE,
    FOR_ABLATE = 1 << VERB_ABLATE,
    FOR_STUDY = 1 << VERB_STUDY,
    FOR_LOCI = 1 << VERB_LOCI,
    FOR_FIT = 1 << VERB_FIT,
    FOR_RULES = 1 << VERB_RULES,
    FOR_CASES = 1 << VERB_CASES,
    FOR_LESSON = 1 << VERB_LESSON,
    FOR_IMPORT = 1 << VERB_IMPORT,
    FOR_EXPORT = 1 << VERB_EXPORT,
    FOR_HOUSES = FOR_RUN | FOR_CHECK | FOR_COMPARE | FOR_ABLATE | FOR_LOCI | FOR_STUDY | FOR_RULES | FOR_FIT,
    FOR_FILMS = FOR_RUN | FOR_COMPARE
};

typedef struct Verb {
    const char *name;
    size_t least_files, most_files; /* SIZE_MAX: any number */
    const char *usage;              /* placeholders of its files: "HOUSE|BEAM" */
    const char *endings;            /* of its files, separated by commas: ".json"; "" for words */
    const char *words;              /* that may stand in place of a file, separated by |; or "" */
    const char *meaning;            /* sentences */
    const char *examples;           /* command lines, each ended by a line break */
} Verb;

/* (VERBS) by VerbId */
extern const Verb verb_rows[];

/* The row of that name, or NULL. */
const Verb *verb_find(const char *name);
