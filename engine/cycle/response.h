/* The response of something that repeats: simulated from rest through the transient, recorded, and told.
 *
 * - Periodic, without contact or with: Newton's iteration certifies a stable orbit near the motion.
 * - Quasi-periodic: the largest exponent is 0 within three standard errors and 1e-3, and the 0-1 test finds order. The
 *   section is a closed curve, or several; the rotation number says how fast one is gone round. A torus that is locked
 *   is an orbit of a long period.
 * - Chaotic: the largest exponent exceeds 0 by three standard errors, and the 0-1 test of every p-th cycle agrees for
 *   some p. Chaos in bands that are visited in turn looks regular to it otherwise.
 * - Transient: was chaotic for RESPONSE_TRANSIENT_LEAST cycles or more and then settled on a stable orbit; or looks
 *   chaotic, but lanes that were started on it settle (survival.h).
 * - Undetermined: none of these can be shown. What was tried is in the response.
 * - Too stiff: a cycle takes so much work (CycleKind's `dear`) that too few could be run for any verdict.
 *
 * A verdict other than periodic is quick until response_confirm has watched whether the motion lasts. */
#pragma once

#include <stdint.h>

#include "base/stop.h"
#include "cycle/chaos.h"
#include "cycle/orbit.h"
#include "cycle/section.h"
#include "cycle/shape.h"
#include "cycle/survival.h"
#include "mechanics/spectrum.h"
#include "mechanics/trace.h"

typedef enum ResponseVerdict {
    RESPONSE_PERIODIC, /* without contact, too */
    RESPONSE_QUASI_PERIODIC,
    RESPONSE_CHAOTIC,
    RESPONSE_TRANSIENT,
    RESPONSE_UNDETERMINED,
    RESPONSE_CHATTERS, /* too many switches in a cycle to follow */
    RESPONSE_DIVERGED, /* a number became infinite, NaN or larger than the equations allow */
    RESPONSE_STIFF,    /* a cycle takes too much work for a verdict in bounded time */
    RESPONSE_INTERRUPTED,
} ResponseVerdict;

/* "periodic", "quasi-periodic", ... */
const char *response_verdict_name(ResponseVerdict verdict);

/* K of the 0-1 test above which a motion is chaotic, and below which it is regular. */
#define RESPONSE_ZERO_ONE_LEAST 0.8
#define RESPONSE_ZERO_ONE_REGULAR 0.5

/* Cycles of chaos before a motion settled that make it a transient. */
enum { RESPONSE_TRANSIENT_LEAST = 100 };

/* Largest exponent per cycle of a motion that may be quasi-periodic. */
#define RESPONSE_NEUTRAL 1e-3

enum { RESPONSE_TRACE_CYCLES = 100 /* of the trace, at most */ };

typedef struct Response {
    ResponseVerdict verdict;
    double *start;     /* (states) at the end of the transient */
    Section section;   /* of the recorded cycles */
    Section wandering; /* of a transient, from the start until it settled; otherwise empty */
    Section analysed;  /* all cycles on which the verdict rests, the recorded ones first */
    SectionPeaks peaks;
    Trace trace;            /* columns of the kind; from the end of the transient */
    Orbit orbit;            /* when periodic, or a transient that has settled; otherwise of period 0 */
    double orbit_peak;      /* N, the largest force on it; 0: without contact, or no orbit */
    OrbitImage image;       /* what its mirror image is */
    ChaosExponent exponent; /* largest exponent per cycle, of the orbit if periodic; NAN: unknown */
    ChaosExponent second;   /* second exponent, of a quasi-periodic motion; otherwise NAN */
    double zero_one;        /* the largest K of those tried; NAN if periodic or unknown */
    size_t zero_one_step;   /* it is of every so many-th cycle */
    ShapeRotation rotation; /* of a quasi-periodic motion, on one of its curves; otherwise NAN */
    size_t bands;           /* of chaos, or closed curves of a torus: 1 or more; otherwise 0 */
    Survival survival;      /* of 0 lanes: not confirmed */
    bool settled;           /* the first recorded cycle was already on the orbit */
    double work;            /* per cycle, of a kind that counts it; otherwise 0 */
    size_t cycles;          /* cycles after the transient on which the verdict rests */
    double contact_share;   /* 1, fraction of the recorded time; NAN, as the next two: no whole cycle was recorded */
    double switches;        /* per recorded cycle */
    double touches;         /* per recorded cycle, of a kind that counts them; otherwise 0 */
    size_t grazes;          /* in the recorded cycles */
    uint64_t digest;        /* of the recorded states */
} Response;

/* Runs the cycle from `start` (a state, or NULL: at rest) through `transient` cycles and records `cycles`, until `stop`
 * is requested (NULL: never). An interrupted response holds the cycles that were recorded until then. response_clear
 * releases the result. */
void response_run(Response *response, Cycle cycle, int transient, int cycles, const double *start, const Stop *stop);

/* Watches whether a motion that is not periodic lasts, and sets the verdict and `survival`; nothing else changes. No
 * effect on other verdicts. An interrupted confirmation leaves the verdict as it was. */
void response_confirm(Response *response, Cycle cycle, const SurvivalTask *task);

/* True if the verdict of a motion that is not periodic has not been confirmed. */
bool response_is_quick(const Response *response);

/* The verdict's name, which is "without contact" for a motion that does not touch the joint. */
const char *response_name(const Response *response);

/* True if the motion is known: neither undetermined nor one that could not be followed or was interrupted. */
bool response_is_told(ResponseVerdict verdict);

/* Returns the spectrum of a column of the trace, of `samples` rows a cycle of `frequency` Hz: over whole periods of the
 * motion, so that its lines are not smeared. spectrum_clear releases it. */
Spectrum response_spectrum(const Response *response, size_t column, size_t samples, double frequency);

void response_clear(Response *response);
