/* A report about a house in earthquakes: who leaves how often, how fast, and which furniture stops people. */
#pragma once

#include "document/document.h"
#include "result/shake_findings.h"
#include "report/report_basis.h"

/* document_clear releases the document; house and findings must outlive it. */
Document shake_report_make(const ShakeFindings *findings, const Making *making);
