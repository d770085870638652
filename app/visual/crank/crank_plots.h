/* The response of a slider crank as plots, by name. Lengths are in mm and times in ms for reading; the recording itself
 * (trace.csv) is in m and s. */
#pragma once

#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "plot/plot.h"
#include "visual/study/plot_choice.h"

enum { CRANK_PLOTS_KNOWN = 7 /* plots */ };

#define CRANK_PLOTS_NAMES "phase,poincare,force,angle,across,slider,spectrum"
#define CRANK_PLOTS_USUAL "phase,poincare,force,angle"

/* Reads "phase,force" as a choice, see plot_choice.h. */
bool crank_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]);

/* Returns "phase", "poincare" and so on. */
const char *crank_plots_name(size_t index);

typedef struct CrankPlots {
    PlotChoice choice;
    Plot plots[CRANK_PLOTS_KNOWN]; /* (choice.count) */
    Arena arena;                   /* holds the data of the plots */
} CrankPlots;

/* Makes the chosen plots; their inputs need not outlive them. crank_plots_free releases them. */
CrankPlots crank_plots_make(const Response *response, const Crank *crank, const PlotChoice *choice);
void crank_plots_free(CrankPlots *plots);
