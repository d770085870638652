/* Plots and sound of a running crank: functions of Laboratory with a CrankSession as context. */
#pragma once

#include "laboratory/crank/session.h"

size_t crank_picture_plot_count(const void *context);
LaboratoryPlot crank_picture_plot(const void *context, size_t index);
size_t crank_picture_points_until(const void *context, size_t index, size_t series, double time);
bool crank_picture_sound(void *context, double from, double to, float *samples, size_t count);
