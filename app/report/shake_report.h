/* A report about a house in earthquakes: who gets out how often, how fast, and which furniture stops them. */
#pragma once

#include "document/document.h"
#include "visual/house/shake_findings.h"
#include "report/report_basis.h"

/* document_clear releases what is made; house and findings must outlive it. */
Document shake_report_make(const ShakeFindings *findings, const Making *making);
