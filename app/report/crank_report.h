/* The report of a run of a slider crank as a document: what it does, the picture of its largest force, plots, and all
 * numbers with their sources. */
#pragma once

#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "document/document.h"
#include "report/report_basis.h"

typedef struct CrankReport {
    const Crank *crank;
    const Tree *tree;
    const Response *response;
    double ideal;     /* N, largest force of a joint without clearance; NAN: not known */
    const char *path; /* of the file */
} CrankReport;

/* document_clear releases the document; what the report points at must outlive it. */
Document crank_report_make(const CrankReport *report, const Making *making);
