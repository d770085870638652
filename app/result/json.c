#include "result/json.h"

#include <stdint.h>
#include <string.h>

#include "base/json.h"

static json_t *number(double value, ResultNumbers numbers) {
    if (!isfinite(value))
        return json_null();
    return numbers == RESULT_MICRO  ? json_real(round(value * 1e6) / 1e6)
           : numbers == RESULT_REAL ? json_real(value)
                                    : json_number(value);
}

static json_t *list_of(const ResultRow *row, ResultNumbers numbers) {
    json_t *list = json_array();
    for (size_t i = 0; i < row->count; i++)
        json_array_append_new(list, number(row->list[i], numbers));
    return list;
}

static json_t *texts_of(const ResultRow *row) {
    json_t *list = json_array();
    for (size_t i = 0; i < row->count; i++)
        json_array_append_new(list, json_string(row->texts[i]));
    return list;
}

static json_t *value_of(const ResultRow *row, ResultNumbers numbers) {
    switch (row->kind) {
    case RESULT_TEXT:
        return row->text ? json_string(row->text) : json_null();
    case RESULT_FLAG:
        return json_boolean(row->number > 0);
    case RESULT_COUNT:
        return isfinite(row->number) ? json_integer((json_int_t)row->number) : json_null();
    case RESULT_LIST:
        return list_of(row, numbers);
    case RESULT_TEXTS:
        return texts_of(row);
    case RESULT_NUMBER:
        break;
    }
    return number(row->number, numbers);
}

/* Sets a member; "narrowest.x" sets the member x of the object narrowest, which is created where it is first named. */
static void set(json_t *object, const char *key, json_t *value) {
    const char *point = strchr(key, '.');
    if (!point) {
        json_object_set_new(object, key, value);
        return;
    }
    size_t length = (size_t)(point - key);
    json_t *inner = json_object_getn(object, key, length);
    if (!inner) {
        inner = json_object();
        json_object_setn_new(object, key, length, inner);
    }
    json_object_set_new(inner, point + 1, value);
}

void result_json_add(json_t *object, const ResultTable *table, size_t record) {
    for (size_t r = 0; r < table->row_count; r++) {
        const ResultRow *row = result_at(table, record, r);
        if (row->key && !row->omitted)
            set(object, row->key, value_of(row, table->numbers));
    }
}

json_t *result_json_record(const ResultTable *table, size_t record) {
    json_t *object = json_object();
    result_json_add(object, table, record);
    return object;
}

json_t *result_json_list(const ResultTable *table) {
    json_t *list = json_array();
    for (size_t record = 0; record < table->record_count; record++)
        json_array_append_new(list, result_json_record(table, record));
    return list;
}

json_t *result_json_take_list(ResultTable table) {
    json_t *list = result_json_list(&table);
    result_clear(&table);
    return list;
}

void result_json_take_record(json_t *object, ResultTable table) {
    result_json_add(object, &table, 0);
    result_clear(&table);
}

static json_t *difference_of(const ResultPair *pair, size_t i, size_t j) {
    json_t *object = json_object();
    bool both = result_both_succeeded(pair, i, j);
    const ResultRow *name = result_at(pair->a, i, 0);
    set(object, name->key, value_of(name, pair->a->numbers));
    for (size_t r = 1; r < pair->a->row_count; r++) {
        const ResultRow *row = result_at(pair->a, i, r);
        if (!row->key || row->difference == DIFFERENCE_NONE)
            continue;
        ResultRow difference = result_difference(row, result_at(pair->b, j, r), both);
        json_object_setn_new(object, row->key, strcspn(row->key, "."), value_of(&difference, pair->a->numbers));
    }
    return object;
}

json_t *result_json_differences(const ResultPair *pair) {
    json_t *list = json_array();
    for (size_t i = 0; i < pair->a->record_count; i++) {
        size_t j = result_partner(pair, i);
        if (j != SIZE_MAX)
            json_array_append_new(list, difference_of(pair, i, j));
    }
    return list;
}
