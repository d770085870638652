/* The facts of planned paths as rows, for `check` and `check --json`: who can leave, by which exit, and what is too
 * narrow for the others. People on foot follow a field to the nearest exit: they have no planned path, and no numbers
 * of one.
 */
#pragma once

#include "house/journey.h"
#include "inquiry/grade.h"
#include "result/census.h"
#include "result/result.h"

/* Returns an observation in which each person with a path is out. observation_free releases it. */
Observation result_check_observation(const House *house, const Journeys *journeys);

/* A record for each person of the house; or only for those who are alone in their party of the census. */
ResultTable result_check_people(const House *house, const Journeys *journeys, const Census *only_single);

/* A record for each party of several people, with the first of them who cannot leave. The observation is the one
 * above. */
ResultTable result_check_parties(const House *house, const Observation *observation, const Census *census);

/* A record for each chair that is driven, with its grade (grades: person_count of them; profiles that are not driven
 * are left out). */
ResultTable result_check_grades(const House *house, const Grade *grades);

/* A record for each place that stands between a chair and a better grade, with the change that buys it there. */
ResultTable result_check_grade_places(const House *house, const Grade *grades);

/* Returns "p1 can leave by e1", "All 40 people can leave", or who cannot and why, as one sentence. */
const char *result_check_sentence(const House *house, const Observation *observation, const Census *census,
                                  Arena *arena);
