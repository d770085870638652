/* Imports files of other programs as houses that the window can display. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "base/text.h"

/* A zeroed struct is empty; import_file_clear releases it. */
typedef struct ImportFile {
    char *text;         /* text of a house file */
    char *name;         /* name of the house */
    Fault notes;        /* (notes.count) assumptions and omissions, one per line */
    Text left;          /* short summary of the omissions: "3 windows, 1 staircase"; empty: none */
    const char *format; /* "Sweet Home 3D" */
} ImportFile;

/* True if the name has the extension of a file that can be imported. */
bool import_file_knows(const char *path);

/* Reads and converts a file. False: faults give the reasons, and `import` is empty. */
bool import_file_read(ImportFile *import, const char *path, Fault *fault);
void import_file_clear(ImportFile *import);
