/* The paper's page: each legible claim of Gu and Dubowsky (1995), its number in the paper, ours and whether they
 * agree, then the figures. Disagreements are listed, too. */
#pragma once

#include "document/document.h"
#include "report/paper_figures.h"
#include "report/report_basis.h"

/* document_clear releases the document; the paper must outlive it, and the figures are taken over. */
Document paper_report_make(Paper *paper, PaperFigures *figures, const Making *making);
