/* The page of the comparison of a crank with the paper: its claims, and each type with its picture and words. */
#pragma once

#include "document/document.h"
#include "experiment/crank_paper.h"
#include "report/report_basis.h"

/* document_clear releases the document; the paper must outlive it. */
Document crank_paper_report_make(CrankPaper *paper, const Making *making);
