/* The part of a report about many drivers: in what time they get out, where they touch, how their paths and speeds
 * spread, and how tight the ways are. */
#pragma once

#include "document/document.h"
#include "experiment/drivers.h"
#include "inquiry/grade.h"
#include "report/report_basis.h"

/* The results of many drivers of a house. */
typedef struct ReportedDrivers {
    const Drivers *drivers; /* count 0: none */
    const Population *population;
    const Grade *grades; /* (person_count) or NULL */
} ReportedDrivers;

/* The same drivers in both houses. */
typedef struct PairedDrivers {
    const Drivers *of; /* (2) of A and B; count 0: none */
    const Population *population;
} PairedDrivers;

/* Adds sections for the drivers and for the grades, as far as there are any; `name` of the house. */
void report_drivers_add(Document *document, const char *name, const Reported *run, const ReportedDrivers *of);
