/* Holds the rules against a house: what each requires, what there is, and whether the people who live there get through
 * at the same place. Rules never change the simulation.
 *
 * Equal passes; a dimension may lack INSPECTION_TOLERANCE, since drawn coordinates are rounded. What the plan does not
 * hold, such as steps, cannot be told: it neither passes nor fails. */
#pragma once

#include "house/journey.h"
#include "rules/corridor.h"
#include "rules/doorway.h"
#include "rules/rule_set.h"
#include "rules/turning.h"

#define INSPECTION_TOLERANCE 0.00101 /* m: 1 mm, and what rounding may add to it */
#define INSPECTION_REFUSED 0.05      /* 1, assumed: share of drivers refused from which a place stops chairs */

typedef enum RuleVerdict { RULE_PASSES, RULE_FAILS, RULE_OPEN, RULE_VERDICTS } RuleVerdict;

/* A corridor, a door or a room, and the chairs of the plan's people there. */
typedef struct RulePlace {
    const char *name;  /* "corridor c1 (first leg)", "door d2", "room r1 (bath)" */
    Vec2 at;           /* m */
    size_t chairs;     /* chairs whose way to their exit leads here; 0: none */
    size_t stopped;    /* those of them that cannot pass here */
    size_t carried;    /* those of the stopped ones that a helper can lift and shift through: they fit */
    const char *who;   /* the first one that is stopped, or NULL */
    Blockage blockage; /* of that one */

    /* Counts of the drivers of a population; all are 0 if no drivers were tried. */
    size_t drivers;  /* whose way leads here */
    size_t refused;  /* those of them whose chair cannot be driven through here */
    size_t out;      /* those who get out of the house */
    size_t touching; /* those whose fastest impact is here */
    int grade;       /* GradeLetter of the tightest way here (inquiry/grade.h); -1: no way was graded */
    double to_next;  /* m per side, to the next better grade here; 0: there is none; NAN: not known */
} RulePlace;

typedef struct Finding {
    const RuleSet *set;
    const Rule *rule;
    size_t place;         /* index in places; SIZE_MAX: the whole house */
    int verdict;          /* RuleVerdict */
    int status;           /* RuleStatus of what decided: of the rule, or worse, of its number for rails */
    const char *why;      /* RULE_OPEN: the reason; otherwise what was measured ("depth"), or NULL */
    double requires, has; /* m; has is NAN when it cannot be told */
    bool at_most;         /* True if `has` must not exceed `requires`: a way without a place for turning */
    bool at_least;        /* True if there may be more: it was not looked further than needed */
    double furnished;     /* m, the width between furniture where it is less; NAN: not */
    bool drawn;           /* True if there is a line that was measured */
    Vec2 from, to;        /* m, its ends */
} Finding;

/* How the verdict of a rule and the chairs go together, in the order of a report. */
typedef enum FindingGroup {
    GROUP_LEGAL_IMPASSABLE,
    GROUP_ILLEGAL_IMPASSABLE,
    GROUP_ILLEGAL,
    GROUP_GOOD,
    GROUP_OPEN
} FindingGroup;

typedef struct Inspection {
    RulePlace *places; /* (place_count) corridors, then doors, then rooms */
    size_t place_count;
    Finding *findings; /* (finding_count) set by set, rule by rule, place by place */
    size_t finding_count, finding_capacity;
    size_t counts[RULE_VERDICTS];
    bool interrupted; /* True: what was found so far */
    Corridors corridors;
    size_t first_door, first_room; /* indices in places */
    bool *passed_by;               /* (place_count x person_count) the way of the person leads there */
    size_t person_count;
    const char *population; /* id of the drivers' population; NULL: no drivers were tried */
    size_t driver_count;
    Arena arena;
} Inspection;

/* Inspects a house; the sets must outlive the inspection. `jobs` threads plan the chairs' ways. inspection_free
 * releases it. */
Inspection inspection_make(const House *house, const RuleSets *sets, int jobs, const Stop *stop);
void inspection_free(Inspection *inspection);

/* Returns the place of what `what` names ("door d2") or, if it names no door, of the corridor near `at` or the room
 * around it; SIZE_MAX: none. */
size_t inspection_place(const Inspection *inspection, const House *house, const char *what, Vec2 at);

/* True if chairs are stopped at a place: one of the plan's own, or at least INSPECTION_REFUSED of the drivers. */
bool inspection_is_stopped(const RulePlace *place);

FindingGroup inspection_group(const Inspection *inspection, const Finding *finding);

/* Returns a finding of a set that has no failure at a place where chairs are stopped: legal and impassable; of several,
 * one that stops a chair of the plan, then the one whose source is known best, then the one with most drivers refused.
 * NULL: there is none. */
const Finding *inspection_legal_impassable(const Inspection *inspection);
