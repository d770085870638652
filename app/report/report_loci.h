/* The part of a report that shows loci side by side: the paper's driving model, ours, and measured ones. */
#pragma once

#include "base/fault.h"
#include "report/house_report.h"

/* Returns the person whom a column `person` names, by the id of the person or of the route; "" is the only person of a
 * house. SIZE_MAX: there is none. */
size_t report_loci_person(const House *house, const char *name);

/* True if every observed person has a namesake in the house, a person or the route of one; otherwise `faults` lists
 * those without. Without names the house must have one person. */
bool report_loci_check(const House *house, const ObservedLoci *observed, Fault *fault);

/* True if there are loci to compare: some people in chairs, few enough to be distinguished. */
bool report_loci_make_sense(const House *house);

void report_loci_add(Document *document, const HouseReport *report);
