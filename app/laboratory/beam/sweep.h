/* An orbit diagram, made bit by bit: the peak forces of the recorded cycles over one parameter.
 *
 * From rest, the values come from coarse to fine, 31 of them, then those between; what comes of each is a study's trial
 * (beam_experiment.h) of the finest grid. Upwards and downwards, the values come one after the other, each run going on
 * from where the one before has ended. */
#pragma once

#include "experiment/beam_experiment.h"

enum {
    BEAM_SWEEP_STEPS = 481,         /* values, from rest */
    BEAM_SWEEP_COARSE = 16,         /* steps, of the first values */
    BEAM_SWEEP_CARRIED_STEPS = 241, /* values of each pass upwards and downwards */
};

typedef enum BeamSweepPass { BEAM_SWEEP_REST, BEAM_SWEEP_UP, BEAM_SWEEP_DOWN, BEAM_SWEEP_PASSES } BeamSweepPass;

/* The task of a sweep. */
typedef struct BeamSweepTask {
    Beam beam;        /* its texts are another one's */
    const char *name; /* of the parameter, as in beam_table */
    double from, to;
    bool carried; /* upwards and downwards, not from rest */
} BeamSweepTask;

typedef struct BeamSweep {
    BeamSweepTask task;
    Experiment experiment;
    size_t done; /* values */
    BeamCarry carry;
} BeamSweep;

/* Peaks (count) over values, without those that fall upon each other. */
typedef struct BeamSweepPoints {
    double *value, *peak; /* parameter's unit, N */
    size_t count, value_capacity, peak_capacity;
} BeamSweepPoints;

void beam_sweep_points_add(BeamSweepPoints *points, double value, double peak);
void beam_sweep_points_clear(BeamSweepPoints *points);

/* Begins; `place` begins faults. False: a fault, and there is nothing to close. */
bool beam_sweep_open(BeamSweep *sweep, const BeamSweepTask *task, Fault *fault);
void beam_sweep_close(BeamSweep *sweep);

/* Returns the number of values, the nth value, and its pass. */
size_t beam_sweep_values(const BeamSweepTask *task);
double beam_sweep_value(const BeamSweepTask *task, size_t nth, BeamSweepPass *pass);

/* Makes some more values and adds what comes of them to the passes' points. False: all are made, or it was stopped. */
bool beam_sweep_go_on(BeamSweep *sweep, int jobs, const volatile sig_atomic_t *stop,
                      BeamSweepPoints points[BEAM_SWEEP_PASSES]);
