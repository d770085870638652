/* How many drivers of a population get through, as rows: one record for each person of the population. */
#pragma once

#include "inquiry/shares.h"
#include "result/result.h"
#include "study/montecarlo.h"

/* shares: (person_count). People whose shares were interrupted are left out. */
ResultTable result_shares_table(const House *house, const Shares *shares);

/* Returns a share with its limits, "12 % (7 to 20)". */
const char *result_shares_text(Arena *arena, const Share *share);
