/* The record of a running beam: its motion from rest, cycle by cycle, through all changes of the beam. The last
 * BEAM_TAPE_CYCLES cycles are stored, each as the motion at its beginning, so that any time can be displayed again with
 * the same bits; older cycles are discarded, so memory is bounded.
 *
 *       part: one beam                    another beam
 *     |-----|-----|-----|-----|-----|---------|---------|...........
 *     0   first                                        front            cycles of the drive, counted from the start
 *
 * A change takes place at phase 0, and the later record is discarded; the motion continues with its carried state
 * (beam_carry.h). */
#pragma once

#include "experiment/beam_carry.h"
#include "visual/beam/beam_record.h"

enum {
    BEAM_TAPE_CYCLES = 20000,
    BEAM_TAPE_PARTS = 65, /* at most: the oldest part is forgotten when there are more changes */
};

/* The range of a quantity. */
typedef struct BeamExtent {
    double reach;     /* m, deflection of any point of the beam */
    double tip_reach; /* m, of the tip */
    double speed;     /* m/s, of the tip */
    double force;     /* N, of the joint */
} BeamExtent;

typedef struct BeamCycle {
    double deflection, velocity; /* m, m/s, at the tip at the beginning of the cycle, phase 0 */
    double peak[2];              /* N, largest force in the cycle on the upper and the lower side; 0: no contact */
    BeamExtent extent;           /* extent of the motion in the cycle */
    BeamExtent room; /* extent that a picture of the cycle should have room for: it changes seldom, and in steps */
    double *saved;   /* the state, from motion_save */
    size_t saved_size;
} BeamCycle;

/* The stretch from one change of the beam to the next. */
typedef struct BeamPart {
    size_t first;    /* first cycle of the part */
    double begin;    /* s */
    Beam beam;       /* the texts belong to the first beam */
    Rig rig;         /* shares modes and regimes */
    unsigned serial; /* unique among all parts that the tape has or had */
    struct BeamModes *modes;
} BeamPart;

/* A motion that follows the tape; a zeroed sight has not begun. */
typedef struct BeamSight {
    Motion motion;
    unsigned serial;    /* serial of the sight's part */
    size_t cycle;       /* the sight's cycle */
    BeamImpact last[2]; /* the last completed impacts in this cycle and the one before, on the upper and the lower side;
                           no peak: no impact */
} BeamSight;

typedef struct BeamTape {
    const char *place;                /* beginning of the texts of faults */
    BeamPart *parts[BEAM_TAPE_PARTS]; /* (part_count) */
    size_t part_count;
    BeamPart *next;       /* the part that begins at the front, with `carry`; NULL: the last part continues */
    BeamCycle *cycles;    /* (BEAM_TAPE_CYCLES + 1) a ring; the front's cycle has only its beginning */
    size_t first, front;  /* cycles: `first` up to but excluding `front` are recorded */
    double front_time;    /* s, beginning of the front's cycle */
    Motion motion;        /* the motion at the front */
    CycleStatus status;   /* not CYCLE_GOOD: the front's cycle could not be followed, and the record has ended */
    unsigned version;     /* changes when recorded cycles are discarded from the end, or all of them */
    unsigned part_serial; /* the serial that was assigned last */
    BeamCarry carry;
    BeamSight sampler;
} BeamTape;

/* Opens a tape of a beam at rest, with an empty record; the beam's texts must outlive the tape. `place` begins the
 * texts of faults. False: a fault, and there is nothing to close. */
bool beam_tape_open(BeamTape *tape, const Beam *beam, const char *place, Fault *fault);
void beam_tape_close(BeamTape *tape);

/* Continues with another beam at the end of a cycle, or from rest at the beginning. False: a fault, and nothing has
 * changed. */
bool beam_tape_change(BeamTape *tape, const Beam *beam, size_t cycle, Fault *fault);
bool beam_tape_restart(BeamTape *tape, const Beam *beam, Fault *fault);

/* Records one more cycle. False: the cycle cannot be followed; tape->status gives the reason. */
bool beam_tape_advance(BeamTape *tape);

/* Return the part of a cycle, the cycle, its beginning (s; also for the front), and the index of the cycle at a time
 * with the phase, s. */
const BeamPart *beam_tape_part(const BeamTape *tape, size_t cycle);
const BeamCycle *beam_tape_cycle(const BeamTape *tape, size_t cycle);
double beam_tape_begin(const BeamTape *tape, size_t cycle);
size_t beam_tape_cycle_at(const BeamTape *tape, double time, double *phase);

/* Moves a sight to a recorded time; the result does not depend on the sight's previous time. */
void beam_tape_seek(const BeamTape *tape, BeamSight *sight, double time);
void beam_tape_close_sight(BeamSight *sight);

/* The tip at `count` equally spaced moments of a cycle, the first at its beginning: m, m/s, N upwards. */
typedef struct BeamSamples {
    double *deflection, *velocity, *force; /* (count) or NULL */
    size_t count;
} BeamSamples;
void beam_tape_sample(BeamTape *tape, size_t cycle, const BeamSamples *samples);

/* Samples the tip's velocity at `count` moments between two recorded times, m/s. */
void beam_tape_velocities(BeamTape *tape, double from, double to, double *velocity, size_t count);
