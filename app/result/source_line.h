/* The line at the foot of a picture that says where its numbers come from, so that a plot can be cut out of a report
 * without losing that: "Ube house: assumed plan, not measured"; "ibs: of 22 numbers 2 from the paper, 4 reconstructed,
 * 8 identified, 8 assumed". */
#pragma once

#include "base/memory.h"
#include "beam/beam.h"
#include "crank/crank.h"
#include "plan/plan.h"

/* True if the plan's note says that the plan is assumed. */
bool source_line_is_assumed(const Plan *plan);

/* The lines are in the arena. */
const char *source_line_house(const Plan *plan, Arena *arena);
const char *source_line_beam(const Beam *beam, Arena *arena);
const char *source_line_crank(const Crank *crank, Arena *arena);
