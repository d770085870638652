/* The part of a report that says who is out, in what time, and how that agrees with what was measured. */
#pragma once

#include "document/document.h"
#include "house/observation.h"

/* A table of all people who took part or, of many, of their groups and of the exits. */
void report_people_add(Document *document, const House *house, const Observation *observation);

/* The table of routes: mean (a) and deviation (b) of the measured times, simulation (c), error ((c) - (a)) / (a). */
void report_people_add_routes(Document *document, const House *house, const Observation *observation);

/* A number in a cell, with so many digits behind the point; NULL: it is not finite, and not there. */
const char *report_people_number(Document *document, double value, int digits);
