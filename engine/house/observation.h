/* What a run shows: for each person whether, when and how they got out, and for the house where the danger is. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "house/hazard.h"
#include "house/house.h"
#include "route/route.h"
#include "mechanics/trace.h"

typedef enum Reason {
    REASON_NONE, /* out, or still on the way */
    REASON_CANNOT_PASS,
    REASON_NO_EXIT,
    REASON_BLOCKED,
    REASON_TIME_LIMIT,
    REASON_DIVERGED,
    REASON_INTERRUPTED,
} Reason;

/* "cannot pass", "no exit", "blocked", "time limit", "diverged", "interrupted"; "" for none. */
const char *observation_reason(Reason reason);

typedef struct PersonObservation {
    bool took_part;     /* in this run: a run of one route leaves the others out */
    bool completed;     /* has crossed an exit */
    double time;        /* s, when; otherwise when the run ended for this person */
    Reason reason;      /* why not */
    Blockage blockage;  /* where, when the reason is "cannot pass" or "blocked" */
    size_t exit;        /* crossed, or aimed at; SIZE_MAX: none */
    int reversals;      /* planned */
    double path_length; /* m, of the reference point */
    double narrowest;   /* m, least clearance of the body, at most the personal space's reach; negative: contact */
    Vec2 narrowest_at;  /* m, the reference point then */
    double narrowest_heading; /* rad */
    Vec2 narrowest_to;        /* m, what it was near to */
    int narrowest_other;      /* the person it was near to, or -1: an obstacle */
    int contacts;             /* times that the body began to touch something */
    double peak_force;        /* N, of a body contact */
    Vec2 peak_at;             /* m */
    double impulse;           /* N s, of body contacts */
    double ring_time;         /* s, with the personal space compressed */
    double ring_peak;         /* m, its greatest compression */
    double lost_time;         /* s, against the free speed */
} PersonObservation;

/* The columns of the trace: one row a person and sample. What comes and goes between two rows is not lost: clearance is
 * the least since the row before, ring and forces are the greatest, the contact is the hardest. */
enum {
    TRACE_TIME,
    TRACE_PERSON,      /* index into House.people */
    TRACE_X,           /* m, reference point */
    TRACE_Y,           /* m */
    TRACE_HEADING,     /* rad */
    TRACE_SPEED,       /* m/s, along the heading (driver) or the way (miura) */
    TRACE_CLEARANCE,   /* m, of the body from walls, furniture and others; up to the personal space's reach */
    TRACE_RING,        /* m, greatest compression of the personal space */
    TRACE_BODY_FORCE,  /* N, sum of the body's contact forces */
    TRACE_RING_FORCE,  /* N, sum of the personal space's */
    TRACE_OFFSET,      /* m, to the left of the planned path */
    TRACE_OFFSET_RATE, /* m/s; NAN when the offset is from another part of the way than in the row before */
    TRACE_CONTACT_X,   /* m, where the body was touched; NAN: nowhere */
    TRACE_CONTACT_Y,   /* m */
    TRACE_COLUMNS,
};

extern const TraceColumn observation_columns[TRACE_COLUMNS];

typedef struct Observation {
    PersonObservation *people; /* (person_count), as in House.people */
    size_t person_count;
    Trace trace;
    Hazard *hazards; /* (hazard_count), worst first */
    size_t hazard_count;
    double *door_opened; /* (doors of the plan) s, when each was first opened; infinite: it was not */
    bool completed;      /* everybody who took part is out */
    double time;         /* s, when the last one got out, or the run ended */
    uint64_t steps;
    int wall_crossings; /* at any step, of a body's middle into a wall: more than none is a fault of the program */
    double dt;          /* s */
    double sample;      /* s, between two rows of the trace: observer_sample_steps */
    uint64_t digest;    /* of all states at all steps */
    double *mixed;      /* (mixed_count) s, when the plan changed while the run went on */
    size_t mixed_count;
} Observation;

void observation_free(Observation *observation);

/* Of the person with this id, or NULL. */
const PersonObservation *observation_of_person(const House *house, const Observation *observation, const char *id);
