/* The figures of the paper that can be reproduced (2 to 10), from runs and studies of a beam, as plots. */
#pragma once

#include "plot/plot.h"
#include "visual/beam/beam_plots.h"
#include "experiment/paper.h"
#include "visual/study/study_plots.h"

enum { PAPER_FIGURES = 10 };

typedef struct PaperFigure {
    const char *name;    /* of its files: "figure-2-phase" */
    const char *title;   /* "Figure 2" */
    const char *caption; /* its content, in a sentence */
    const Plot *plot;    /* NULL: not available */
} PaperFigure;

typedef struct PaperFigures {
    PaperFigure figures[PAPER_FIGURES];
    BeamPlots responses[PAPER_RUNS];
    StudyPlots studies[PAPER_STUDIES];
    Plot low_peaks; /* the peaks against frequency in the paper's range of forces */
} PaperFigures;

/* Makes the figures; the paper must outlive them; paper_figures_free releases them. */
PaperFigures *paper_figures_make(const Paper *paper);
void paper_figures_free(PaperFigures *figures);
