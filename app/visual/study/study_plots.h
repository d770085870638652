/* A study as plots: those that fit its axes and observables.
 *
 *     no axis     how often each value came: bars, mean, what lies between 5 and 95 % of the runs
 *     one axis    the orbit diagram (all that each run lists, pass by pass); each observable against the parameter
 *                 where each value has several starts, the shares of the basins
 *     two axes    a map of each observable: classes, or a quantity from light to dark; over starts, the basins
 *
 * A parameter in m or s is shown in mm or ms where its values are small. */
#pragma once

#include "plot/plot.h"
#include "plot/plot_write.h"
#include "exchange/measured.h"
#include "study/study.h"

typedef struct StudyPlot {
    const char *name; /* of its files: "peaks", "map-period" */
    Plot plot;
} StudyPlot;

typedef struct StudyPlots {
    StudyPlot *plots; /* (count) */
    size_t count;
    Arena arena; /* holds the data of the plots */
} StudyPlots;

/* Makes all plots of the completed trials, with the measured points, or NULL, laid over. The study must outlive the
 * plots; study_plots_free releases them. */
StudyPlots study_plots_make(const Study *study, const Measured *measured);
void study_plots_free(StudyPlots *plots);

/* Writes them as files OUT/plot-NAME.png, .svg, .pdf and .csv. Returns 0, or errno, and `path` is the file that
 * failed. */
int study_plots_write(const Study *study, const Measured *measured, const char *out, const PlotSheet *sheet,
                      char path[PLOT_WRITE_PATH]);

/* Lists the measurable quantities of a study: its parameters, its observables, the values that runs list. (count) in
 * the arena. */
const MeasuredKind *study_plots_kinds(const Study *study, size_t *count, Arena *arena);
