/* Values with a recorded source: a file gives such a value as {"value": .., "provenance": text}, in one object per
 * group of rows; a row's name is "group.name". */
#pragma once

#include "base/parameters.h"

/* Returns the part of the name after the group if the row belongs to `group`, or NULL. */
const char *provenance_name(const Parameter *row, const char *group);

/* Reads one value into the row's field of `object`, and its provenance, allocated in `arena`, into `*provenance`.
 * `sources` lists the allowed beginnings of a provenance, as "paper|literature: |assumed". An invalid value adds an
 * error. */
void provenance_read(const Parameter *row, void *object, const char **provenance, const JsonNode *node,
                     const char *sources, Arena *arena, Fault *fault);

/* Returns the JSON Schema of such a value. New. */
json_t *provenance_schema(const Parameter *row, const char *sources);
