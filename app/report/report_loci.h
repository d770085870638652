/* The part of a report that puts loci side by side: the paper's way of driving, ours, and what somebody measured. */
#pragma once

#include "base/fault.h"
#include "report/house_report.h"

/* Has everybody who is observed a namesake in the house, a person or the route of one? Otherwise faults say who has
 * not. Without names the house must have one person. */
bool report_loci_check(const House *house, const ObservedLoci *observed, Fault *fault);

/* Are there loci to be put side by side: some people in chairs, and few enough to be told apart? */
bool report_loci_make_sense(const House *house);

void report_loci_add(Document *document, const HouseReport *report);
