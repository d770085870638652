/* Maps of a study of two axes: each observable over both parameters, as classes where it is one of few, otherwise as a
 * quantity; over the two numbers of a start, which start leads to which attractor. */
#pragma once

#include "visual/study/study_plots.h"

/* The most maps that a study can have. */
size_t study_maps_most(const Study *study);

/* Makes them, behind those that are there already; `plots` has room. */
void study_maps_add(StudyPlots *plots, const Study *study, const Measured *measured);
