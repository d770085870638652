/* The report of `clearance ablate` as a document: what each part of the driving law is worth. */
#pragma once

#include "document/document.h"
#include "experiment/ablation.h"
#include "report/report_basis.h"

/* document_clear releases the document; the ablation must outlive it. */
Document ablation_report_make(const Ablation *ablation, const Population *population, const Making *making);
