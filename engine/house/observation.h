/* The results of a run: for each person whether, when and how the person left, and for the house where the dangerous
 * places are. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "house/hazard.h"
#include "house/house.h"
#include "route/route.h"
#include "mechanics/trace.h"

typedef enum Reason {
    REASON_NONE, /* out, or still moving */
    REASON_CANNOT_PASS,
    REASON_NO_EXIT,
    REASON_TOO_WEAK,
    REASON_BLOCKED,
    REASON_TIME_LIMIT,
    REASON_DIVERGED,
    REASON_INTERRUPTED,
    REASON_OTHER_DIVERGED, /* the run ended because another person diverged */
} Reason;

/* Returns "cannot pass", "no exit", "too weak", "blocked", "time limit", "diverged", "interrupted", "another person
 * diverged"; "" for none. */
const char *observation_reason(Reason reason);

/* Returns the reason of a person with this answer: none with a path. */
Reason observation_reason_of(RouteAnswer answer);

/* True if the reason has a place, which is the blockage: "cannot pass", "too weak" and "blocked". */
bool observation_reason_has_place(Reason reason);

/* True if it follows from the plan, before anything moves, and has a place: "cannot pass" and "too weak". */
bool observation_reason_is_planned(Reason reason);

#define OBSERVATION_SQUEEZE 0.5 /* s */

/* A touch of a chair: what begins within 0.1 s is one. A hand that meets something is a touch of its own kind: an
 * obstacle comes into the space beside a rim (body.hands) within OBSERVATION_RIMS of the axle, whether or not the arms
 * are tucked in there; it is in no sum of the body's touches. */
typedef struct Touch {
    size_t person;
    Vec2 at;        /* m, of its fastest impact */
    int part;       /* BodyPart, of that impact */
    int other;      /* the person it touches, or -1: an obstacle */
    double time;    /* s, when it begins */
    double speed;   /* m/s, along the normal, of the fastest impact; of a hand, the chair's own */
    double mass;    /* kg, the effective mass of that impact (touch.h); of a hand, the chair's own */
    double energy;  /* J, of all its impacts */
    double impulse; /* N s, up to the next touch */
    double squeeze; /* N, greatest mean of the contact force over OBSERVATION_SQUEEZE, up to the next touch */
} Touch;

#define OBSERVATION_RIMS 0.30 /* m, assumed: hands are at the rims so far before and behind the axle */

typedef struct PersonObservation {
    bool took_part;     /* True if the person is in this run: a run of one route excludes the others */
    bool completed;     /* True if the person has crossed an exit */
    double time;        /* s, when the person left; otherwise when the run ended for this person */
    Reason reason;      /* why the person did not leave */
    Blockage blockage;  /* place, when the reason has one */
    size_t exit;        /* exit crossed, or aimed at; SIZE_MAX: none */
    int reversals;      /* planned reversals */
    double path_length; /* m, of the reference point */
    double narrowest;   /* m, least clearance of the body, at most the personal space's reach; negative: contact */
    Vec2 narrowest_at;  /* m, the reference point at that time */
    double narrowest_heading; /* rad */
    Vec2 narrowest_to;        /* m, the nearest point at that time */
    int narrowest_other;      /* the nearest person at that time, or -1: an obstacle */
    int contacts;             /* number of contacts begun */
    double peak_force;        /* N, largest contact force on the body */
    Vec2 peak_at;             /* m */
    double impulse;           /* N s, of body contacts */
    double impact;            /* m/s, greatest speed along the normal with which a contact of a chair began */
    double impact_energy;     /* J, of that contact */
    int impact_part;          /* BodyPart, of that contact */
    Vec2 impact_at;           /* m, the contact point */
    double energy;            /* J, of all contacts that a chair began */
    double squeeze;           /* N, greatest mean of the contact force over OBSERVATION_SQUEEZE, of a chair */
    double back_length;       /* m, driven backwards */
    double back_time;         /* s, driving backwards */
    int back_times;           /* number of times that the chair began to drive backwards */
    bool back_out;            /* True if the chair crossed the exit backwards */
    double ring_time;         /* s, with the personal space compressed */
    double ring_peak;         /* m, its greatest compression */
    double lost_time;         /* s, relative to the free speed */
} PersonObservation;

/* The columns of the trace: one row per person and sample. Extremes between two rows are preserved: clearance is the
 * least since the row before, ring and forces are the greatest, the contact is the hardest. */
enum {
    TRACE_TIME,
    TRACE_PERSON,      /* index into House.people */
    TRACE_X,           /* m, reference point */
    TRACE_Y,           /* m */
    TRACE_HEADING,     /* rad */
    TRACE_SPEED,       /* m/s, along the heading (driver) or the path (miura) */
    TRACE_CLEARANCE,   /* m, of the body from walls, furniture and people; up to the personal space's reach */
    TRACE_RING,        /* m, greatest compression of the personal space */
    TRACE_BODY_FORCE,  /* N, sum of the body's contact forces */
    TRACE_RING_FORCE,  /* N, sum of the personal space's forces */
    TRACE_OFFSET,      /* m, to the left of the planned path */
    TRACE_OFFSET_RATE, /* m/s; NAN when the offset belongs to another part of the path than in the row before */
    TRACE_CONTACT_X,   /* m, contact point on the body; NAN: none */
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
    Touch *touches; /* (touch_count) of chairs: group by group as they begin */
    size_t touch_count;
    double *door_opened; /* (doors of the plan) s, when each door was first opened; infinite: never */
    bool completed;      /* True if every person who took part is out */
    bool interrupted;    /* True if the run was interrupted: for a person who is still inside the answer is neither a
                            yes nor a no */
    double time;         /* s, when the last person left, or the run ended */
    uint64_t steps;
    int wall_crossings; /* number of times that a body's middle entered a wall, at any step: more than 0 is an error of
                           the program */
    double dt;          /* s */
    double sample;      /* s, between two rows of the trace: observer_sample_steps */
    uint64_t digest;    /* of all states at all steps */
    double *mixed;      /* (mixed_count) s, when the plan changed during the run */
    size_t mixed_count;
} Observation;

void observation_free(Observation *observation);

/* Returns the observation of the person with this id, or NULL. */
const PersonObservation *observation_of_person(const House *house, const Observation *observation, const char *id);

/* Returns the index of an exit that lies on a solid wall, which is all that keeps the first person inside who cannot
 * pass; SIZE_MAX: there is none. */
size_t observation_walled_exit(const House *house, const Observation *observation);
