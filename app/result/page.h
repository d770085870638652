/* Prints rows as tables of a report. */
#pragma once

#include "document/document.h"
#include "house/house.h"
#include "result/result.h"

/* Adds a table: a line for each record, a column for each row that has a value in any of them. Of more columns than fit
 * on a page, the others follow in further tables, which begin with the first column again. */
void result_page_table(Document *document, const char *caption, const ResultTable *table);

/* Adds the same of a table that is released. */
void result_page_take(Document *document, const char *caption, ResultTable table);

/* Adds the same of a table about a house, with the names of things and people in place of their ids. */
void result_page_take_named(Document *document, const char *caption, const House *house, ResultTable table);

/* Adds a table with a line for each row of the first records of `count` tables that has a value: its label, the value
 * with its unit. */
void result_page_list(Document *document, const char *caption, const ResultTable *const *tables, size_t count);

/* Adds a table with a line for each row of two records: its label, the value of a, of b, and b - a. `both`: both runs
 * have succeeded. */
void result_page_pair(Document *document, const char *const names[3], const ResultTable *a, const ResultTable *b,
                      bool both);

/* Adds a table with a line for each record of pair->a: its name, and the row with this key in a, in b, and b - a. */
void result_page_fact(Document *document, const char *caption, const ResultPair *pair, const char *key);
