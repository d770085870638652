/* The findings of an inspection as rows, for the terminal, JSON, the picture and the report of `clearance rules`. */
#pragma once

#include "result/result.h"
#include "rules/inspection.h"

/* Returns the answer as one sentence; "Legal and impassable: ..." where rules pass and chairs are stopped. */
const char *result_rules_sentence(const Inspection *inspection, Arena *arena);

/* Returns the same in a few words, and the rest of it, for a picture. */
const char *result_rules_title(const Inspection *inspection, Arena *arena);
const char *result_rules_detail(const Inspection *inspection, Arena *arena);

/* Returns "4 checks pass, 2 fail, 1 cannot be told". */
const char *result_rules_counts(const Inspection *inspection, Arena *arena);

/* Returns the heading of a group of findings: "Rules pass, chairs are stopped". */
const char *result_rules_group(FindingGroup group);

/* A record for each finding of a group, and of all groups. */
ResultTable result_rules_findings(const Inspection *inspection, FindingGroup group);
ResultTable result_rules_all(const Inspection *inspection);

/* A record for each place where chairs are stopped; none if the inspection was interrupted. */
ResultTable result_rules_stops(const Inspection *inspection);

/* A record for each set: its title, what it applies to, its findings by verdict, which are unknown if the inspection
 * was interrupted, and what it does not check. */
ResultTable result_rules_sets(const Inspection *inspection, const RuleSets *sets);

/* Returns "pass", "fail by 0.05 m" or "cannot be told". */
const char *result_rules_verdict(const Finding *finding, Arena *arena);
