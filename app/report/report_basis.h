/* The part of a report about what it rests on: how things are computed, which numbers went in and where each comes
 * from, and how to make the same report again. */
#pragma once

#include "document/document.h"
#include "house/observation.h"

/* How a report came about. */
typedef struct Making {
    const char *command;         /* that makes it, to be pasted */
    const char *program;         /* with its version */
    const char *const *settings; /* (setting_count) NAME=VALUE, what the command changes in the files */
    size_t setting_count;
} Making;

/* A house and what came of it; nothing when `house` is NULL. Not owned. */
typedef struct Reported {
    const House *house;
    const Observation *observation;
} Reported;

/* What is not as the files have it: to be said where the answer is. */
void report_basis_add_changes(Document *document, const Making *making);

/* With the ways of getting about that there are in the house, or both of driving. */
void report_basis_add_method(Document *document, const House *house, bool both_ways);
void report_basis_add_settings(Document *document, const House *house);
void report_basis_add_profile(Document *document, const House *house, const Profile *profile);

/* Command and version; seed, step and digest of each of `count` runs. */
void report_basis_add_making(Document *document, const Making *making, const Reported *runs, size_t count);
