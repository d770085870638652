/* Many drivers of one person as plots: who is out when, beside what was measured, and how fast they go. */
#pragma once

#include "experiment/drivers.h"
#include "plot/plot.h"

typedef enum DriversPlotKind { DRIVERS_PLOT_TIMES, DRIVERS_PLOT_SPEEDS, DRIVERS_PLOTS } DriversPlotKind;

/* A plot with its numbers and texts. */
typedef struct DriversPlot {
    Plot plot;
    double *numbers;
    Arena arena;
} DriversPlot;

/* Makes a plot of one person. Times: a dot for each driver who is out, the share who are out by then, the nominal
 * driver's time, and the measured mean and deviation of the person's route where the person is alone on it. Speeds: 5
 * to 95 %, 25 to 75 % and the nominal driver along the way. drivers_plot_free releases it. */
DriversPlot drivers_plot_make(DriversPlotKind kind, const House *house, const Observation *nominal,
                              const Drivers *drivers, size_t person);
void drivers_plot_free(DriversPlot *plot);
