/* Plots and sound of a running beam: functions of Laboratory with a BeamSession as context. */
#pragma once

#include "laboratory/beam/session.h"

size_t beam_picture_plot_count(const void *context);
LaboratoryPlot beam_picture_plot(const void *context, size_t index);
size_t beam_picture_points_until(const void *context, size_t index, size_t series, double time);
bool beam_picture_sound(void *context, double from, double to, float *samples, size_t count);
