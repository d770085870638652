/* The part of a report about its basis: the methods, the input numbers with the source of each, and how to make the
 * report again. */
#pragma once

#include "document/document.h"
#include "house/observation.h"

/* The origin of a report. */
typedef struct Making {
    const char *command;         /* that makes it, to be pasted */
    const char *program;         /* with its version */
    const char *const *settings; /* (setting_count) NAME=VALUE, the changes that the command makes to the files */
    size_t setting_count;
} Making;

/* A house and its results; none if `house` is NULL. Not owned. */
typedef struct Reported {
    const House *house;
    const Observation *observation;
} Reported;

/* Adds the settings that differ from the files, next to the answer. */
void report_basis_add_changes(Document *document, const Making *making);

/* Adds the methods, with the driving models that occur in the house, or both. */
void report_basis_add_method(Document *document, const House *house, bool both_ways);
void report_basis_add_settings(Document *document, const House *house);
void report_basis_add_profile(Document *document, const House *house, const Profile *profile);

/* Adds command and version; seed, step and digest of each of `count` runs. */
void report_basis_add_making(Document *document, const Making *making, const Reported *runs, size_t count);

/* Says which ids of doors and people the names in the report stand for. */
void report_basis_add_names(Document *document, const House *house);
