/* The report of a study as a document: the answer, its plots, and where answers change. */
#pragma once

#include "document/document.h"
#include "exchange/measured.h"
#include "report/report_basis.h"
#include "study/study.h"

typedef struct StudyReport {
    const Study *study;
    const Measured *measured; /* points laid over the plots; NULL: none */
    const char *words;        /* the answer, one sentence per line; it ends at an empty line */
    const char *file;
    void (*add_numbers)(Document *document, const void *context); /* the numbers of the file with their sources; NULL */
    const void *context;
} StudyReport;

/* document_clear releases the document; the study must outlive it. */
Document study_report_make(const StudyReport *report, const Making *making);
