/* A choice among the plots that a laboratory knows, by name. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum {
    PLOT_CHOICE_MOST = 8, /* plots that a laboratory can know */
    PLOT_CHOICE_FAULT = 256,
};

/* Some of the known plots, in the chosen order. */
typedef struct PlotChoice {
    size_t indices[PLOT_CHOICE_MOST]; /* (count) each once */
    size_t count;
} PlotChoice;

/* Reads "speed,clearance" as a choice of the known names (count). False: `fault` names the unknown name and lists the
 * known ones, and the choice is unchanged. */
bool plot_choice_read(PlotChoice *choice, const char *text, const char *const *known, size_t count,
                      char fault[PLOT_CHOICE_FAULT]);
