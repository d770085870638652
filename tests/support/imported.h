/* Imports of files that a test writes, and what came of them. */
#pragma once

#include "exchange/import.h"

typedef struct Imported {
    Plan plan;
    ImportReport report;
    Fault fault;
    bool good;
} Imported;

/* Writes a new file name below /tmp with that ending, and returns it; no such file exists. */
enum { IMPORTED_PATH = 80 };
const char *imported_path(char path[IMPORTED_PATH], const char *ending);

/* Imports a file and deletes it; imported_end releases the result. imported_text writes the file first. */
Imported imported_file(const char *path, ImportOptions options);
Imported imported_text(const char *ending, const char *text, ImportOptions options);

/* Checks whether the import was to succeed, and prints an error only if it was not expected. */
void imported_end(Imported *import, bool wanted);

/* Compares the house file from "walls" on, with ' for quotation marks: names and notes contain the file's name. */
void imported_check_lists(const Plan *plan, const char *expected);

/* True if the report says that so many of those were left out. */
bool imported_left_out(const Imported *import, const char *what, size_t count);

/* True if a note of the report contains the text. */
bool imported_noted(const Imported *import, const char *part);
