/* Shares of basins along a parameter, as bands that add up to 1. */
#pragma once

#include "plot/plot.h"
#include "study/basins.h"
#include "visual/study/study_axes.h"

enum { BASIN_PLOTS_BANDS = 10 };

/* Adds the bands to a plot with room for BASIN_PLOTS_BANDS areas. Answers of one kind at one value are told apart by
 * their measure, the largest first. */
void basin_plots_add(Plot *plot, const Study *study, double factor, Arena *arena);
