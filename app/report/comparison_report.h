/* A report about two houses, a and b, side by side: which is better for whom, and how they differ. */
#pragma once

#include "report/house_report.h"

/* document_clear releases the document. */
Document comparison_report_make(const Reported runs[2], const PairedDrivers *drivers, const Making *making);
