#include "base/parameters_schema.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/parameters_number.h"

json_t *parameters_schema_value(const Parameter *row) {
    if (row->kind == PARAMETER_TABLE)
        return parameters_schema_table(row->table);
    static const char point[] = "{s:s, s:i, s:i, s:{s:s, s:f, s:f}}";
    json_t *schema = json_object();
    json_t *type = NULL;
    switch (row->kind) {
    case PARAMETER_NUMBER:
    case PARAMETER_WHOLE:
        type = json_string(row->kind == PARAMETER_NUMBER ? "number" : "integer");
        json_object_set_new(schema, "minimum", json_number(row->low));
        if (row->high < HUGE_VAL)
            json_object_set_new(schema, "maximum", json_number(row->high));
        if (!row->needed && fabs(row->fallback) < HUGE_VAL)
            json_object_set_new(schema, "default", json_number(row->fallback));
        break;
    case PARAMETER_FLAG:
        type = json_string("boolean");
        json_object_set_new(schema, "default", json_boolean(row->fallback != 0));
        break;
    case PARAMETER_CHOICE: {
        json_t *words = json_array();
        for (const char *at = row->choices; *at; at += strcspn(at, "|"), at += *at == '|')
            json_array_append_new(words, json_stringn(at, strcspn(at, "|")));
        json_object_set_new(schema, "enum", words);
        if (!row->needed)
            json_object_set_new(schema, "default", parameters_number_json(row, row->fallback));
        break;
    }
    case PARAMETER_TEXT:
        type = json_string("string");
        break;
    case PARAMETER_ID:
        type = json_string("string");
        json_object_set_new(schema, "pattern", json_string("^[A-Za-z0-9_-]+$"));
        break;
    case PARAMETER_IDS:
        type = json_string("array");
        json_object_set_new(schema, "items", json_pack("{s:s, s:s}", "type", "string", "pattern", "^[A-Za-z0-9_-]+$"));
        break;
    case PARAMETER_NUMBERS:
        type = json_string("array");
        json_object_set_new(schema, "items",
                            json_pack("{s:s, s:o, s:o}", "type", "number", "minimum", json_number(row->low), "maximum",
                                      json_number(row->high)));
        break;
    case PARAMETER_POINT:
    case PARAMETER_POINTS: {
        json_t *one = json_pack(point, "type", "array", "minItems", 2, "maxItems", 2, "items", "type", "number",
                                "minimum", -PARAMETER_FARTHEST, "maximum", PARAMETER_FARTHEST);
        if (row->kind == PARAMETER_POINT) {
            json_object_update(schema, one);
            json_decref(one);
        } else {
            type = json_string("array");
            json_object_set_new(schema, "minItems", json_integer((json_int_t)row->low));
            json_object_set_new(schema, "items", one);
        }
        break;
    }
    case PARAMETER_TABLE:
        break;
    }
    if (type)
        json_object_set_new(schema, "type", type);
    char description[400];
    const char *unit = parameters_unit(row);
    snprintf(description, sizeof description, "%s%s%s", row->meaning, *unit ? ", in " : "", unit);
    json_object_set_new(schema, "description", json_string(description));
    return schema;
}

json_t *parameters_schema_table(const ParameterTable *table) {
    json_t *properties = json_object(), *needed = json_array();
    for (size_t i = 0; i < table->count; i++) {
        json_object_set_new(properties, table->rows[i].name, parameters_schema_value(&table->rows[i]));
        if (table->rows[i].needed)
            json_array_append_new(needed, json_string(table->rows[i].name));
    }
    json_t *schema =
        json_pack("{s:s, s:b, s:o}", "type", "object", "additionalProperties", 0, "properties", properties);
    if (json_array_size(needed))
        json_object_set(schema, "required", needed);
    json_decref(needed);
    return schema;
}
