/* The plot of a fit: the residual of each measured value before and after it. */
#pragma once

#include "plot/plot.h"
#include "study/fit.h"

/* Makes the plot; its numbers live as long as the arena, and the texts as long as the fit. */
void fit_plots_residuals(Plot *plot, const Fit *fit, Arena *arena);
