/* Prints rows as JSON. */
#pragma once

#include <jansson.h>

#include "result/result.h"

/* A record as an object; all of them as an array of objects; new. */
json_t *result_json_record(const ResultTable *table, size_t record);
json_t *result_json_list(const ResultTable *table);

/* The same from a table that is released. */
json_t *result_json_take_list(ResultTable table);

/* Appends a record's members to an object. */
void result_json_add(json_t *object, const ResultTable *table, size_t record);

/* Appends the only record of a table, and releases the table. */
void result_json_take_record(json_t *object, ResultTable table);

/* For each record of a that has a partner in b its name and the differences b - a; new. */
json_t *result_json_differences(const ResultPair *pair);
