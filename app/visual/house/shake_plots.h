/* Evacuation times after an earthquake as a plot: the share of shakes in which all people, and each of a few people,
 * are out within a time. */
#pragma once

#include "plot/plot.h"
#include "result/shake_findings.h"

/* False if nobody ever leaves: the plot would be empty. Its data lives in the arena. */
bool shake_plots_times(Plot *plot, const ShakeFindings *findings, Arena *arena);
