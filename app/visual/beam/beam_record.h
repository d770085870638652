/* The recorded cycles of a beam, simulated a second time: its state at any time of them, its impacts, its bending, and
 * the tip's path sample by sample. Each cycle starts from the state in which the response started it, so that this is
 * the motion behind the answer, also where it is chaotic: rounding changes a cycle by 1e-12. */
#pragma once

#include "beam/beam_cycle.h"
#include "visual/beam/beam_shape.h"

/* The contact with a stop from touch to release. */
typedef struct BeamImpact {
    double begin, end; /* s */
    double peak;       /* N */
    int side;          /* 1 upper, -1 lower */
} BeamImpact;

/* The sampled part of the record: every 1 / rate s from the first time on, or more densely, and the last time. */
typedef struct BeamSpan {
    double first, last; /* s, within the record */
    double rate;        /* 1/s; each of its times is sampled exactly */
} BeamSpan;

typedef struct BeamRecord {
    const Response *response;
    Motion motion;       /* at the last time that was sought */
    size_t cycles;       /* whole ones, from the end of the transient on; 0: nothing to show */
    double time;         /* s, their duration */
    double reach;        /* m, the largest deflection of any point of the beam */
    double tip_reach;    /* m, the largest deflection of the tip */
    double largest;      /* N, the largest contact force */
    double hardest;      /* s, its time, to a sample of the trace; without contact that of the largest deflection */
    BeamImpact *impacts; /* (impact_count) in order of time */
    size_t impact_count, impact_capacity;

    /* The tip within the span, and at the ends of the cycles in it. */
    double *times, *displacement, *velocity, *force;                 /* (sample_count) ms, mm, m/s, N on the tip, up */
    double *section_times, *section_displacement, *section_velocity; /* (section_count) ms, mm, m/s */
    size_t sample_count, section_count;
} BeamRecord;

/* Simulates the cycles of a response that its trace has too; rig and response must outlive the record.
 * beam_record_clear releases it. */
void beam_record_make(BeamRecord *record, const Rig *rig, const Response *response);
void beam_record_clear(BeamRecord *record);

/* Fills the samples. */
void beam_record_sample(BeamRecord *record, BeamSpan span);

/* Moves `record->motion` to a time, s, within the record; the result does not depend on earlier calls. */
void beam_record_seek(BeamRecord *record, double time);

/* Returns the last impact on a side that ended by a time, or NULL. */
const BeamImpact *beam_record_last_impact(const BeamRecord *record, double time, int side);
