/* The paper's page: each claim of Gu and Dubowsky (1995) that can be read, the paper's figure, ours and whether they
 * agree, then the figures. What does not agree stands in it. */
#pragma once

#include "document/document.h"
#include "report/paper_figures.h"
#include "report/report_basis.h"

/* document_clear releases what is made; the paper must outlive it, and the figures are taken over. */
Document paper_report_make(Paper *paper, PaperFigures *figures, const Making *making);
