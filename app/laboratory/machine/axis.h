/* Axes that grow in round steps, ahead of the drawn lines. */
#pragma once

#include <stdbool.h>

#include "plot/plot.h"

/* Rounds up to the next of a row of round numbers; not above 0: 1. */
double machine_axis_round_up(double value);

/* Extends an axis to at least `to`, and to both sides if `both`. True: the axis has grown. */
bool machine_axis_stretch(PlotAxis *axis, double to, bool both);
