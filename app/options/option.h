/* The options of the command line as data: one row each. Reading, checking and `--help` follow from the rows; they hold
 * all that a manual page and the completion of a shell need, too. */
#pragma once

#include "options/options.h"
#include "options/verb.h"

typedef enum OptionKind {
    OPTION_FLAG,   /* bool; takes no value */
    OPTION_WHOLE,  /* int or uint64_t, from low to high */
    OPTION_NUMBER, /* double, from low to high */
    OPTION_CHOICE, /* int: the index of the value among `words` */
    OPTION_TEXT,   /* const char *, not empty */
    OPTION_FILE,   /* as OPTION_TEXT; `words` are the endings of the file, or NULL for any */
    OPTION_FOLDER, /* as OPTION_TEXT */
    OPTION_NAME,   /* read by `read`; the value begins with the name of a parameter, as --set takes it */
    OPTION_READ,   /* read by `read` */
    OPTION_MAYBE,  /* as OPTION_READ; the value, which begins with a digit, may be absent: then `read` takes NULL */
} OptionKind;

/* Under which heading --help lists an option, in this order. */
typedef enum OptionGroup {
    GROUP_INPUT,
    GROUP_SIMULATION,
    GROUP_STUDY,
    GROUP_OUTPUT,
    GROUP_PICTURES,
    GROUP_FILM,
    GROUP_WINDOW,
    GROUP_PROGRAM,
    OPTION_GROUPS
} OptionGroup;

typedef struct Option {
    const char *name; /* "--seed" */
    OptionKind kind;
    size_t offset, size;  /* bytes, of its field in Options; 0 where `read` takes the value */
    double low, high;     /* of a number, both ends allowed; equal: no range */
    const char *argument; /* placeholder, "N"; NULL: none */
    const char *help;     /* begins in lower case and has no full stop */
    OptionGroup group;
    int verbs;         /* FOR_..., those that take it */
    const char *words; /* separated by | (one of them) or , (a list of them); NULL: none */
    bool (*read)(Options *options, const char *value); /* false: `argument` does not describe the value */
} Option;

/* (option_count) at most OPTIONS_MOST; one name may stand in several rows, for different verbs. */
extern const Option option_rows[];
extern const size_t option_count;

/* "Pictures" */
const char *option_group_name(OptionGroup group);

/* The row of that name (`length` characters) among those of a verb, or NULL. */
const Option *option_find(VerbId verb, const char *name, size_t length);

/* The names of a verb's options into `names` (OPTIONS_MOST); how many. */
size_t option_names(VerbId verb, const char **names);

/* The words of a choice into `words` (at most OPTION_WORDS), which the arena keeps; how many. */
enum { OPTION_WORDS = 16 };
size_t option_words(const Option *option, const char **words, Arena *arena);

/* Takes a value (NULL for a flag) into the row's field. False: `argument` does not describe it. */
bool option_take(const Option *option, Options *options, const char *value);
