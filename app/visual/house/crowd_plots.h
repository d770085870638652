/* Curves of a crowd: how many people are out over time, and how many a second leave by each exit. */
#pragma once

#include "house/observation.h"
#include "plot/plot.h"

/* Each fills in axes, series, guides and note of a plot; all its data live in the arena. `before` NULL: no comparison,
 * otherwise it is drawn behind, under this name. */
void crowd_plots_out(Plot *plot, const House *house, const Observation *observation, const Observation *before,
                     const char *name, Arena *arena);
void crowd_plots_flow(Plot *plot, const House *house, const Observation *observation, Arena *arena);
