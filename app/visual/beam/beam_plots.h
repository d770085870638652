/* The response of a beam as plots of its tip, by name. Deflections are in mm and times in ms for reading; the
 * recording itself (trace.csv) is in m and s. */
#pragma once

#include "beam/beam_cycle.h"
#include "plot/plot.h"
#include "exchange/measured.h"
#include "visual/study/plot_choice.h"

enum { BEAM_PLOTS_KNOWN = 6 /* plots */ };

#define BEAM_PLOTS_NAMES "phase,poincare,force,displacement,velocity,spectrum"
#define BEAM_PLOTS_USUAL "phase,poincare,force"

/* Reads "phase,force" as a choice, see plot_choice.h. */
bool beam_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]);

/* Returns "phase", "poincare" and so on. */
const char *beam_plots_name(size_t index);

/* The quantities of a response that can be measured: time, deflection, velocity, force. */
const MeasuredKind *beam_plots_kinds(size_t *count);

typedef struct BeamPlots {
    PlotChoice choice;
    Plot plots[BEAM_PLOTS_KNOWN]; /* (choice.count) */
    Arena arena;                  /* holds the data of the plots */
} BeamPlots;

/* Makes the chosen plots, with the measured points, or NULL, laid over; their inputs need not outlive them.
 * beam_plots_free releases them. */
BeamPlots beam_plots_make(const Response *response, const Beam *beam, const Measured *measured,
                          const PlotChoice *choice);
void beam_plots_free(BeamPlots *plots);
