/* The facts of a result, as every output prints them: a fact is written down once, as a row, with its key, label, value
 * and unit. The pens in this folder print the same rows: text.h for the terminal, json.h, panel.h for the window's
 * panel and page.h for a report. The other files write down the rows of each kind of result. */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "draw/scene.h"

typedef enum ResultKind { RESULT_TEXT, RESULT_FLAG, RESULT_COUNT, RESULT_NUMBER, RESULT_LIST, RESULT_TEXTS } ResultKind;

/* Decides what `result_compare` makes of the values of two runs. */
typedef enum ResultDifference {
    DIFFERENCE_NONE,
    DIFFERENCE_ALWAYS,
    DIFFERENCE_IF_BOTH, /* only where both runs have succeeded: times of different paths have no difference */
} ResultDifference;

typedef struct ResultRow {
    const char *key;   /* in JSON; "narrowest.x" is the member x of the object narrowest; NULL: only for people */
    const char *label; /* for people: "personal space entered"; NULL: only in JSON */
    const char *head;  /* label of a table's column, where `label` is too long for one; or NULL */
    ResultKind kind;
    double number;      /* of a count or a number, or a flag's 0 or 1; NAN: none */
    const char *text;   /* of a text, or NULL; otherwise the words that people read instead of the number, or NULL */
    const double *list; /* (count) of a list of numbers */
    const char *const *texts; /* (count) of a list of texts, which is for JSON: people read `text` */
    size_t count;
    const char *unit; /* in which people read the number, or NULL */
    double factor;    /* number for people = factor x number; 0 counts as 1 */
    int decimals;     /* digits behind the point, for people; or, where `significant` is more than 0, */
    int significant;  /* digits in all */
    bool sign;        /* people read the sign of positive numbers, too */
    bool gap;         /* a length that is a gap: the window's panel gives it in cm; with `text`, it is over `read`, m */
    bool unknown;     /* people read "-", although JSON has a value */
    bool omitted;     /* JSON leaves the key out, and people read "-" */
    bool reads;       /* people read `read`, in their unit and not multiplied, instead of the number */
    double read;
    ResultDifference difference;
    Role role; /* of the value in the window; ROLE_PAPER counts as ROLE_TEXT */
} ResultRow;

/* Decides how JSON writes numbers. */
typedef enum ResultNumbers {
    RESULT_MICRO,    /* rounded to six digits behind the point: a micrometre and a microsecond */
    RESULT_REAL,     /* in full, always with a point */
    RESULT_SHORTEST, /* in full, whole numbers without a point */
} ResultNumbers;

/* Records that consist of the same rows: one for each person, or a single one. Zero is empty; result_clear releases it.
 * Texts that are not made in `arena` must outlive the table. */
typedef struct ResultTable {
    ResultNumbers numbers;
    ResultRow *rows; /* (record_count x row_count) record by record */
    size_t row_count, record_count, used, capacity;
    Arena arena;
} ResultTable;

void result_clear(ResultTable *table);

/* Adds a row to the record that is being written; result_end ends that record. */
void result_add(ResultTable *table, ResultRow row);

/* Adds a number with this many decimals; unknown unless it is finite. */
void result_add_number(ResultTable *table, const char *key, const char *label, double number, const char *unit,
                       int decimals);

void result_end(ResultTable *table);

/* Returns row `row` of a record. */
const ResultRow *result_at(const ResultTable *table, size_t record, size_t row);

/* Returns the row with this key in a record, or NULL. */
const ResultRow *result_find(const ResultTable *table, size_t record, const char *key);

/* The value as people read it, without and with its unit; NULL: there is none. Good as long as the arena lives. */
const char *result_value(const ResultRow *row, Arena *arena);
const char *result_value_and_unit(const ResultRow *row, Arena *arena);

/* Copies rows and texts; keys, labels and units are not copied. */
ResultTable result_copy(const ResultTable *table);

/* Returns number `index` of a list as a row of its own, called `label`. */
ResultRow result_element(const ResultRow *list, size_t index, const char *label);

/* Lists the rows (row_count) that are columns of a table for people: those with a value in any record. Returns how
 * many; 0 when there are only names. */
size_t result_columns(const ResultTable *table, size_t *rows);

/* True if the row's values stand to the right in a column. */
bool result_is_number(const ResultRow *row);

/* Returns value b - value a as a row, without a value where it has none (ResultDifference). People read the difference
 * of the numbers as they are rounded for people, so that it agrees with both. `both`: both runs have succeeded. */
ResultRow result_difference(const ResultRow *a, const ResultRow *b, bool both);

/* Two tables of the same kind of rows. The records of b are found by the text of their first row and, where `alike` is
 * a key, by that of this row, too. */
typedef struct ResultPair {
    const ResultTable *a, *b;
    const char *names[3];  /* of a, of b and of their difference: "a", "b", "b - a" */
    const char *succeeded; /* key of the row that is more than 0 where a record's run has succeeded */
    const char *alike;     /* or NULL */
} ResultPair;

/* Returns the record of b with the same name as `record` of a, or SIZE_MAX. */
size_t result_partner(const ResultPair *pair, size_t record);

/* True if both a's record and its partner have succeeded. */
bool result_both_succeeded(const ResultPair *pair, size_t record, size_t partner);

/* Adds to an empty table, for each record of a: that record, its partner and their difference. Behind the name stands
 * which of the three it is; then the success and all rows that have differences. */
void result_compare(ResultTable *table, const ResultPair *pair);
