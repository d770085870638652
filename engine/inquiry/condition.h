/* A condition on what a run shows: a measure between two limits. Verification cases and the goals of lessons are lists
 * of conditions; both are read and judged here. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/parameters.h"
#include "inquiry/measure.h"

typedef enum Verdict {
    VERDICT_NOT_RUN, /* interrupted, or the house cannot be read */
    VERDICT_PASSED,
    VERDICT_FAILED,
    VERDICT_DOES_NOT_APPLY,
} Verdict;

typedef struct Condition {
    const char *measure_name;
    const char *title; /* question in words, or "" */
    MeasureQuestion question;
    double low, high;       /* in `unit`, both inclusive; infinite: no limit */
    const char *unit;       /* "1" of a number or a ratio */
    const char *why;        /* text for a condition that does not hold */
    const Measure *measure; /* NULL: a value that no run of a house has, such as a beam's */
    Verdict verdict;
    double value;   /* NAN: none */
    char note[200]; /* note of the measure */
} Condition;

#define CONDITION_TEXT(struct_, field_, name_, kind_, needed_, meaning_)                                               \
    {                                                                                                                  \
        .name = name_, .kind = kind_, .offset = offsetof(struct_, field_), .unit = "", .needed = needed_,              \
        .meaning = meaning_                                                                                            \
    }
#define CONDITION_NUMBER(struct_, field_, name_, unit_, low_, high_, fallback_, meaning_)                              \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_NUMBER, .offset = offsetof(struct_, field_), .unit = unit_, .low = low_,      \
        .high = high_, .fallback = fallback_, .meaning = meaning_                                                      \
    }
#define CONDITION_POINTS(struct_, field_, name_, least_, meaning_)                                                     \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_POINTS, .offset = offsetof(struct_, field_), .unit = "m", .low = least_,      \
        .meaning = meaning_                                                                                            \
    }

/* Rows for a table of a struct with a Condition `field_`. */
#define CONDITION_ROWS(struct_, field_)                                                                                \
    CONDITION_TEXT(struct_, field_.measure_name, "measure", PARAMETER_TEXT, true, "name of the measure"),              \
        CONDITION_TEXT(struct_, field_.title, "title", PARAMETER_TEXT, false, "question in words"),                    \
        CONDITION_TEXT(struct_, field_.question.of, "of", PARAMETER_IDS, false,                                        \
                       "people and crowds; absent: all people"),                                                       \
        CONDITION_TEXT(struct_, field_.question.past, "past", PARAMETER_IDS, false,                                    \
                       "people and crowds who are overtaken"),                                                         \
        CONDITION_TEXT(struct_, field_.question.exit, "exit", PARAMETER_ID, false, "exit of the people"),              \
        CONDITION_POINTS(struct_, field_.question.line, "line", 2,                                                     \
                         "line that people cross, from one end to the other"),                                         \
        CONDITION_POINTS(struct_, field_.question.area, "area", 3, "outline of the measured area"),                    \
        CONDITION_NUMBER(struct_, field_.question.width, "width", "m", 0, 1e4, 0,                                      \
                         "width of the bottleneck; absent: the exit's or line's length"),                              \
        CONDITION_NUMBER(struct_, field_.question.from, "from", "s", 0, 1e6, 0, "beginning of the measurement"),       \
        CONDITION_NUMBER(struct_, field_.question.until, "until", "s", 0, 1e6, 0, "end of the measurement"),           \
        CONDITION_NUMBER(struct_, field_.question.first, "first", "1", 0, 1, 0,                                        \
                         "share of people who pass before the flow is measured"),                                      \
        CONDITION_NUMBER(struct_, field_.question.last, "last", "1", 0, 1, 1,                                          \
                         "share of people who pass until the flow is no longer measured"),                             \
        CONDITION_NUMBER(struct_, field_.low, "low", "", -1e9, 1e9, -HUGE_VAL, "lower limit"),                         \
        CONDITION_NUMBER(struct_, field_.high, "high", "", -1e9, 1e9, HUGE_VAL, "upper limit"),                        \
        CONDITION_TEXT(struct_, field_.unit, "unit", PARAMETER_TEXT, true,                                             \
                       "unit of the limits, 1 of a number or a ratio"),                                                \
        CONDITION_TEXT(struct_, field_.why, "why", PARAMETER_TEXT, false, "text for a check that is not passed")

/* Finds the measure by its name. NULL: a fault at the node's "measure" names the nearest of the measures and of the
 * `more` names (count). */
const Measure *condition_find(Condition *condition, const char *const *more, size_t count, const JsonNode *node,
                              Fault *fault);

/* Adds a fault for a unit that is not `expected`, for missing or crossed limits, and for what the measure needs. */
void condition_check_unit(const Condition *condition, const char *expected, const JsonNode *node, Fault *fault);
void condition_check_limits(const Condition *condition, const char *what, const JsonNode *node, Fault *fault);
void condition_check_needs(const Condition *condition, const JsonNode *node, Fault *fault);

/* Adds a fault for people, crowds and exits that the plan does not have. */
void condition_check_people(const Ids *ids, const char *key, const Plan *plan, const JsonNode *node, Fault *fault);
void condition_check_exit(const Condition *condition, const Plan *plan, const JsonNode *node, Fault *fault);

/* Sets the value, and the verdict by the limits; without a value it fails. */
void condition_judge(Condition *condition, double value);
