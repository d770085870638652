/* Reports about houses as documents: the answer first, then its basis. For people who write about accessibility or
 * safety, for engineers and for teachers: a report says only what was simulated or given. */
#pragma once

#include "document/document.h"
#include "exchange/observed.h"
#include "report/report_basis.h"
#include "report/report_drivers.h"
#include "report/report_motion.h"

typedef struct HouseReport {
    Reported run;
    Reported by_driving[2];       /* the same house, by Driving: all people with this driving model; or empty */
    const ObservedLoci *observed; /* measured loci, or NULL */
    const RaisedPicture *raised;  /* or NULL: could not be drawn */
    ReportedDrivers drivers;      /* drivers and grades, as far as there are any */
    const Making *making;
} HouseReport;

/* document_clear releases the document; the houses must outlive it, the observations need not. */
Document house_report_make(const HouseReport *report);

/* Returns the name, or that of the file if there is none. */
const char *house_report_name(const House *house);
