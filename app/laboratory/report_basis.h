/* The part of a report about what it rests on: how things are computed, which numbers went in and where each comes
 * from, and how to make the same report again. */
#pragma once

#include "document/document.h"
#include "house/observation.h"

/* With the ways of getting about that there are in the house, or both of driving. */
void report_basis_add_method(Document *document, const House *house, bool both_ways);
void report_basis_add_settings(Document *document, const House *house);
void report_basis_add_profile(Document *document, const House *house, const Profile *profile);

/* Command, version, seed, step and digests; `observations` of as many houses. */
void report_basis_add_making(Document *document, const char *command, const char *program, const House *const *houses,
                             const Observation *const *observations, size_t count);
