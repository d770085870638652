/* How crowded a house is, in a report: people on a square metre at the moment when most of the plan is full. */
#pragma once

#include "document/document.h"
#include "report/report_basis.h"

/* Adds a picture with its key; nothing if the run has fewer than DENSITY_SCENE_PEOPLE people. The house must outlive
 * the document. */
void report_density_add(Document *document, const Reported *run);
