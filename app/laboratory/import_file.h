/* Imports files of other programs as houses that the window can display. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/text.h"

/* A unit in which the plan may be drawn. */
typedef struct ImportChoice {
    double metres; /* in one unit of the file */
    char text[96]; /* "12.19 m by 9.14 m, drawn in inches: doors 0.81 m, walls 0.15 m" */
} ImportChoice;

enum { IMPORT_CHOICES = 5 };

/* A zeroed struct is empty; import_file_clear releases it. */
typedef struct ImportFile {
    char *text;                           /* text of a house file */
    char *name;                           /* name of the house */
    Fault notes;                          /* (notes.count) assumptions and omissions, one per line */
    Text left;                            /* short summary of the omissions: "3 windows, 1 staircase"; empty: none */
    const char *format;                   /* "Sweet Home 3D" */
    ImportChoice choices[IMPORT_CHOICES]; /* (choice_count) the likeliest first */
    size_t choice_count;                  /* 0: the unit is sure */
    double width;                         /* of the plan, in the file's unit, if there are choices */
} ImportFile;

/* True if the name has the extension of a file that can be imported. */
bool import_file_knows(const char *path);

/* Reads and converts a file; `unit` is m per unit of the file, 0: as the file says. False: faults give the reasons, and
 * `import` holds at most choices, if only the unit is in doubt. */
bool import_file_read(ImportFile *import, const char *path, double unit, Fault *fault);
void import_file_clear(ImportFile *import);
