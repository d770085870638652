/* Drivers of a population and grades at the places of an inspection, for `clearance rules --drivers`. */
#pragma once

#include "experiment/drivers.h"
#include "inquiry/grade.h"
#include "inquiry/shares.h"
#include "rules/inspection.h"

/* Counts at each place whose chair does not get through (`shares`, by geometry), who touches something there and who
 * gets out (`drivers`, by simulation), and notes the tightest grade. `shares` and `grades`: (person_count). The name of
 * the population is borrowed. */
void result_rules_drivers_take(Inspection *inspection, const House *house, const char *population,
                               const Drivers *drivers, const Shares *shares, const Grade *grades);
