/* A rig is the fixed part of a motion: the beam as modes and regimes, the drive and the joint, prepared once. Only
 * rig_drive changes it while motions run. */
#pragma once

#include <stdbool.h>

#include "beam/beam.h"
#include "beam/modes.h"
#include "beam/regime.h"

/* Steady response of a regime to the drive: Z = sine sin(omega t) + cosine cos(omega t) + side rest; likewise of the
 * rows. */
typedef struct RigSteady {
    RegimeVector sine, cosine, rest;
    double row_sine[REGIME_ROWS], row_cosine[REGIME_ROWS], row_rest[REGIME_ROWS];
} RigSteady;

/* Change from the blocks of one regime to those of the other with a continuous state: Z' = C Z plus the old steady
 * part minus the new one, sine sin(omega t) + cosine cos(omega t) + side rest, for the side that is touched or left. */
typedef struct RigChange {
    RegimeVector by_re, by_im;       /* (blocks before x blocks after) C: contributions of Re Z and Im Z of a block */
    RegimeVector sine, cosine, rest; /* (blocks after) */
} RigChange;

/* The beam as modes and regimes, the drive and the joint. */
typedef struct Rig {
    Modes modes;
    Regime free, contact;
    RigSteady steady_free, steady_contact;
    RigChange touch, leave;               /* at the beginning and the end of a contact */
    double omega, period;                 /* rad/s, s, of the drive */
    double force;                         /* N, amplitude of the drive */
    double clearance, stiffness, damping; /* m, N/m, N s/m, of the joint */
    int release;                          /* BeamRelease */
    double cell;                          /* s, of both regimes: at most a period / RIG_CELLS */
    double first_free, first_contact;     /* s, step after a switch: a cell, or less where a mode decays faster */
    bool shares_cells;                    /* the regimes' tables belong to another rig */
    double cell_sine, cell_cosine;        /* of omega times cell */
} Rig;

/* Largest number of cells per cycle of the drive, for a run time of seconds. */
#define RIG_CELLS_MOST 1e7

/* Prepares the rig of a beam. Returns false after an error at the place `place`, with nothing to clear. */
bool rig_build(Rig *rig, const Beam *beam, const char *place, Fault *fault);

/* Does the same, with modes of the signs that those of a similar rig have: so that a state of one is nearly one of the
 * other. */
bool rig_build_like(Rig *rig, const Beam *beam, const Rig *like, const char *place, Fault *fault);

/* Prepares a rig from existing modes and takes ownership of them. Returns false, with everything released, if the
 * eigenproblem has no solution. */
bool rig_of_modes(Rig *rig, Modes *modes, const Beam *beam);

/* Sets the drive's frequency (Hz) and force (N); modes and regimes stay, and so do cells unless the drive is too
 * fast. */
void rig_drive(Rig *rig, double frequency, double force);

/* Least number of steps per cycle of the drive. */
enum { RIG_CELLS = 16 };

/* Advances sin(omega t) and cos(omega t) by a time, s, of at most a cell and half a part of it, by Taylor series
 * whose next terms are below 1e-16, so that every processor gives the same bits. */
void rig_turn_drive(const Rig *rig, double time, double *sine, double *cosine);

void rig_clear(Rig *rig);

/* Computes changed = C Z. */
void rig_change_blocks(const RigChange *change, const Regime *before, const Regime *after, RegimeVector z,
                       RegimeVector changed);

/* Returns a rig with its own drive and clearance and the modes and regimes of the first one, which keeps them and must
 * outlive the new rig. rig_clear_shared releases the new rig. */
Rig rig_share(const Rig *rig, double frequency, double force, double clearance);
void rig_clear_shared(Rig *rig);

/* Returns the steady amplitude of the tip without a joint, m: nothing touches while it is below the clearance. */
double rig_free_amplitude(const Rig *rig);

/* Fraction of the tip's room (the clearance, and its amplitude without the joint) below which a motion counts as
 * rest: smaller differences have no meaning. */
#define RIG_REST 1e-2

/* Return that deflection of the tip, m, and the norm of the smallest state with it, sqrt(J). */
double rig_rest_deflection(const Rig *rig);
double rig_rest_state(const Rig *rig);
