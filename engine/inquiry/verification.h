/* Cases of public verification suites (RiMEA, IMO, NIST): a case file names a house, perhaps with variants, and checks:
 * a measure and the limits within which it has to be. A check may compare two variants or two groups of people, and be
 * the mean over several seeds. A case that cannot apply says why.
 *
 *     {"format": "clearance-case", "version": 1, "id": "rimea-01", "suite": "RiMEA 1", "title": "...", "note": "...",
 *      "house": "houses/corridor.json",
 *      "variants": [{"id": "wide", "house": "houses/wide.json", "set": "crowd.c1.count=20 run.until=300"}],
 *      "checks": [{"measure": "time", "of": ["p1"], "low": 26, "high": 34, "unit": "s", "seeds": 3}]}
 *
 * The value of a check with `than`, `than_of` or `than_area` is the ratio of the measure to the same measure of that
 * other variant, group or area. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"
#include "inquiry/measure.h"

typedef enum Verdict {
    VERDICT_NOT_RUN, /* interrupted, or a house that cannot be read */
    VERDICT_PASSED,
    VERDICT_FAILED,
    VERDICT_DOES_NOT_APPLY,
} Verdict;

typedef struct VerificationVariant {
    const char *id;
    const char *house; /* path relative to the case file; "": the case's */
    const char *set;   /* NAME=VALUE NAME=VALUE ..., as with --set */
} VerificationVariant;

typedef struct VerificationCheck {
    const char *measure_name;
    const char *title;        /* what is asked, or "" */
    const char *variant;      /* id; "": the case's house as it is */
    const char *than;         /* id of the variant to compare with, or "" */
    MeasureQuestion question; /* of the variant */
    Ids than_of;              /* instead of question.of in what is compared with */
    Points than_area;         /* m, instead of question.area */
    double low, high;         /* in the unit of the measure; of a ratio 1; infinite: no limit */
    const char *unit;
    int seeds;       /* over which the mean is taken */
    const char *why; /* said when the check is not passed */

    const Measure *measure;
    bool is_ratio;
    size_t sides[2]; /* the variant, and the one compared with: 0 the case's house, then its variants */
    Verdict verdict;
    double value;   /* NAN: none */
    char note[200]; /* from the measure */
} VerificationCheck;

typedef struct Verification {
    const char *path; /* of the case file */
    const char *id;
    const char *suite;
    const char *title;
    const char *note;
    const char *house; /* path relative to the case file */
    bool applies;
    const char *reason;            /* why not */
    VerificationVariant *variants; /* (variant_count); the first is the case's house as it is */
    VerificationCheck *checks;     /* (check_count) */
    size_t variant_count, check_count;
    Arena arena;
} Verification;

/* Reads a case file and checks it against its houses. On false faults say where and what, and the case is as it was. */
bool verification_read(Verification *verification, const char *path, Fault *fault);
void verification_free(Verification *verification);

/* The settings of a variant, one by one; kept by the case. Returns how many. */
size_t verification_settings(Verification *verification, const VerificationVariant *variant, const char ***settings);
