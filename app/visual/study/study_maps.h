/* Maps of a study of two axes: each observable over both parameters, as classes if it has few values, otherwise as a
 * quantity; over two numbers of a start, the attractor of each start. */
#pragma once

#include "visual/study/study_plots.h"

/* Returns the largest number of maps of a study; 0 without two axes. */
size_t study_maps_most(const Study *study);

/* Adds the `nth` of them to `plots`, which must have room, if it tells anything. Of more than a thousand values of an
 * axis, which no picture can tell apart, evenly spaced ones are shown. */
void study_maps_add(StudyPlots *plots, const Study *study, const Measured *measured, size_t nth);
