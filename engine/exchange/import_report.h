/* An importer's remarks: elements that were left out, and assumptions. A zeroed report is empty. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/memory.h"
#include "base/vec2.h"

typedef struct ImportLeft {
    const char *what; /* "windows" */
    size_t count;
} ImportLeft;

/* A unit in which a plan may be drawn, and the sizes that things then have. */
typedef struct ImportUnit {
    const char *name; /* "inch" */
    double metres;    /* in one */
    Vec2 plan;        /* m, extent of the walls */
    double leaf;      /* m, median leaf of the doors; 0: none are drawn */
    double wall;      /* m, thickest wall that is drawn as two lines; 0: none */
    bool possible;    /* a house may have these sizes */
} ImportUnit;

enum { IMPORT_REPORT_UNITS = 5 };

typedef struct ImportReport {
    const char *format;   /* "Sweet Home 3D" */
    ImportLeft *left_out; /* (left_out_count) one per kind */
    const char **notes;   /* (note_count) clauses, without a full stop */
    size_t left_out_count, left_out_capacity, note_count, note_capacity;
    ImportUnit units[IMPORT_REPORT_UNITS]; /* (unit_count) the likeliest first */
    size_t unit_count;                     /* 0: the file, or who imports it, is sure of its unit */
    Arena arena;
} ImportReport;

/* Kinds beyond this number are counted together. */
enum { IMPORT_REPORT_KINDS = 40, IMPORT_REPORT_NOTES = 40 };

/* Adds to the count of a kind; adding 0 has no effect. In kinds and notes each character is seen, as in an error. */
void import_report_leave(ImportReport *report, size_t count, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

void import_report_note(ImportReport *report, const char *format, ...) __attribute__((format(printf, 2, 3)));

void import_report_clear(ImportReport *report);
