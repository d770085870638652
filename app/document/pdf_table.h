/* A table on paper: columns as wide as their texts need, rows that are never cut, the head repeated on each new page.
 */
#pragma once

#include "document/sheet.h"

void pdf_table_set(Sheet *sheet, const Table *table);

/* Returns the height, pt, of the caption, the head and one row, which must stand together. */
double pdf_table_least(const Table *table);
