/* Pictures, plots and sound of a running beam: functions of Laboratory with a BeamSession as context. */
#pragma once

#include "laboratory/beam/session.h"

void beam_picture_set_camera(void *context, Camera camera);
void beam_picture_set_layers(void *context, unsigned layers);
const Scene *beam_picture_still(void *context);
const Scene *beam_picture_added(const void *context);
const Scene *beam_picture_moving(const void *context);
size_t beam_picture_plot_count(const void *context);
LaboratoryPlot beam_picture_plot(const void *context, size_t index);
size_t beam_picture_points_until(const void *context, size_t index, size_t series, double time);
bool beam_picture_sound(void *context, double from, double to, float *samples, size_t count);
