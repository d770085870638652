/* What each part of the driving law is worth, as rows: the same drivers with one part left out at a time. */
#pragma once

#include "base/text.h"
#include "experiment/ablation.h"
#include "result/result.h"

/* A record for each variant of one person, with the difference from the whole law or, for the paper's model without one
 * of its forces, from that model whole; no records: the person is not of the population. Differences of times are those
 * of drivers who get out of both, with their 95 % interval by Student's t. */
ResultTable result_ablation_table(const Ablation *ablation, size_t person);

/* A record for each variant: its name, what is left out, and the settings. */
ResultTable result_ablation_variants(const Population *population);

/* Adds a sentence for each variant of one person: what leaving that part out has changed. */
void result_ablation_say(Text *text, const Ablation *ablation, size_t person);
