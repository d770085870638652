/* Maps of a study of two axes: each observable over both parameters, as classes if it has few values, otherwise as a
 * quantity; over two numbers of a start, the attractor of each start. */
#pragma once

#include "visual/study/study_plots.h"

/* Returns the largest number of maps of a study. */
size_t study_maps_most(const Study *study);

/* Adds the maps to `plots`, which must have room. */
void study_maps_add(StudyPlots *plots, const Study *study, const Measured *measured);
