/* The facts of a slider crank's response as rows, for `run` and `run --json`. */
#pragma once

#include "base/text.h"
#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "result/result.h"

/* One record of the drive and the motion: periodic or chaotic, and what that rests on. The crank may go before it. */
ResultTable result_crank_motion(const Crank *crank, const Response *response);

/* One record of forces and contact; `ideal`: the largest force of a joint without clearance, N, or NAN. */
ResultTable result_crank_forces(const Tree *tree, const Response *response, double ideal);

/* Adds the verdict with its forces as the first line; `ideal` as above. */
void result_crank_name(Text *text, const Crank *crank, const Response *response, double ideal);

/* Adds what only a crank has, one sentence per line: whether the pin leaves its socket, friction, and multiples of the
 * speed near natural frequencies. */
void result_crank_say(Text *text, const Crank *crank, const Tree *tree, const Response *response);
