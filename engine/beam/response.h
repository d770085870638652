/* What a beam does under its drive: from rest through the transient, recorded, and told periodic or chaotic, or neither
 * where neither can be shown. */
#pragma once

#include <signal.h>
#include <stdint.h>

#include "beam/chaos.h"
#include "beam/orbit.h"
#include "beam/section.h"
#include "mechanics/trace.h"

typedef enum ResponseVerdict {
    RESPONSE_PERIODIC,   /* a stable orbit, certified, and the motion is near it */
    RESPONSE_CHAOTIC,    /* the largest exponent is above 0 by three standard errors, and the 0-1 test says so too */
    RESPONSE_UNRESOLVED, /* neither, within RESPONSE_CYCLES_MOST cycles, or it was stopped */
    RESPONSE_CHATTERS,   /* more switches in a cycle than can be followed */
    RESPONSE_DIVERGED,   /* the numbers were lost */
} ResponseVerdict;

/* "periodic", "chaotic", ... */
const char *response_verdict_name(ResponseVerdict verdict);

/* Cycles after the transient on which a verdict rests: at least, and at most before it is unresolved. */
enum { RESPONSE_CYCLES_LEAST = 2000, RESPONSE_CYCLES_MOST = 16000 };

/* The 0-1 test's K above which a motion is chaotic. */
#define RESPONSE_ZERO_ONE_LEAST 0.8

enum { RESPONSE_TRACE_CYCLES = 100, RESPONSE_SAMPLES = 200 /* rows of the trace: cycles at most, samples a cycle */ };

/* Columns of the trace. */
typedef enum ResponseColumn {
    RESPONSE_TIME,
    RESPONSE_DEFLECTION, /* m, of the tip */
    RESPONSE_VELOCITY,
    RESPONSE_FORCE, /* N, of the joint on the tip */
} ResponseColumn;

typedef struct Response {
    ResponseVerdict verdict;
    double *start;    /* (states) sqrt(J), at the end of the transient */
    Section section;  /* of the recorded cycles */
    Section analysed; /* of all on which the verdict rests, the recorded ones first */
    SectionPeaks peaks;
    Trace trace;            /* time, displacement, velocity, force; from the end of the transient */
    Orbit orbit;            /* when periodic; else of period 0 */
    ChaosExponent exponent; /* largest, per cycle; when periodic, that of the orbit; NAN: not known */
    double zero_one;        /* K; NAN when periodic or not known */
    bool settled;           /* the first recorded cycle was on the orbit already */
    size_t cycles;          /* after the transient, on which the verdict rests */
    double contact_share;   /* 1, of the recorded time */
    double switches;        /* a recorded cycle */
    size_t grazes;          /* in the recorded cycles */
    uint64_t digest;        /* of the recorded states */
} Response;

/* Runs the beam that the rig was made of, from `start` (a state, or NULL: at rest). `stop`, when it becomes other than
 * 0, ends it early; NULL: nothing does. response_clear releases it. */
void response_run(Response *response, const Rig *rig, const Beam *beam, const double *start,
                  const volatile sig_atomic_t *stop);

void response_clear(Response *response);
