/* Other programs' files as houses to be shown: what a window needs of them. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/text.h"

/* Zero is empty; import_file_clear releases it. */
typedef struct ImportFile {
    char *text;         /* of a house file */
    char *name;         /* of the house */
    Fault told;         /* (told.count) what was assumed and what was left out, a line each */
    Text left;          /* what was left out in short: "3 windows, 1 staircase"; empty: nothing */
    const char *format; /* "Sweet Home 3D" */
} ImportFile;

/* True if the name has the ending of a file that can be imported. */
bool import_file_knows(const char *path);

/* False: faults say why not, and there is nothing. */
bool import_file_read(ImportFile *import, const char *path, Fault *fault);
void import_file_clear(ImportFile *import);
