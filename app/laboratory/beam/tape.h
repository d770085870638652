/* The record of a running beam: its motion from rest, cycle by cycle, as far as it has come, through any changes of the
 * beam. The last BEAM_TAPE_CYCLES of them are kept, each as the motion with which it began, so that any time can be
 * shown again with the bits with which it was first seen; older ones are forgotten, so that memory stays as it is.
 *
 *       part: one beam                    another beam
 *     |-----|-----|-----|-----|-----|---------|---------|...........
 *     0   first                                        front            cycles of the drive, counted from the start
 *
 * A change takes place at a phase 0, and what was recorded beyond is forgotten; the motion goes on with what it takes
 * along (beam_carry.h). */
#pragma once

#include "experiment/beam_carry.h"
#include "visual/beam/beam_record.h"

enum {
    BEAM_TAPE_CYCLES = 20000,
    BEAM_TAPE_PARTS = 65, /* at most: with more changes than that, the oldest part is forgotten */
};

/* The range of a quantity. */
typedef struct BeamExtent {
    double reach;     /* m, deflection of any point of the beam */
    double tip_reach; /* m, of the tip */
    double speed;     /* m/s, of the tip */
    double force;     /* N, of the joint */
} BeamExtent;

typedef struct BeamCycle {
    double deflection, velocity; /* m, m/s, of the tip where the cycle begins, at phase 0 */
    double peak[2];              /* N, largest force in it on the upper and the lower side; 0: not touched */
    BeamExtent extent;           /* in it */
    BeamExtent room;             /* what a picture of it should have room for: that changes seldom, and in steps */
    double *saved;               /* as motion_save has it */
    size_t saved_size;
} BeamCycle;

/* From one change to the next. */
typedef struct BeamPart {
    size_t first;    /* cycle */
    double begin;    /* s */
    Beam beam;       /* its texts are those of the first beam */
    Rig rig;         /* shares modes and regimes */
    unsigned serial; /* no other part of the tape has, or had, the same */
    struct BeamModes *modes;
} BeamPart;

/* A motion that follows the tape; zero is one that has not begun. */
typedef struct BeamSight {
    Motion motion;
    unsigned serial;    /* of the part */
    size_t cycle;       /* in which it is */
    BeamImpact last[2]; /* the last impacts that had ended, in this cycle and the one before, on the upper and the lower
                           side; no peak: there was none */
} BeamSight;

typedef struct BeamTape {
    const char *place;                /* what faults begin with */
    BeamPart *parts[BEAM_TAPE_PARTS]; /* (part_count) */
    size_t part_count;
    BeamPart *next;       /* begins at the front, with `carry`; NULL: the last one goes on */
    BeamCycle *cycles;    /* (BEAM_TAPE_CYCLES + 1) a ring; the front's has only its beginning */
    size_t first, front;  /* cycles: those from the first up to before the front are recorded */
    double front_time;    /* s, where the front's begins */
    Motion motion;        /* at the front */
    MotionStatus status;  /* not MOTION_GOOD: the front's cycle could not be followed, and no more come */
    unsigned version;     /* another number: what had been recorded has been forgotten, at the end or altogether */
    unsigned part_serial; /* the last one given */
    BeamCarry carry;
    BeamSight sampler;
} BeamTape;

/* A tape of a beam, whose texts must outlive it, at rest; nothing is recorded yet. `place` begins faults. False: a
 * fault, and there is nothing to close. */
bool beam_tape_open(BeamTape *tape, const Beam *beam, const char *place, Fault *fault);
void beam_tape_close(BeamTape *tape);

/* Goes on with another beam at the end of a cycle, or at rest from the beginning. False: a fault, and all is as it was.
 */
bool beam_tape_change(BeamTape *tape, const Beam *beam, size_t cycle, Fault *fault);
bool beam_tape_restart(BeamTape *tape, const Beam *beam, Fault *fault);

/* Records one more cycle. False: it cannot be followed; tape->status says why. */
bool beam_tape_advance(BeamTape *tape);

/* The part of a cycle, the cycle, its beginning (s; of the front too), and which it is at a time: then the phase, s. */
const BeamPart *beam_tape_part(const BeamTape *tape, size_t cycle);
const BeamCycle *beam_tape_cycle(const BeamTape *tape, size_t cycle);
double beam_tape_begin(const BeamTape *tape, size_t cycle);
size_t beam_tape_cycle_at(const BeamTape *tape, double time, double *phase);

/* Moves a sight to a time that is recorded; the same whatever it saw before. */
void beam_tape_seek(const BeamTape *tape, BeamSight *sight, double time);
void beam_tape_close_sight(BeamSight *sight);

/* The tip at `count` moments of a cycle, equally apart, the first at its beginning: m, m/s, N up. */
typedef struct BeamSamples {
    double *deflection, *velocity, *force; /* (count) or NULL */
    size_t count;
} BeamSamples;
void beam_tape_sample(BeamTape *tape, size_t cycle, const BeamSamples *samples);

/* The tip's velocity at `count` moments from one recorded time to another, m/s. */
void beam_tape_velocities(BeamTape *tape, double from, double to, double *velocity, size_t count);
