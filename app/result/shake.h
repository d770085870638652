/* The findings of many earthquakes as rows, for `study --shake`, its JSON, the list beside the plan and the report. The
 * findings must outlive the tables. */
#pragma once

#include "result/result.h"
#include "result/shake_findings.h"

/* One record: how often all people are out, within what time, and with what result without a shake. */
ResultTable result_shake_answer(const ShakeFindings *findings);

/* One record: how often something else than standing furniture stops people. */
ResultTable result_shake_stops(const ShakeFindings *findings);

/* A record for each person and each crowd who take part. */
ResultTable result_shake_people(const ShakeFindings *findings);

/* A record for each piece of furniture that can fall or that stops people, the worst first. */
ResultTable result_shake_furniture(const ShakeFindings *findings);

/* Returns "100 shakes were simulated, with seeds from 1 on". */
const char *result_shake_simulated(const ShakeFindings *findings, Arena *arena);
