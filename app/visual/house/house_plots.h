/* What a run shows as curves: plots by name, made from the columns of the trace, one series a person who took part. Of
 * many people the first chairs are shown. A second observation may be shown behind them, as what was before. */
#pragma once

#include "plot/plot.h"
#include "house/observation.h"
#include "visual/house/house_scene.h"
#include "visual/study/plot_choice.h"
#include "visual/house/trail.h"

enum { HOUSE_PLOTS_KNOWN = 5 /* plots */ };

#define HOUSE_PLOTS_NAMES "speed,clearance,force,ring,phase"

/* "speed,clearance" as a choice, see plot_choice.h. */
bool house_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]);

/* "speed", "clearance" and so on. */
const char *house_plots_name(size_t index);

typedef struct HousePlots {
    PlotChoice choice;
    Plot plots[HOUSE_PLOTS_KNOWN]; /* (choice.count) */
    Arena arena;                   /* holds all they show */
} HousePlots;

/* The chosen plots; the house and, if there is one, the ghost of it must outlive them, the observations need not.
 * `ghost_house` and `ghost` are NULL when nothing was before. house_plots_free releases them. */
HousePlots house_plots_make(const House *house, const Observation *observation, const House *ghost_house,
                            const Observation *ghost, const PlotChoice *choice);
/* The same of one person (index into House.people; SIZE_MAX: of all) and with what was before under its own word. The
 * trails are the observation's. */
HousePlots house_plots_make_of(const House *house, const Observation *observation, const Trail *trails, Before before,
                               size_t person, const PlotChoice *choice);
void house_plots_free(HousePlots *plots);

/* How many points of a series of a plot (index into `plots`) lie at or before a time, s. */
size_t house_plots_until(const HousePlots *plots, size_t plot, size_t series, double time);
