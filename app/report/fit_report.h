/* The page of `clearance fit`: what the data tell, the residuals, and the numbers behind them. */
#pragma once

#include "document/document.h"
#include "report/report_basis.h"
#include "study/fit.h"

/* document_clear releases the document; the fit must outlive it. `experiment` has the fitted parameters. */
Document fit_report_make(const Fit *fit, const Experiment *experiment, const char *file, const Making *making);
