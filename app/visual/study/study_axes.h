/* Numbers of a study as axes of plots show them. */
#pragma once

#include "plot/plot.h"
#include "study/study.h"

/* A quantity on an axis: its values times `factor` are in `axis.unit`. */
typedef struct StudyScale {
    PlotAxis axis;
    double factor;
} StudyScale;

/* Of a parameter, from its name: "drive frequency"; ends are not set. */
StudyScale study_axes_parameter(const Study *study, size_t axis, Arena *arena);

/* Of an observable, or of what runs list. */
StudyScale study_axes_observable(const Observable *observable);

/* An observable of a trial; NAN: it is not done, could not be run, or has none. */
double study_axes_value(const Trial *trial, size_t observable);

/* Those of all trials, as far as they are numbers, into `values` (trial_count); returns how many. */
size_t study_axes_values(const Study *study, size_t observable, double *values);

/* The index of the observable of that name; the count: there is none. */
size_t study_axes_find(const Study *study, const char *name);

/* Is it a number that only marks, as those of the ways out of a house, which says no more than whether two are the
 * same?
 */
bool study_axes_is_mark(const Study *study, size_t observable);
