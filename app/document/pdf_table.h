/* A table on paper: columns as wide as their words need, rows that are never cut, the head again on each new page. */
#pragma once

#include "document/sheet.h"

void pdf_table_set(Sheet *sheet, const Table *table);

/* pt, of its caption, its head and a row: what must stand together. */
double pdf_table_least(const Table *table);
