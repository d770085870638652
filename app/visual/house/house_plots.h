/* The curves of a run: plots by name, made from the columns of the trace, one series per person who took part. Of many
 * people the first chairs are shown. A second observation may be shown behind them for comparison. */
#pragma once

#include "plot/plot.h"
#include "house/observation.h"
#include "visual/house/house_scene.h"
#include "visual/study/plot_choice.h"
#include "visual/house/trail.h"

enum { HOUSE_PLOTS_KNOWN = 7 /* plots */ };

#define HOUSE_PLOTS_NAMES "speed,clearance,force,ring,phase,out,flow"

/* Reads "speed,clearance" as a choice, see plot_choice.h. */
bool house_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]);

/* Returns "speed", "clearance" and so on. */
const char *house_plots_name(size_t index);

typedef struct HousePlots {
    PlotChoice choice;
    Plot plots[HOUSE_PLOTS_KNOWN]; /* (choice.count) */
    Arena arena;                   /* holds the data of the plots */
} HousePlots;

/* Makes the chosen plots; the house and the house of the comparison must outlive them, the observations need not.
 * `ghost_house` and `ghost` are NULL without a comparison. house_plots_free releases the plots. */
HousePlots house_plots_make(const House *house, const Observation *observation, const House *ghost_house,
                            const Observation *ghost, const PlotChoice *choice);
/* Does the same for one person (index into House.people; SIZE_MAX: all) and with the comparison under its own name.
 * The trails are those of the observation. */
HousePlots house_plots_make_of(const House *house, const Observation *observation, const Trail *trails, Before before,
                               size_t person, const PlotChoice *choice);
void house_plots_free(HousePlots *plots);

/* Returns how many points of a series of a plot (index into `plots`) lie at or before a time, s. */
size_t house_plots_until(const HousePlots *plots, size_t plot, size_t series, double time);
