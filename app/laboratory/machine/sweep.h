/* An orbit diagram, computed in parts: the peak forces of the recorded cycles over one parameter.
 *
 * From rest, the values are ordered from coarse to fine: first every `coarse`th value, then the values between them;
 * each value is a study's trial (study/experiment.h) of the finest grid. Upwards and downwards, the values follow one
 * another, and each run continues from the end of the previous one. */
#pragma once

#include "base/stop.h"
#include "laboratory/machine/machine.h"

typedef enum MachineSweepPass {
    MACHINE_SWEEP_REST,
    MACHINE_SWEEP_UP,
    MACHINE_SWEEP_DOWN,
    MACHINE_SWEEP_PASSES
} MachineSweepPass;

/* The task of a sweep. */
typedef struct MachineSweepTask {
    const MachineKind *kind;
    Machine machine;
    const char *name; /* name of the parameter in the kind's table */
    double from, to;
    bool carried; /* upwards and downwards instead of from rest */
} MachineSweepTask;

typedef struct MachineSweep {
    MachineSweepTask task;
    Experiment experiment;
    size_t done; /* number of computed values */
    MachineCarry carry;
} MachineSweep;

/* Peaks (count) over values, without peaks that would be drawn on top of each other. */
typedef struct MachineSweepPoints {
    double *value, *peak; /* parameter's unit, N */
    size_t count, value_capacity, peak_capacity;
} MachineSweepPoints;

void machine_sweep_points_add(MachineSweepPoints *points, double value, double peak);
void machine_sweep_points_clear(MachineSweepPoints *points);

/* Begins a sweep; `place` begins the texts of faults. False: a fault, and there is nothing to close. */
bool machine_sweep_open(MachineSweep *sweep, const MachineSweepTask *task, Fault *fault);
void machine_sweep_close(MachineSweep *sweep);

/* Return the number of values, the nth value, and its pass. */
size_t machine_sweep_values(const MachineSweepTask *task);
double machine_sweep_value(const MachineSweepTask *task, size_t nth, MachineSweepPass *pass);

/* Computes the next values and adds their peaks to the points of the passes. False: all values are computed, or the
 * sweep was stopped. */
bool machine_sweep_advance(MachineSweep *sweep, int jobs, const Stop *stop,
                           MachineSweepPoints points[MACHINE_SWEEP_PASSES]);
