/* Tables of comma-separated values (RFC 4180; also `;` or a tab between columns), read field by field, each with its
 * place: what readers of such files have in common. The first row names the columns. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"

enum { TABLE_SHOWN = 40 /* characters of the file in a fault, and room for a unit */ };

typedef struct TablePlace {
    int line, column; /* from 1 */
} TablePlace;

/* What a reader does with what is read. */
typedef struct TableReader {
    const char *path;
    Fault *fault;
    void (*take_field)(void *context, TablePlace place, int index, const char *text); /* index: in its row, from 0 */
    void (*end_row)(void *context, TablePlace begin, int fields);
    void *context;
} TableReader;

/* Reads a file of at most `largest` bytes; what it cannot be read for is a fault. Returns the place of its end. */
TablePlace table_read(const TableReader *reader, size_t largest);

/* Adds the fault `what "text"wanted`, the quotation left out without text. */
void table_fault(const TableReader *reader, TablePlace place, const char *what, const char *text, const char *wanted);

/* Of a heading like "time [s]" or "X (m)": the length of its name; `unit` takes its unit, "" without one. */
size_t table_heading(const char *text, char unit[TABLE_SHOWN]);

/* A field as a number from -farthest to farthest; false: a fault, which calls it `name`, in `unit`. */
bool table_number(const TableReader *reader, TablePlace place, const char *name, const char *unit, double farthest,
                  const char *text, double *value);
