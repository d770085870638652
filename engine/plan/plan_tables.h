/* The parameter tables of a house file, and its lists of walls, doors and so on as rows of one table, so that reading,
 * checking, writing, `--set` and the schema treat all of them alike. Private to the files of the plan. */
#pragma once

#include "plan/plan.h"

typedef struct PlanList {
    const char *key; /* key in the file: "walls" */
    ParameterTable table;
    ParameterTable components; /* of its points, to change single numbers: "at.x" */
    size_t array, count, size; /* offsets in Plan, bytes of an element; the first field of each element is its id */
} PlanList;

/* In the order of a file. */
enum {
    LIST_WALLS,
    LIST_DOORS,
    LIST_FURNITURE,
    LIST_ROOMS,
    LIST_EXITS,
    LIST_PEOPLE,
    LIST_CROWDS,
    LIST_ROUTES,
    PLAN_LISTS,
};

extern const PlanList plan_tables_lists[PLAN_LISTS];
extern const ParameterTable plan_tables_run, plan_tables_drivers, plan_tables_background;

/* Gives the plan `count` zeroed elements in a list, and returns them. */
void *plan_tables_allocate(Plan *plan, const PlanList *list, size_t count);

size_t plan_tables_count(const Plan *plan, const PlanList *list);
void *plan_tables_element(const Plan *plan, const PlanList *list, size_t index);

/* Returns "" if the id could not be read. */
const char *plan_tables_id(const Plan *plan, const PlanList *list, size_t index);

/* Builds the index of plan_tables_find when all lists are read; up to `changes` ids may then be given to
 * plan_tables_renamed. */
void plan_tables_index(Plan *plan, size_t changes);
void plan_tables_renamed(Plan *plan, const PlanList *list, size_t index);

/* Returns the index of the id in the list, or SIZE_MAX. */
size_t plan_tables_find(const Plan *plan, const PlanList *list, const char *id);
