/* Houses out of other programs' files: Sweet Home 3D, drawings (DXF), walkable areas (WKT), Vadere scenarios. One file
 * a format reads it and hands walls, doors and so on to a house builder; the table of formats is in import.c. */
#pragma once

#include <stdbool.h>

#include "base/fault.h"
#include "exchange/import_report.h"
#include "plan/plan.h"

typedef struct ImportOptions {
    double unit;        /* m, of the file's numbers; 0: as the file says, or what is usual */
    const char *layers; /* of a drawing: "walls=NAME,NAME,doors=NAME,furniture=NAME,exits=NAME"; NULL: by their names */
    const char *level;  /* of a home with storeys: its name; NULL: the lowest */
} ImportOptions;

/* How many metres one of "mm", "cm", "m", "inch", "ft" is; 0: none of these. */
double import_unit(const char *name);
#define IMPORT_UNITS "mm|cm|m|inch|ft"

/* Reads a file as its ending says. `report` is empty before; import_report_clear releases it also after a failure.
 * False: one fault says what is wrong, file:line:column where the format has lines, and the plan is as it was. The plan
 * has been checked as plan_read does; nobody need live in it, and there need not be an exit. plan_free releases it. */
bool import_read(Plan *plan, const char *path, const ImportOptions *options, ImportReport *report, Fault *fault);

/* Does the name end as one that can be read? */
bool import_is_file(const char *path);
