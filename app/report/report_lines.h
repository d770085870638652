/* Parts that reports of machines have in common: sentences as paragraphs, and all numbers with their sources. */
#pragma once

#include "base/parameters.h"
#include "document/document.h"

/* Adds a paragraph for each line of a text, up to an empty one; each ends with a full stop. NULL: none. */
void report_lines_add(Document *document, const char *text);

/* Adds the table of the rows' values in `owner`, each with its provenance (one per row). */
void report_lines_add_numbers(Document *document, const ParameterTable *table, const void *owner,
                              const char *const *provenance);
