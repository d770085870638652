/* The names that `--set` takes for a house. */
#pragma once

#include "base/text.h"
#include "plan/plan.h"

/* Adds a line for each name: the name, a tab, and what it means. Lists, which cannot be written as one word, are left
 * out. */
void plan_names_add(Text *text, const Plan *plan);
