/* Checks that the pens print the same rows. */
#pragma once

#include <jansson.h>

#include "document/document.h"
#include "result/result.h"

/* Returns table `index` of the document, or NULL. */
const Block *pens_table(const Document *document, size_t index);

/* Checks that every fact that a builder writes down about the first record, at least `least` of them, stands in the
 * text, in JSON, on the panel and, unless it is NULL, in a table of the document. */
void pens_check_facts(const ResultTable *table, size_t least, const char *text, const json_t *json,
                      const Document *document);

/* Prints the rows with all pens and checks the same. */
void pens_check(const ResultTable *table, size_t least);
