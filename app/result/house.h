/* The facts of a run of a house as rows: of people, groups of people, routes, dangerous points, and of the whole run.
 * A number that is added to one of these records appears in `run`, `run --json`, the window's panel and the report. */
#pragma once

#include "house/observation.h"
#include "result/census.h"
#include "result/result.h"

/* Adds a record of one person who took part; or of all who did. House and observation must outlive the table. */
void result_house_add_person(ResultTable *table, const House *house, const Observation *observation, size_t person);
ResultTable result_house_people(const House *house, const Observation *observation);

/* A record for each party of the census, or only for each crowd. */
ResultTable result_house_parties(const House *house, const Census *census, bool only_crowds);

/* A record for each route: (a) mean of the measured times, (b) their deviation, (c) simulated time, error
 * ((c) - (a)) / (a). */
ResultTable result_house_routes(const House *house, const Observation *observation);

/* A record for each tight place (tight.h) of a run, whichever costs most time first: all hindrances. Touches are ranked
 * apart (danger.h). */
ResultTable result_house_hindrances(const House *house, const Observation *observation);

/* A record for each dangerous point, the worst first. */
ResultTable result_house_hazards(const Observation *observation);

/* One record of the whole run: how many people are out, when, and how near they came to anything. */
ResultTable result_house_totals(const House *house, const Observation *observation);

/* Adds the rows of a place where somebody is stopped, as members of the object `blocked_at`; NULL: nobody is. */
void result_house_add_blockage(ResultTable *table, const Blockage *blockage);
