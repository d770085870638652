/* JSON Schema of what parameter tables describe. */
#pragma once

#include "base/parameters.h"

/* Of one value, and of an object with all rows; new, json_decref it. */
json_t *parameters_schema_value(const Parameter *row);
json_t *parameters_schema_table(const ParameterTable *table);
