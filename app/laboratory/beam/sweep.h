/* An orbit diagram, computed in parts: the peak forces of the recorded cycles over one parameter.
 *
 * From rest, the values are ordered from coarse to fine: first 31 values, then the values between them; each value
 * is a study's trial (beam_experiment.h) of the finest grid. Upwards and downwards, the values follow one another,
 * and each run continues from the end of the previous one. */
#pragma once

#include "base/stop.h"
#include "experiment/beam_experiment.h"

enum {
    BEAM_SWEEP_STEPS = 481,         /* values from rest */
    BEAM_SWEEP_COARSE = 16,         /* steps between the first values */
    BEAM_SWEEP_CARRIED_STEPS = 241, /* values of each pass, upwards and downwards */
};

typedef enum BeamSweepPass { BEAM_SWEEP_REST, BEAM_SWEEP_UP, BEAM_SWEEP_DOWN, BEAM_SWEEP_PASSES } BeamSweepPass;

/* The task of a sweep. */
typedef struct BeamSweepTask {
    Beam beam;        /* the texts belong to another beam */
    const char *name; /* name of the parameter in beam_table */
    double from, to;
    bool carried; /* upwards and downwards instead of from rest */
} BeamSweepTask;

typedef struct BeamSweep {
    BeamSweepTask task;
    Experiment experiment;
    size_t done; /* number of computed values */
    BeamCarry carry;
} BeamSweep;

/* Peaks (count) over values, without peaks that would be drawn on top of each other. */
typedef struct BeamSweepPoints {
    double *value, *peak; /* parameter's unit, N */
    size_t count, value_capacity, peak_capacity;
} BeamSweepPoints;

void beam_sweep_points_add(BeamSweepPoints *points, double value, double peak);
void beam_sweep_points_clear(BeamSweepPoints *points);

/* Begins a sweep; `place` begins the texts of faults. False: a fault, and there is nothing to close. */
bool beam_sweep_open(BeamSweep *sweep, const BeamSweepTask *task, Fault *fault);
void beam_sweep_close(BeamSweep *sweep);

/* Return the number of values, the nth value, and its pass. */
size_t beam_sweep_values(const BeamSweepTask *task);
double beam_sweep_value(const BeamSweepTask *task, size_t nth, BeamSweepPass *pass);

/* Computes the next values and adds their peaks to the points of the passes. False: all values are computed, or the
 * sweep was stopped. */
bool beam_sweep_advance(BeamSweep *sweep, int jobs, const Stop *stop, BeamSweepPoints points[BEAM_SWEEP_PASSES]);
