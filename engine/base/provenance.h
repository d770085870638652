/* Values that say where they come from: a file gives such a value as {"value": .., "provenance": text}, in an object
 * for each group of rows; a row's name is "group.name". */
#pragma once

#include "base/parameters.h"

/* The part after the group when the row belongs to `group`, or NULL. */
const char *provenance_name(const Parameter *row, const char *group);

/* Reads one value into the row's field of `object`, and its provenance, which goes to `arena`, into `*provenance`.
 * `sources` are the beginnings that a provenance may have, as "paper|literature: |assumed". What does not fit adds a
 * fault. */
void provenance_read(const Parameter *row, void *object, const char **provenance, const JsonNode *node,
                     const char *sources, Arena *arena, Fault *fault);

/* JSON Schema of such a value. New. */
json_t *provenance_schema(const Parameter *row, const char *sources);
