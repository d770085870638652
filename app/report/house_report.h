/* Reports about houses, as documents to be handed on: the answer first, then what it rests on. For whoever writes about
 * accessibility or safety, for engineers and for teachers: nothing is said that was not simulated or given. */
#pragma once

#include "document/document.h"
#include "exchange/observed.h"
#include "report/report_basis.h"
#include "report/report_motion.h"

typedef struct HouseReport {
    Reported run;
    Reported ways[2];             /* the same, by Driving: everybody driven this way; or nothing */
    const ObservedLoci *observed; /* loci that somebody measured, or NULL */
    const RaisedPicture *raised;  /* or NULL: nobody could draw it */
    const Making *making;
} HouseReport;

/* document_clear releases what is made; the houses must outlive it, the observations need not. */
Document house_report_make(const HouseReport *report);

/* The name, or the file's where there is none. */
const char *house_report_name(const House *house);
