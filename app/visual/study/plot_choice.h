/* Which plots of those that a laboratory knows are wanted, chosen by words. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum {
    PLOT_CHOICE_MOST = 8, /* plots that a laboratory may know */
    PLOT_CHOICE_FAULT = 256,
};

/* Some of the known plots, in some order. */
typedef struct PlotChoice {
    size_t indices[PLOT_CHOICE_MOST]; /* (count) each once */
    size_t count;
} PlotChoice;

/* "speed,clearance" as a choice of the known names (count). False: `fault` says which word is none, and which are, and
 * the choice is as it was. */
bool plot_choice_read(PlotChoice *choice, const char *text, const char *const *known, size_t count,
                      char fault[PLOT_CHOICE_FAULT]);
