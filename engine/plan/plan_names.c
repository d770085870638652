#include "plan/plan_names.h"

#include <string.h>

#include "plan/plan_tables.h"
#include "plan/profile.h"

/* Adds "BEFORE.ROW" for each row with a single value. */
static void add_rows(Text *text, const char *before, const char *id, const ParameterTable *table) {
    for (size_t r = 0; r < table->count; r++) {
        const Parameter *row = &table->rows[r];
        switch (row->kind) {
        case PARAMETER_NUMBER:
        case PARAMETER_WHOLE:
        case PARAMETER_FLAG:
        case PARAMETER_CHOICE:
        case PARAMETER_TEXT:
            break;
        case PARAMETER_ID:
            if (strcmp(row->name, "id") == 0)
                continue;
            break;
        case PARAMETER_IDS:
        case PARAMETER_NUMBERS:
        case PARAMETER_POINT:
        case PARAMETER_POINTS:
        case PARAMETER_TABLE:
            continue;
        }
        text_format(text, "%s.%s%s%s\t%s", before, id, *id ? "." : "", row->name, row->meaning);
        text_format(text, *parameters_unit(row) ? ", %s\n" : "\n", parameters_unit(row));
    }
}

static void add_list(Text *text, const Plan *plan, const PlanList *list) {
    for (size_t i = 0; i < plan_tables_count(plan, list); i++) {
        const char *id = plan_tables_id(plan, list, i);
        if (!id || !*id)
            continue;
        add_rows(text, list->table.what, id, &list->table);
        add_rows(text, list->table.what, id, &list->components);
    }
}

/* Returns the profile of the n-th person or crowd. */
static const char *profile_of(const Plan *plan, size_t n) {
    return n < plan->person_count ? plan->people[n].profile : plan->crowds[n - plan->person_count].profile;
}

void plan_names_add(Text *text, const Plan *plan) {
    for (size_t l = 0; l < PLAN_LISTS; l++)
        add_list(text, plan, &plan_tables_lists[l]);
    for (size_t n = 0; n < plan->person_count + plan->crowd_count; n++) {
        bool known = false;
        for (size_t k = 0; k < n && !known; k++)
            known = strcmp(profile_of(plan, k), profile_of(plan, n)) == 0;
        if (!known)
            add_rows(text, "profile", profile_of(plan, n), profile_table());
    }
    add_rows(text, "run", "", &plan_tables_run);
}
