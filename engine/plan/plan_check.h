/* Checks beyond the tables of a house file: ids are unique and known, doors lie in their walls, people stand in free
 * space. Private to the files of the plan. */
#pragma once

#include "base/json.h"
#include "plan/plan_tables.h"

typedef struct PlanCheck {
    Plan *plan;           /* its references are resolved here */
    const JsonNode *root; /* root of its file, for positions of errors */
    Fault *fault;
    const bool *sound[PLAN_LISTS]; /* (count) per list: True if the element was read without an error */
} PlanCheck;

/* Adds all errors; invalid elements and their dependants are skipped. */
void plan_check_whole(const PlanCheck *check);
