/* What the tables of a house file cannot say: that ids differ and are found, that doors lie in their walls, that people
 * stand in free space. Only for the files of the plan. */
#pragma once

#include "base/json.h"
#include "plan/plan_tables.h"

typedef struct PlanCheck {
    Plan *plan;           /* its references are resolved */
    const JsonNode *root; /* of its file, to point at */
    Fault *fault;
    const bool *sound[PLAN_LISTS]; /* (count) of each list: was the element read without a fault? */
} PlanCheck;

/* Adds what is wrong; elements that are not sound, and what depends on them, are passed over. */
void plan_check_whole(const PlanCheck *check);
