/* The facts of types I, II and III as rows: for `study --types`, `run`, their JSON and the report of the paper. */
#pragma once

#include "result/result.h"
#include "study/types.h"

/* One record: the type, and what decided it. */
ResultTable result_types_kind(const Types *types);

/* A record for each parameter of the window: its value, its sensitivity, and where things change on either side. */
ResultTable result_types_parameters(const Types *types, const Experiment *experiment);

/* A record for each point of the window; and one for each answer at a point. */
ResultTable result_types_points(const Types *types, const Experiment *experiment);
ResultTable result_types_answers(const TypesPoint *point, const Experiment *experiment);

/* One record: the runs on which the type rests, and the advice; `cycles` as for advice_write. */
ResultTable result_types_basis(const Types *types, const Experiment *experiment, int cycles);
