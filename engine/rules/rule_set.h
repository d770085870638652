/* Rules of accessibility as data: sets of least and greatest dimensions, each with its clause, its source and how well
 * that source is known, read from assets/rules. A set is no legal advice; its note says what it does not check.
 *
 * A source counts as read only when the text itself was read. Anything else is shown in grey, with its word. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "plan/work.h"

/* The subject of a rule; the headers of this folder tell how each is measured. */
typedef enum RuleWhat {
    RULE_CORRIDOR_WIDTH,
    RULE_DOOR_CLEAR,
    RULE_MANOEUVRE,
    RULE_LATCH_SPACE,
    RULE_TURNING_CIRCLE,
    RULE_TURNING_SQUARE,
    RULE_TURNING_PLACE,
    RULE_TURN_ROUND,
    RULE_STEP_HEIGHT,
    RULE_SLOPE,
    RULE_WHATS
} RuleWhat;

#define RULE_WHAT_WORDS                                                                                                \
    "corridor_width|door_clear|manoeuvre|latch_space|turning_circle|turning_square|turning_place|turn_180|"            \
    "step_height|slope"

typedef enum RuleStatus { STATUS_READ, STATUS_SECOND_HAND, STATUS_KNOWN, STATUS_ASSUMED } RuleStatus;

#define RULE_STATUS_WORDS "read|read second-hand|known|assumed"

typedef enum RuleDoors { DOORS_ALL, DOORS_INNER, DOORS_ENTRANCE } RuleDoors;
typedef enum RuleApproach { APPROACH_ANY, APPROACH_FRONT, APPROACH_HINGE, APPROACH_LATCH } RuleApproach;
typedef enum RuleSide { SIDE_BOTH, SIDE_PULL, SIDE_PUSH } RuleSide;
typedef enum RuleKind { KIND_ANY, KIND_HINGED, KIND_SLIDING } RuleKind;
typedef enum RuleCloser { CLOSER_ANY, CLOSER_WITH, CLOSER_WITHOUT } RuleCloser;

/* Where a rule holds; all of it must be true. Rooms are found by a part of their name or id, without regard to case. */
typedef struct RuleWhere {
    const char *room, *not_room; /* "": any */
    int doors;                   /* RuleDoors */
    int kind;                    /* RuleKind of the doors */
    int approach;                /* RuleApproach: see doorway.h */
    int closer;                  /* RuleCloser: a door that closes by itself needs more space before it */
    int side;                    /* RuleSide: the leaf opens towards a person who pulls */
    double space_least;          /* m: the space in front of the door is at least as deep */
    double space_below;          /* m: and less than this */
} RuleWhere;

/* A narrower stretch that a rule on corridors allows. */
typedef struct RulePillar {
    double least;   /* m; 0: none */
    double longest; /* m, of the way */
} RulePillar;

/* A narrower corridor that is enough with a free square each `each` m of the way. */
typedef struct RulePlaces {
    double least;  /* m; 0: none */
    double square; /* m, its side */
    double each;   /* m, of the way */
} RulePlaces;

/* Rails: so much of what stands out from either wall does not narrow a corridor. */
typedef struct RuleRails {
    double each_side; /* m; 0: the rule does not mention rails */
    int status;       /* RuleStatus of that number */
} RuleRails;

/* A turn by 180 degrees round an obstacle; the rule's `least` is for the paths to and from it. */
typedef struct RuleTurn {
    double at_turn;  /* m, between the obstacle's end and the wall opposite */
    double instead;  /* m, there: enough by itself, whatever the paths have; 0: nothing is */
    double narrower; /* m: the obstacle is narrower than this */
} RuleTurn;

typedef struct Rule {
    const char *id;
    int what;           /* RuleWhat */
    double least, most; /* m, or 1 of a slope; exactly one of them is not negative */
    double beyond;      /* m, of a manoeuvring space: beside the opening; `least` is its depth */
    bool at_hinge;      /* True if `beyond` lies beside the hinge instead of the latch */
    double each;        /* m of the way, of turning places */
    RulePillar pillar;
    RulePlaces places;
    RuleRails rails;
    RuleTurn turn;
    RuleWhere where;
    const char *clause;
    const char *source;
    int status; /* RuleStatus */
} Rule;

/* A statement about a kind of work: it is paid for, or not listed. */
typedef struct RulePay {
    int change;            /* PlanWork */
    int pays;              /* RulePays */
    const char *condition; /* "if a sliding door replaces it", or "" */
    const char *clause;
    const char *source;
    int status; /* RuleStatus */
} RulePay;

typedef enum RulePays { PAYS_PAYABLE, PAYS_NOT_LISTED } RulePays;

#define RULE_PAYS_WORDS "payable|not listed"

typedef struct RuleSet {
    const char *id;
    const char *title;
    const char *jurisdiction;
    const char *applies;
    const char *edition;
    const char *note; /* what is not checked */
    Rule *rules;      /* (count) */
    size_t count;
    RulePay *pays; /* (pay_count), at most one for each change */
    size_t pay_count;
} RuleSet;

/* A zeroed list is empty; rule_set_free_all releases it. */
typedef struct RuleSets {
    RuleSet *sets; /* (count) in the order of reading */
    size_t count, capacity;
    Arena arena;
} RuleSets;

/* Adds the set of a file. Returns false after an error, with the list unchanged. */
bool rule_set_read(RuleSets *sets, const char *path, Fault *fault);

/* Does the same with each name of `names` (ID,ID or files, or mixed; NULL: all of the folder, by name): an id is the
 * file ID.json of the folder, a file is a name with a / or ending in .json. */
bool rule_set_read_all(RuleSets *sets, const char *folder, const char *names, Fault *fault);

void rule_set_free_all(RuleSets *sets);

/* Returns what a set says about paying for a kind of work, or NULL. */
const RulePay *rule_set_pay(const RuleSet *set, int change);

/* Returns "payable", "corridor width", and "read second-hand". */
const char *rule_set_pays_name(int pays);
const char *rule_set_what_name(int what);
const char *rule_set_status_name(int status);

/* Returns the JSON Schema of a file of rules. New. */
json_t *rule_set_schema(void);
