/* The recorded cycles of a beam, followed once more: its state at any time of them, its impacts, how far it bends, and
 * the tip's way sample by sample. Each cycle is followed from the state with which the response began it, so that this
 * is the motion that the answer rests on, also where it is chaotic: what rounding makes of a cycle is 1e-12 of it. */
#pragma once

#include "beam/response.h"
#include "visual/beam/beam_shape.h"

/* From touching a stop until it is left. */
typedef struct BeamImpact {
    double begin, end; /* s */
    double peak;       /* N */
    int side;          /* 1 upper, -1 lower */
} BeamImpact;

/* What of the record is sampled: every 1 / rate s from the first time on, or more closely, and the last time. */
typedef struct BeamSpan {
    double first, last; /* s, within the record */
    double rate;        /* 1/s; each of its times is sampled exactly */
} BeamSpan;

typedef struct BeamRecord {
    const Response *response;
    Motion motion;       /* at the time that was sought last */
    size_t cycles;       /* whole ones, from the end of the transient on; 0: there is nothing to show */
    double time;         /* s, that they take */
    double reach;        /* m, the largest deflection of any point of the beam */
    double tip_reach;    /* m, and of the tip */
    double largest;      /* N, the largest force of the joint */
    double hardest;      /* s, when, to a sample of the trace; where nothing is touched, of the largest deflection */
    BeamImpact *impacts; /* (impact_count) in their order */
    size_t impact_count, impact_capacity;

    /* The tip in the span, and at the ends of the cycles in it. */
    double *times, *displacement, *velocity, *force;                 /* (sample_count) ms, mm, m/s, N on the tip, up */
    double *section_times, *section_displacement, *section_velocity; /* (section_count) ms, mm, m/s */
    size_t sample_count, section_count;
} BeamRecord;

/* The cycles of a response that its trace has too; rig and response must outlive it. beam_record_clear releases it. */
void beam_record_make(BeamRecord *record, const Rig *rig, const Response *response);
void beam_record_clear(BeamRecord *record);

/* Fills the samples. */
void beam_record_sample(BeamRecord *record, BeamSpan span);

/* Moves `record->motion` to a time, s, within the record; the same whatever was sought before. */
void beam_record_seek(BeamRecord *record, double time);

/* The last impact that had ended by a time on a side, or NULL. */
const BeamImpact *beam_record_last_impact(const BeamRecord *record, double time, int side);
