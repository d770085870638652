#include "report/report_plans.h"

#include <stdint.h>
#include <string.h>

#include "plan/plan_tables.h"

enum {
    ROWS_MOST = 40,
    TEXT_MOST = 60, /* characters of a value: for longer ones only the difference is reported */
};

/* Adds a row to the table; rows beyond ROWS_MOST are only counted. */
typedef struct Differences {
    Document *document;
    size_t count;
} Differences;

static void add_difference(Differences *differences, const char *what, const char *a, const char *b) {
    static const Column columns[] = {{"What", ALIGN_LEFT}, {"A", ALIGN_LEFT}, {"B", ALIGN_LEFT}};
    const char *cells[] = {what, a, b};
    if (differences->count == 0)
        document_add_table(differences->document, NULL, columns, 3);
    if (differences->count++ < ROWS_MOST)
        document_add_row(differences->document, cells);
}

static const char *name_of(Document *document, const char *what, const char *id, const Parameter *row) {
    const char *unit = parameters_unit(row);
    return document_text(document, "%s%s%s, %s%s%s", what, *id ? " " : "", id, row->name, *unit ? ", " : "", unit);
}

static void compare_rows(Differences *differences, const ParameterTable *table, const char *id, const void *a,
                         const void *b) {
    for (size_t r = 0; r < table->count; r++) {
        const Parameter *row = &table->rows[r];
        char *text[2] = {parameters_words(row, a), parameters_words(row, b)};
        bool same = strcmp(text[0], text[1]) == 0;
        bool shown = strlen(text[0]) < TEXT_MOST && strlen(text[1]) < TEXT_MOST;
        if (!same)
            add_difference(differences, name_of(differences->document, table->what, id, row),
                           shown ? text[0] : "differs", shown ? text[1] : "differs");
        memory_free(text[0]);
        memory_free(text[1]);
    }
}

static void compare_lists(Differences *differences, const PlanList *list, const Plan *a, const Plan *b) {
    for (size_t i = 0; i < plan_tables_count(a, list); i++) {
        const char *id = plan_tables_id(a, list, i);
        size_t other = plan_tables_find(b, list, id);
        if (other == SIZE_MAX)
            add_difference(differences, document_text(differences->document, "%s %s", list->table.what, id), "present",
                           "absent");
        else
            compare_rows(differences, &list->table, id, plan_tables_element(a, list, i),
                         plan_tables_element(b, list, other));
    }
    for (size_t i = 0; i < plan_tables_count(b, list); i++)
        if (plan_tables_find(a, list, plan_tables_id(b, list, i)) == SIZE_MAX)
            add_difference(differences,
                           document_text(differences->document, "%s %s", list->table.what, plan_tables_id(b, list, i)),
                           "absent", "present");
}

static void compare_overrides(Differences *differences, const Plan *of, const Plan *other, bool of_a) {
    for (size_t i = 0; i < of->override_count; i++) {
        const Override *override = &of->overrides[i];
        bool same = false;
        for (size_t k = 0; k < other->override_count; k++)
            same |= strcmp(override->name, other->overrides[k].name) == 0 &&
                    strcmp(override->value, other->overrides[k].value) == 0;
        if (!same)
            add_difference(differences, override->name,
                           of_a ? override->value : "as in the other plan or in the profile",
                           of_a ? "as in the other plan or in the profile" : override->value);
    }
}

void report_plans_add(Document *document, const Plan *a, const Plan *b) {
    Differences differences = {.document = document};
    document_add_heading(document, 2, "Differences between the plans");
    for (size_t l = 0; l < PLAN_LISTS; l++)
        compare_lists(&differences, &plan_tables_lists[l], a, b);
    compare_rows(&differences, &plan_tables_run, "", &a->run, &b->run);
    compare_overrides(&differences, a, b, true);
    compare_overrides(&differences, b, a, false);
    if (!differences.count)
        document_add_paragraph(document, "None: walls, doors, furniture, people and settings are the same.");
    if (differences.count > ROWS_MOST)
        document_add_paragraph(document,
                               document_text(document, "Further differences: %zu.", differences.count - ROWS_MOST));
}
