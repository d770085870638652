/* Imports houses from other programs' files: Sweet Home 3D, drawings (DXF), walkable areas (WKT) and Vadere
 * scenarios. One source file per format reads it and passes walls, doors and so on to a house builder; import.c has
 * the table of formats. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "exchange/import_report.h"
#include "plan/plan.h"

typedef struct ImportOptions {
    double unit;        /* m per unit of the file; 0: from the file, or the usual unit */
    const char *layers; /* drawings only: "walls=NAME,NAME,doors=NAME,furniture=NAME,exits=NAME"; NULL: by name */
    const char *level;  /* homes with storeys only: name of a storey; NULL: the lowest */
} ImportOptions;

/* Returns the metres in one "mm", "cm", "m", "inch" or "ft"; 0 for any other name. */
double import_unit(const char *name);
#define IMPORT_UNITS "mm|cm|m|inch|ft"

/* Reads a file by its ending. `report` must be empty; import_report_clear releases it, also after an error. Returns
 * false after an error, which names file:line:column where the format has lines, and leaves `plan` unchanged. The
 * plan is checked as in plan_read, except that it may lack people and exits. plan_free releases it. */
bool import_read(Plan *plan, const char *path, const ImportOptions *options, ImportReport *report, Fault *fault);

/* True if the file name has an ending that can be imported. */
bool import_is_file(const char *path);
