/* JSON Schema of parameter tables. */
#pragma once

#include "base/parameters.h"

/* Return the schema of one value, and of an object with all rows; new, json_decref it. */
json_t *parameters_schema_value(const Parameter *row);
json_t *parameters_schema_table(const ParameterTable *table);
