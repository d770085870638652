/* The part of a report about places: where people are stopped, and the tight places, each with a picture. */
#pragma once

#include "document/document.h"
#include "house/observation.h"

void report_places_add_stops(Document *document, const House *house, const Observation *observation);
void report_places_add_hazards(Document *document, const House *house, const Observation *observation);

/* Adds a table of all tight places. */
void report_places_add_table(Document *document, const House *house, const Observation *observation,
                             const char *caption);
