/* The report of `clearance rules` as a document: what the rules say, and whether people get through all the same. */
#pragma once

#include "document/document.h"
#include "house/house.h"
#include "report/report_basis.h"
#include "rules/inspection.h"

/* document_clear releases the document; house, sets and inspection must outlive it. */
Document rules_report_make(const House *house, const RuleSets *sets, const Inspection *inspection,
                           const Making *making);
