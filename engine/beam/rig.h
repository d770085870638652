/* What a motion is of: the beam as modes and regimes, the drive and the joint, made ready once. Nothing of it changes
 * while motions run, except by rig_drive. */
#pragma once

#include <stdbool.h>

#include "beam/beam.h"
#include "beam/modes.h"
#include "beam/regime.h"

/* What of a regime the drive makes: Z = sine sin(omega t) + cosine cos(omega t) + side rest; and of the rows. */
typedef struct RigSteady {
    RegimeVector sine, cosine, rest;
    double row_sine[REGIME_ROWS], row_cosine[REGIME_ROWS], row_rest[REGIME_ROWS];
} RigSteady;

/* From the blocks of one regime to those of the other, the state staying: Z' = C Z, and the steady part that was
 * without the one that will be, sine sin(omega t) + cosine cos(omega t) + side rest, of the side that is touched or
 * left. */
typedef struct RigChange {
    RegimeVector by_re, by_im;       /* (blocks before x blocks after) C: what Re Z and Im Z of a block give */
    RegimeVector sine, cosine, rest; /* (blocks after) */
} RigChange;

/* What is given: the beam as modes and regimes, the drive and the joint. */
typedef struct Rig {
    Modes modes;
    Regime free, contact;
    RigSteady steady_free, steady_contact;
    RigChange touch, leave;               /* into the contact, and out of it */
    double omega, period;                 /* rad/s, s, of the drive */
    double force;                         /* N, amplitude of the drive */
    double clearance, stiffness, damping; /* m, N/m, N s/m, of the joint */
    int release;                          /* BeamRelease */
    double cell;                          /* s, both regimes': at most a period / RIG_CELLS */
    double first_free, first_contact; /* s, of a step after a switch: a cell, or less where something decays faster */
    bool shares_cells;                /* the regimes' tables are another rig's */
    double cell_sine, cell_cosine;    /* of omega cell */
} Rig;

/* Cells in a cycle of the drive, at most: seconds. */
#define RIG_CELLS_MOST 1e7

/* Makes the rig of a beam. False: a fault, at the place `place`, and there is nothing to clear. */
bool rig_build(Rig *rig, const Beam *beam, const char *place, Fault *fault);

/* The same of modes that are already there; takes them over. False: LAPACK found no eigenvalues; all is released. */
bool rig_of_modes(Rig *rig, Modes *modes, const Beam *beam);

/* Sets the drive's frequency (Hz) and force (N); modes and regimes stay, and cells, unless the drive is too fast. */
void rig_drive(Rig *rig, double frequency, double force);

/* Steps of a cycle of the drive, at least. */
enum { RIG_CELLS = 16 };

/* Moves sin(omega t) and cos(omega t) on by a time, s, of at most a cell and half a part of it: by Taylor's series,
 * whose next terms would be below 1e-16, so that every machine has the same bits. */
void rig_turn_drive(const Rig *rig, double time, double *sine, double *cosine);

void rig_clear(Rig *rig);

/* changed = C Z. */
void rig_change_blocks(const RigChange *change, const Regime *before, const Regime *after, RegimeVector z,
                       RegimeVector changed);

/* A rig of the same modes and regimes, which stay the first one's and must outlive it, with a drive and a clearance of
 * its own. rig_clear_shared releases it. */
Rig rig_share(const Rig *rig, double frequency, double force, double clearance);
void rig_clear_shared(Rig *rig);

/* m, the steady amplitude of the tip when there is no joint: nothing touches while it is below the clearance. */
double rig_free_amplitude(const Rig *rig);

/* Below this share of the room that the tip has, of the clearance and of how far it would swing without the joint, a
 * motion is at rest: nothing is told by how it differs. */
#define RIG_REST 1e-2

/* m, such a deflection of the tip; and sqrt(J), the least state with it. */
double rig_rest_deflection(const Rig *rig);
double rig_rest_state(const Rig *rig);
