/* The response of something that repeats: simulated from rest through the transient, recorded, and classified as
 * periodic or chaotic, or as unresolved where neither can be shown. */
#pragma once

#include <stdint.h>

#include "base/stop.h"
#include "cycle/chaos.h"
#include "cycle/orbit.h"
#include "cycle/section.h"
#include "mechanics/trace.h"

typedef enum ResponseVerdict {
    RESPONSE_PERIODIC,   /* near a stable, certified orbit */
    RESPONSE_CHAOTIC,    /* the largest exponent exceeds 0 by three standard errors, and the 0-1 test agrees */
    RESPONSE_UNRESOLVED, /* neither within the kind's most cycles */
    RESPONSE_CHATTERS,   /* too many switches in a cycle to follow */
    RESPONSE_DIVERGED,   /* a number became infinite or NaN */
    RESPONSE_INTERRUPTED,
} ResponseVerdict;

/* "periodic", "chaotic", ... */
const char *response_verdict_name(ResponseVerdict verdict);

/* K of the 0-1 test above which a motion is chaotic. */
#define RESPONSE_ZERO_ONE_LEAST 0.8

enum { RESPONSE_TRACE_CYCLES = 100 /* of the trace, at most */ };

typedef struct Response {
    ResponseVerdict verdict;
    double *start;    /* (states) at the end of the transient */
    Section section;  /* of the recorded cycles */
    Section analysed; /* all cycles on which the verdict rests, the recorded ones first */
    SectionPeaks peaks;
    Trace trace;            /* columns of the kind; from the end of the transient */
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

/* Runs the cycle from `start` (a state, or NULL: at rest) through `transient` cycles and records `cycles`, until `stop`
 * is requested (NULL: never). An interrupted response holds the cycles that were recorded until then. response_clear
 * releases the result. */
void response_run(Response *response, Cycle cycle, int transient, int cycles, const double *start, const Stop *stop);

void response_clear(Response *response);
