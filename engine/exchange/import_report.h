/* What an importer tells besides the house: what could not be taken over, what was assumed. Zero is an empty report. */
#pragma once

#include <stddef.h>

#include "base/memory.h"

typedef struct ImportLeft {
    const char *what; /* "windows" */
    size_t count;
} ImportLeft;

typedef struct ImportReport {
    const char *format;   /* "Sweet Home 3D" */
    ImportLeft *left_out; /* (left_out_count) one a kind */
    const char **notes;   /* (note_count) a sentence's beginning each, without a full stop */
    size_t left_out_count, left_out_capacity, note_count, note_capacity;
    Arena arena;
} ImportReport;

/* Of a file with very many kinds those beyond this are counted together. */
enum { IMPORT_REPORT_KINDS = 40, IMPORT_REPORT_NOTES = 40 };

/* Adds to the count of a kind; a count of 0 adds nothing. */
void import_report_leave(ImportReport *report, size_t count, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

void import_report_note(ImportReport *report, const char *format, ...) __attribute__((format(printf, 2, 3)));

void import_report_clear(ImportReport *report);
