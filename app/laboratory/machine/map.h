/* The map of types of a running machine over two of its parameters: a plot whose cells are filled while it is shown,
 * with cursors on the present values of both. */
#pragma once

#include "laboratory/machine/controls.h"
#include "laboratory/machine/worker.h"

#define MACHINE_MAP_NAME "map" /* of the plot */

enum { MACHINE_MAP_CLASSES = 4 };

typedef struct MachineMap {
    Plot plot;
    PlotRaster raster;
    PlotClass classes[MACHINE_MAP_CLASSES];
    double values[MACHINE_MAP_CELLS]; /* indices into the classes; NAN: not computed */
    unsigned revision;
    bool shown; /* the plot is in the window: only then it is computed */
    bool asked; /* the map of `machine` is displayed or requested */
    Machine machine;
} MachineMap;

void machine_map_open(MachineMap *map, const MachineControls *controls);

/* Notes whether the plot is in the window, and requests or pauses its map. */
void machine_map_show(MachineMap *map, bool shown, const MachineKind *kind, const Machine *machine,
                      MachineWorker *worker);

/* Requests the map of a machine, unless it is displayed or requested: the present values of its own two parameters do
 * not matter. */
void machine_map_ask(MachineMap *map, const MachineKind *kind, const Machine *machine, MachineWorker *worker);

/* Takes over new cells. */
void machine_map_apply(MachineMap *map, const MachineNews *news);

/* Returns the map as a plot next to the view, without its names. */
LaboratoryPlot machine_map_shown(const MachineMap *map, const MachineControls *controls);
