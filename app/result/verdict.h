/* The verdict on a motion and what it rests on: exponents, its shape, whether it lasts, and how many cycles its peaks
 * rest on. `cycle` is the word for one: "cycle", "revolution". */
#pragma once

#include "base/text.h"
#include "cycle/response.h"
#include "result/result.h"

/* Adds the rows to those of the motion. */
void result_verdict_add(ResultTable *table, const Response *response, const char *cycle);

/* Adds the multiplier of an orbit and the peaks of the recorded cycles. */
void result_verdict_add_peaks(ResultTable *table, const Response *response);

/* Adds sentences, one per line. */
void result_verdict_say(Text *text, const Response *response, const char *cycle);

/* Adds the verdict as the beginning of a sentence: "Periodic, period 2", "Chaotic in 3 bands". */
void result_verdict_name(Text *text, const Response *response, const char *cycle);
