/* The part of a report about many drivers: in what time they get out, where they touch, how their paths and speeds
 * spread, and how tight the ways are. */
#pragma once

#include "base/text.h"
#include "document/document.h"
#include "experiment/drivers.h"
#include "inquiry/grade.h"
#include "report/report_basis.h"

/* The results of many drivers of a house. */
typedef struct ReportedDrivers {
    const Drivers *drivers; /* count 0: none */
    const Population *population;
    const Grade *grades;  /* (person_count) or NULL */
    const Grade *letters; /* (person_count), where only the letters are known (grade_all_letters), or NULL */
    bool interrupted;     /* True if drivers or grades are missing because of that */
} ReportedDrivers;

/* The same drivers in both houses, and the grades of their nominal drivers. */
typedef struct PairedDrivers {
    const Drivers *of; /* (2) of A and B; count 0: none */
    const Population *population;
    const Grade *letters[2]; /* (person_count) of A and B, their letters alone, or NULL */
} PairedDrivers;

/* Adds each line of the text as a paragraph, with names in place of ids, and releases the text. */
void report_drivers_take_lines(Document *document, const House *house, Text *text);

/* Adds sections for the drivers and for the grades, as far as there are any; `name` of the house. */
void report_drivers_add(Document *document, const char *name, const Reported *run, const ReportedDrivers *of);
