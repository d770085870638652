/* Pictures, plots and sound of a running beam: functions of Laboratory with a BeamSession as context. */
#pragma once

#include "laboratory/beam/session.h"

void beam_show_look(void *context, Camera camera);
void beam_show_reveal(void *context, unsigned layers);
const Scene *beam_show_still(void *context);
const Scene *beam_show_added(const void *context);
const Scene *beam_show_moving(const void *context);
size_t beam_show_plot_count(const void *context);
LaboratoryPlot beam_show_plot(const void *context, size_t index);
size_t beam_show_until(const void *context, size_t index, size_t series, double time);
bool beam_show_sound(void *context, double from, double to, float *samples, size_t count);
