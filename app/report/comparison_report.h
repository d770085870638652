/* A report about two houses, a and b, side by side: which is better for whom, and what is different in them. */
#pragma once

#include "report/house_report.h"

/* document_clear releases what is made. */
Document comparison_report_make(const Reported runs[2], const Making *making);
