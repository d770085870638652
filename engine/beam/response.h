/* The response of a beam to its drive: simulated from rest through the transient, recorded, and classified as
 * periodic or chaotic, or as unresolved where neither can be shown. */
#pragma once

#include <stdint.h>

#include "base/stop.h"
#include "beam/chaos.h"
#include "beam/orbit.h"
#include "beam/section.h"
#include "mechanics/trace.h"

typedef enum ResponseVerdict {
    RESPONSE_PERIODIC,   /* near a stable, certified orbit */
    RESPONSE_CHAOTIC,    /* the largest exponent exceeds 0 by three standard errors, and the 0-1 test agrees */
    RESPONSE_UNRESOLVED, /* neither within RESPONSE_CYCLES_MOST cycles */
    RESPONSE_CHATTERS,   /* too many switches in a cycle to follow */
    RESPONSE_DIVERGED,   /* a number became infinite or NaN */
    RESPONSE_INTERRUPTED,
} ResponseVerdict;

/* "periodic", "chaotic", ... */
const char *response_verdict_name(ResponseVerdict verdict);

/* Cycles after the transient on which a verdict rests: the least, and the most before it is unresolved. */
enum { RESPONSE_CYCLES_LEAST = 2000, RESPONSE_CYCLES_MOST = 16000 };

/* K of the 0-1 test above which a motion is chaotic. */
#define RESPONSE_ZERO_ONE_LEAST 0.8

enum {
    RESPONSE_TRACE_CYCLES = 100,
    RESPONSE_SAMPLES = 200 /* rows of the trace: at most this many cycles, samples per cycle */
};

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
    Section analysed; /* all cycles on which the verdict rests, the recorded ones first */
    SectionPeaks peaks;
    Trace trace;            /* time, displacement, velocity, force; from the end of the transient */
    Orbit orbit;            /* when periodic; otherwise of period 0 */
    ChaosExponent exponent; /* largest exponent per cycle, of the orbit if periodic; NAN: unknown */
    double zero_one;        /* K; NAN if periodic or unknown */
    bool settled;           /* the first recorded cycle was already on the orbit */
    size_t cycles;          /* cycles after the transient on which the verdict rests */
    double contact_share;   /* 1, fraction of the recorded time */
    double switches;        /* per recorded cycle */
    size_t grazes;          /* in the recorded cycles */
    uint64_t digest;        /* of the recorded states */
} Response;

/* Runs the beam of the rig from `start` (a state, or NULL: at rest), until `stop` is requested (NULL: never). An
 * interrupted response holds the cycles that were recorded until then. response_clear releases the result. */
void response_run(Response *response, const Rig *rig, const Beam *beam, const double *start, const Stop *stop);

void response_clear(Response *response);
