#include "result/result.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"

void result_clear(ResultTable *table) {
    memory_free(table->rows);
    arena_clear(&table->arena);
    *table = (ResultTable){.numbers = table->numbers};
}

void result_add(ResultTable *table, ResultRow row) {
    table->rows = memory_reserve(table->rows, &table->capacity, table->used + 1, sizeof *table->rows);
    row.role = row.role == ROLE_PAPER ? ROLE_TEXT : row.role;
    table->rows[table->used++] = row;
}

void result_add_number(ResultTable *table, const char *key, const char *label, double number, const char *unit,
                       int decimals) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = number,
                                  .unit = unit,
                                  .decimals = decimals,
                                  .unknown = !isfinite(number)});
}

void result_end(ResultTable *table) {
    table->record_count++;
    table->row_count = table->used / table->record_count;
}

const ResultRow *result_at(const ResultTable *table, size_t record, size_t row) {
    return &table->rows[record * table->row_count + row];
}

const ResultRow *result_find(const ResultTable *table, size_t record, const char *key) {
    for (size_t r = 0; r < table->row_count; r++) {
        const ResultRow *row = result_at(table, record, r);
        if (row->key && strcmp(row->key, key) == 0)
            return row;
    }
    return NULL;
}

/* Values ----------------------------------------------------------------------------------------------------------- */

enum { LIST_READ = 6 /* numbers of a list that people read */ };

/* Returns the decimals of a number; of significant digits, those that it has after rounding: 9.996 with 3 is 10.0. */
static int decimals_of(const ResultRow *row, double value) {
    char digits[48];
    if (row->significant <= 0)
        return row->decimals;
    if (value == 0 || !isfinite(value) ||
        snprintf(digits, sizeof digits, "%.*e", row->significant - 1, value) >= (int)sizeof digits)
        return 0;
    int exponent = atoi(strchr(digits, 'e') + 1), decimals = row->significant - 1 - exponent;
    return decimals > 0 ? decimals : 0;
}

/* Writes zero without a sign, also where rounding leaves one. */
static const char *digits_of(const ResultRow *row, double value, Arena *arena) {
    int decimals = decimals_of(row, value);
    const char *text = text_in_arena(arena, row->sign ? "%+.*f" : "%.*f", decimals, value);
    return text[strspn(text, "+-0.")] ? text : text_in_arena(arena, "%.*f", decimals, 0.0);
}

static double in_unit(const ResultRow *row, double number) {
    return number * (row->factor != 0 ? row->factor : 1);
}

static const char *number_of(const ResultRow *row, double number, Arena *arena) {
    return digits_of(row, in_unit(row, number), arena);
}

static const char *list_of(const ResultRow *row, Arena *arena) {
    const char *list = NULL;
    for (size_t i = 0; i < row->count && i < LIST_READ; i++) {
        const char *number = number_of(row, row->list[i], arena);
        list = list ? text_in_arena(arena, "%s, %s", list, number) : number;
    }
    return row->count > LIST_READ ? text_in_arena(arena, "%s, ...", list) : list;
}

const char *result_value(const ResultRow *row, Arena *arena) {
    if (row->unknown || row->omitted)
        return NULL;
    if (row->text)
        return *row->text ? row->text : NULL;
    if (row->kind == RESULT_LIST)
        return list_of(row, arena);
    if (row->kind == RESULT_TEXT || row->kind == RESULT_TEXTS || !isfinite(row->number))
        return NULL;
    if (row->kind == RESULT_FLAG)
        return row->number > 0 ? "yes" : "no";
    return row->reads ? digits_of(row, row->read, arena) : number_of(row, row->number, arena);
}

const char *result_value_and_unit(const ResultRow *row, Arena *arena) {
    const char *value = result_value(row, arena);
    bool bare = !value || !row->unit || (row->text && row->kind == RESULT_FLAG);
    return bare ? value : text_in_arena(arena, "%s %s", value, row->unit);
}

static bool is_known(const ResultTable *table, size_t row) {
    Arena arena = {0};
    bool known = false;
    for (size_t record = 0; record < table->record_count && !known; record++)
        known = result_value(result_at(table, record, row), &arena) != NULL;
    arena_clear(&arena);
    return known;
}

ResultTable result_copy(const ResultTable *table) {
    ResultTable copy = {.numbers = table->numbers};
    for (size_t r = 0; r < table->used; r++) {
        ResultRow row = table->rows[r];
        if (row.text)
            row.text = arena_text(&copy.arena, row.text);
        if (row.list) {
            double *list = arena_allocate(&copy.arena, row.count * sizeof *list);
            memcpy(list, row.list, row.count * sizeof *list);
            row.list = list;
        }
        if (row.texts) {
            const char **texts = arena_allocate(&copy.arena, row.count * sizeof *texts);
            for (size_t i = 0; i < row.count; i++)
                texts[i] = arena_text(&copy.arena, row.texts[i]);
            row.texts = texts;
        }
        result_add(&copy, row);
    }
    copy.row_count = table->row_count;
    copy.record_count = table->record_count;
    return copy;
}

ResultRow result_element(const ResultRow *list, size_t index, const char *label) {
    ResultRow row = *list;
    row.kind = RESULT_NUMBER;
    row.label = label;
    row.number = list->list[index];
    return row;
}

size_t result_columns(const ResultTable *table, size_t *rows) {
    size_t count = 0;
    for (size_t r = 0; r < table->row_count && table->record_count; r++)
        if (result_at(table, 0, r)->label && is_known(table, r))
            rows[count++] = r;
    return count > 1 ? count : 0;
}

bool result_is_number(const ResultRow *row) {
    return row->kind == RESULT_COUNT || row->kind == RESULT_NUMBER;
}

/* Two tables ------------------------------------------------------------------------------------------------------- */

/* Returns a number as it is rounded for people, in their unit. */
static double rounded(const ResultRow *row) {
    Arena arena = {0};
    double value = strtod(number_of(row, row->number, &arena), NULL);
    arena_clear(&arena);
    return value;
}

/* Lets people read the difference of what they read of a and of b, with the decimals of the finer one. */
static void read_difference(ResultRow *difference, const ResultRow *a, const ResultRow *b) {
    if (a->text || b->text || !isfinite(difference->number))
        return;
    int decimals = decimals_of(a, in_unit(a, a->number)), others = decimals_of(b, in_unit(b, b->number));
    difference->reads = true;
    difference->read = rounded(b) - rounded(a);
    difference->decimals = decimals > others ? decimals : others;
    difference->significant = 0;
}

ResultRow result_difference(const ResultRow *a, const ResultRow *b, bool both) {
    bool known = a->difference == DIFFERENCE_ALWAYS || (a->difference == DIFFERENCE_IF_BOTH && both);
    ResultRow difference = *a;
    difference.text = NULL;
    difference.number = known && result_is_number(a) ? b->number - a->number : NAN;
    difference.sign = true;
    difference.unknown = a->unknown || b->unknown;
    difference.omitted = false;
    read_difference(&difference, a, b);
    return difference;
}

static bool is_partner(const ResultPair *pair, size_t i, size_t j) {
    return strcmp(result_at(pair->a, i, 0)->text, result_at(pair->b, j, 0)->text) == 0 &&
           (!pair->alike ||
            strcmp(result_find(pair->a, i, pair->alike)->text, result_find(pair->b, j, pair->alike)->text) == 0);
}

size_t result_partner(const ResultPair *pair, size_t record) {
    for (size_t j = 0; j < pair->b->record_count; j++)
        if (is_partner(pair, record, j))
            return j;
    return SIZE_MAX;
}

bool result_both_succeeded(const ResultPair *pair, size_t record, size_t partner) {
    return result_find(pair->a, record, pair->succeeded)->number > 0 &&
           result_find(pair->b, partner, pair->succeeded)->number > 0;
}

enum { NAMES = 2 /* rows before the facts of a comparison: the name, and of which run they are */ };

static void add_compared(ResultTable *table, const ResultPair *pair, const ResultTable *of, size_t record, int which,
                         const ResultTable *before, size_t record_before, bool both) {
    result_add(table, *result_at(of, record, 0));
    result_add(table, (ResultRow){.label = "in", .text = pair->names[which]});
    for (size_t r = 1; r < of->row_count; r++) {
        const ResultRow *row = result_at(of, record, r);
        bool success = row->key && strcmp(row->key, pair->succeeded) == 0;
        if (row->difference == DIFFERENCE_NONE && !success)
            continue;
        ResultRow added = before ? result_difference(result_at(before, record_before, r), row, both) : *row;
        added.unknown |= before && row->difference == DIFFERENCE_NONE;
        result_add(table, added);
    }
    result_end(table);
}

/* Takes back the last record if a reader finds only names in it. */
static void drop_empty(ResultTable *table, size_t names) {
    Arena arena = {0};
    bool known = false;
    for (size_t r = names; r < table->row_count; r++)
        known |= result_value(result_at(table, table->record_count - 1, r), &arena) != NULL;
    arena_clear(&arena);
    if (known)
        return;
    table->record_count--;
    table->used -= table->row_count;
}

void result_compare(ResultTable *table, const ResultPair *pair) {
    for (size_t i = 0; i < pair->a->record_count; i++) {
        size_t j = result_partner(pair, i);
        add_compared(table, pair, pair->a, i, 0, NULL, 0, false);
        if (j == SIZE_MAX)
            continue;
        add_compared(table, pair, pair->b, j, 1, NULL, 0, false);
        add_compared(table, pair, pair->b, j, 2, pair->a, i, result_both_succeeded(pair, i, j));
        drop_empty(table, NAMES);
    }
}
