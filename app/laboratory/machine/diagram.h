/* The orbit diagram of a running machine: a plot that grows while it is computed, with the cursor on the present value
 * of its parameter. */
#pragma once

#include "laboratory/machine/controls.h"
#include "laboratory/machine/worker.h"
#include "visual/study/type_bands.h"

/* Series of the plot. */
enum {
    MACHINE_DIAGRAM_SAVED,
    MACHINE_DIAGRAM_PASSES,                                                /* (MACHINE_SWEEP_PASSES) */
    MACHINE_DIAGRAM_LINES = MACHINE_DIAGRAM_PASSES + MACHINE_SWEEP_PASSES, /* (MACHINE_LINES) of a followed orbit */
    MACHINE_DIAGRAM_OLDER = MACHINE_DIAGRAM_LINES + MACHINE_LINES, /* of other numbers, until there are new points */
    MACHINE_DIAGRAM_SERIES
};

typedef struct MachineDiagram {
    Plot plot;
    PlotSeries series[MACHINE_DIAGRAM_SERIES];
    PlotArea areas[TYPE_BANDS];
    Arena band_words;   /* of the areas */
    MachineLines lines; /* in the displayed unit */
    bool follows;       /* an orbit is followed, or asked for */
    MachineSweepPoints points[MACHINE_SWEEP_PASSES + 1];
    MachineSweepPoints older;
    size_t done; /* number of values of the task whose points are in */
    unsigned revision;
    size_t over; /* index of the parameter among those of the kind */
    bool carried;
    MachineSweepTask task; /* the displayed or requested task */
    double factor;         /* displayed value = value x factor */
    char cursor[40];
} MachineDiagram;

void machine_diagram_open(MachineDiagram *diagram, const MachineKind *kind);
void machine_diagram_close(MachineDiagram *diagram);

/* Requests the diagram of a machine, unless it is displayed or requested: the present value of its own parameter does
 * not matter. */
void machine_diagram_ask(MachineDiagram *diagram, const MachineControls *controls, const Machine *machine,
                         MachineWorker *worker);

/* Asks for the orbit to be followed that the motion at `state` (count) is on, or removes the one that is displayed or
 * asked for. Returns true if it was asked for. */
bool machine_diagram_follow(MachineDiagram *diagram, MachineWorker *worker, const Machine *machine, const double *state,
                            size_t count);

/* Takes over new points. */
void machine_diagram_apply(MachineDiagram *diagram, MachineNews *news);

/* Saves the diagram for comparison, or forgets the saved one. */
void machine_diagram_store(MachineDiagram *diagram, bool keep);

/* Returns the diagram as a plot next to the view, without its names. */
LaboratoryPlot machine_diagram_shown(const MachineDiagram *diagram, const MachineControls *controls);
