/* Cases of public verification suites (RiMEA, IMO, NIST): a case file names a house, perhaps with variants, and checks:
 * a measure and its limits. A check may compare two variants or two groups of people, and may be the mean over several
 * seeds. A case that does not apply gives the reason.
 *
 *     {"format": "clearance-case", "version": 1, "id": "rimea-01", "suite": "RiMEA 1", "title": "...", "note": "...",
 *      "house": "houses/corridor.json",
 *      "variants": [{"id": "wide", "house": "houses/wide.json", "set": "crowd.c1.count=20 run.until=300"}],
 *      "checks": [{"measure": "time", "of": ["p1"], "low": 26, "high": 34, "unit": "s", "seeds": 3}]}
 *
 * The value of a check with `than`, `than_of` or `than_area` is the ratio of the measure to the same measure of the
 * other variant, group or area. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "inquiry/condition.h"

typedef struct VerificationVariant {
    const char *id;
    const char *house; /* path relative to the case file; "": the house of the case */
    const char *set;   /* NAME=VALUE NAME=VALUE ..., as with --set */
} VerificationVariant;

typedef struct VerificationCheck {
    Condition condition; /* its question is that for the variant */
    const char *variant; /* id; "": the unchanged house of the case */
    const char *than;    /* id of the variant to compare with, or "" */
    Ids than_of;         /* replaces question.of for the other side */
    Points than_area;    /* m, replaces question.area for the other side */
    int seeds;           /* number of seeds of the mean */
    bool is_ratio;
    size_t
        sides[2]; /* indices of the variant and of the one compared with: 0 the house of the case, then its variants */
} VerificationCheck;

typedef struct Verification {
    const char *path; /* path of the case file */
    const char *id;
    const char *suite;
    const char *title;
    const char *note;
    const char *house; /* path relative to the case file */
    bool applies;
    const char *reason;            /* why the case does not apply */
    VerificationVariant *variants; /* (variant_count); the first is the unchanged house of the case */
    VerificationCheck *checks;     /* (check_count) */
    size_t variant_count, check_count;
    Arena arena;
} Verification;

/* Reads a case file and checks it against its houses. Returns false after an error, with the case unchanged. */
bool verification_read(Verification *verification, const char *path, Fault *fault);
void verification_free(Verification *verification);

/* Splits the settings of a variant; the case owns them. Returns their number. */
size_t verification_settings(Verification *verification, const VerificationVariant *variant, const char ***settings);
