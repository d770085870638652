/* Numbers of a study as axes of plots. */
#pragma once

#include "plot/plot.h"
#include "study/numbers.h"
#include "study/study.h"

/* A quantity on an axis: its values times `factor` are in `axis.unit`. */
typedef struct StudyScale {
    PlotAxis axis;
    double factor;
} StudyScale;

/* Returns the axis of a parameter, titled by its name: "drive frequency"; without ends. */
StudyScale study_axes_parameter(const Study *study, size_t axis, Arena *arena);

/* Returns the axis of an observable, or of the values that runs list. */
StudyScale study_axes_observable(const Observable *observable);

/* Returns an observable of a trial; NAN if it is not done, failed, or has none. */
double study_axes_value(const Trial *trial, size_t observable);

/* An observable of the runs of a point; of a study without an axis, of all runs. */
typedef struct StudyRuns {
    const Study *study;
    size_t pass, point, observable;
} StudyRuns;

/* Returns them as numbers, which read `runs`. */
Numbers study_axes_runs(const StudyRuns *runs);

/* Returns the index of the observable of that name; the count if there is none. */
size_t study_axes_find(const Study *study, const char *name);

/* True if the number is only a mark, as for the routes out of a house: it can be compared for equality only. */
bool study_axes_is_mark(const Study *study, size_t observable);
