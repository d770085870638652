/* The facts of a slider crank's response as rows, for `run` and `run --json`. */
#pragma once

#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "result/result.h"

/* One record of the drive and the motion: periodic or chaotic, and what that rests on. The crank may go before it. */
ResultTable result_crank_motion(const Crank *crank, const Response *response);

/* One record of forces and contact; `ideal`: the largest force of a joint without clearance, N, or NAN. */
ResultTable result_crank_forces(const Tree *tree, const Response *response, double ideal);
