/* The orbit diagram of a running beam: a plot that grows while it is computed, with the cursor on the present value
 * of its parameter. */
#pragma once

#include "laboratory/beam/controls.h"
#include "laboratory/beam/worker.h"

enum { BEAM_DIAGRAM_OVER = 6 /* parameters over which a diagram can be made */ };

typedef struct BeamDiagram {
    Plot plot;
    PlotSeries series[BEAM_SWEEP_PASSES + 1]; /* the saved points, then the passes */
    BeamSweepPoints points[BEAM_SWEEP_PASSES + 1];
    unsigned revision;
    size_t over; /* index of the parameter */
    bool carried;
    BeamSweepTask task; /* the displayed or requested task */
    double factor;      /* displayed value = value x factor */
    char cursor[40];
} BeamDiagram;

extern const char *const beam_diagram_over[BEAM_DIAGRAM_OVER];  /* names of the parameters in the table, */
extern const char *const beam_diagram_words[BEAM_DIAGRAM_OVER]; /* and for display */

void beam_diagram_open(BeamDiagram *diagram);
void beam_diagram_close(BeamDiagram *diagram);

/* Requests the diagram of a beam, unless it is displayed or requested: the present value of its own parameter does
 * not matter. */
void beam_diagram_ask(BeamDiagram *diagram, const BeamControls *controls, const Beam *beam, BeamWorker *worker);

/* Takes over new points. */
void beam_diagram_apply(BeamDiagram *diagram, BeamNews *news);

/* Saves the diagram for comparison, or forgets the saved one. */
void beam_diagram_store(BeamDiagram *diagram, bool keep);
