/* Prints rows for the terminal. */
#pragma once

#include "base/text.h"
#include "result/result.h"

/* Adds a table, a column for each row that has a value in any record, under a line of heads: "time s". */
void result_text_table(Text *text, const ResultTable *table);

/* Adds an empty line, a heading ("" or a line of its own) and a table, unless the table is empty; releases the table.
 */
void result_text_take(Text *text, const char *heading, ResultTable table);

/* Adds a line for each row of the first records of `count` tables that has a value: "time in contact   52 %". */
void result_text_list(Text *text, const ResultTable *const *tables, size_t count);

/* Adds the same lines for one record of a table. */
void result_text_record(Text *text, const ResultTable *table, size_t record);
