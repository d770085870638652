/* Reads tables of comma-separated values (RFC 4180; also `;` or a tab between columns) field by field, each with its
 * place. The first row names the columns. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

enum { TABLE_SHOWN = 40 /* characters of the file quoted in an error, and size of a unit */ };

typedef struct TablePlace {
    int line, column; /* from 1 */
} TablePlace;

/* Callbacks of a reader. */
typedef struct TableReader {
    const char *path;
    Fault *fault;
    void (*take_field)(void *context, TablePlace place, int index, const char *text); /* index: in its row, from 0 */
    void (*end_row)(void *context, TablePlace begin, int fields);
    void *context;
} TableReader;

/* Reads a file of at most `largest` bytes and reports errors of reading. Returns the place of its end. */
TablePlace table_read(const TableReader *reader, size_t largest);

/* Adds the error `what "text"wanted`; without text the quotation is left out. */
void table_fault(const TableReader *reader, TablePlace place, const char *what, const char *text, const char *wanted);

/* Returns the length of the name in a heading such as "time [s]" or "X (m)"; `unit` receives its unit, or "". */
size_t table_heading(const char *text, char unit[TABLE_SHOWN]);

/* Checks that a row has as many columns as the heading; false: an error that says so. */
bool table_row_fits(const TableReader *reader, TablePlace begin, int fields, int heading);

/* Parses a field as a number from -farthest to farthest; false: an error that calls the field `name`, in `unit`. */
bool table_number(const TableReader *reader, TablePlace place, const char *name, const char *unit, double farthest,
                  const char *text, double *value);
