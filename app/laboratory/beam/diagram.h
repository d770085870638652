/* The orbit diagram of a running beam, as a plot that grows while it is worked out, with the cursor on the present
 * value of its parameter. */
#pragma once

#include "laboratory/beam/controls.h"
#include "laboratory/beam/worker.h"

enum { BEAM_DIAGRAM_OVER = 6 /* parameters that it may go over */ };

typedef struct BeamDiagram {
    Plot plot;
    PlotSeries series[BEAM_SWEEP_PASSES + 1]; /* what was kept, then the passes */
    BeamSweepPoints points[BEAM_SWEEP_PASSES + 1];
    unsigned revision;
    size_t over; /* which parameter */
    bool carried;
    BeamSweepTask task; /* of what is shown or asked for */
    double factor;      /* value shown = value x factor */
    char cursor[40];
} BeamDiagram;

extern const char *const beam_diagram_over[BEAM_DIAGRAM_OVER];  /* names of parameters, */
extern const char *const beam_diagram_words[BEAM_DIAGRAM_OVER]; /* and for people */

void beam_diagram_open(BeamDiagram *diagram);
void beam_diagram_close(BeamDiagram *diagram);

/* Asks for the diagram of a beam, unless it is there or asked for: it does not depend on the parameter it goes over. */
void beam_diagram_ask(BeamDiagram *diagram, const BeamControls *controls, const Beam *beam, BeamWorker *worker);

/* Takes new points over. */
void beam_diagram_take(BeamDiagram *diagram, BeamNews *news);

/* Saves the diagram for comparison, or forgets the saved one. */
void beam_diagram_keep(BeamDiagram *diagram, bool keep);
