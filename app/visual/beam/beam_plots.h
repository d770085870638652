/* What a beam's response shows: plots by name, of its tip. Deflections are in mm and times in ms, since that is how
 * they are read; the recording itself (trace.csv) is in m and s. */
#pragma once

#include "beam/response.h"
#include "plot/plot.h"
#include "exchange/measured.h"
#include "visual/study/plot_choice.h"

enum { BEAM_PLOTS_KNOWN = 6 /* plots */ };

#define BEAM_PLOTS_NAMES "phase,poincare,force,displacement,velocity,spectrum"
#define BEAM_PLOTS_USUAL "phase,poincare,force"

/* "phase,force" as a choice, see plot_choice.h. */
bool beam_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]);

/* "phase", "poincare" and so on. */
const char *beam_plots_name(size_t index);

/* What may be measured of a response: time, deflection, velocity, force. */
const MeasuredKind *beam_plots_kinds(size_t *count);

typedef struct BeamPlots {
    PlotChoice choice;
    Plot plots[BEAM_PLOTS_KNOWN]; /* (choice.count) */
    Arena arena;                  /* holds all they show */
} BeamPlots;

/* The chosen plots, with the measured points, or NULL, laid over; what they are made of need not outlive them.
 * beam_plots_free releases them. */
BeamPlots beam_plots_make(const Response *response, const Beam *beam, const Measured *measured,
                          const PlotChoice *choice);
void beam_plots_free(BeamPlots *plots);
