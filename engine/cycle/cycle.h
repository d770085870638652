/* Anything that repeats: a motion whose state is looked at once per cycle (of a drive, of a shaft). What is said of
 * such motions, their orbits, their exponents, their verdict, needs of them only the functions of a CycleKind, as
 * houses and beams are studied through an Experiment.
 *
 *     state x --- one cycle ---> P(x) --- one cycle ---> P(P(x))        with tangents: dP along them */
#pragma once

#include <stddef.h>

#include "base/stop.h"
#include "mechanics/trace.h"

typedef enum CycleStatus {
    CYCLE_GOOD,
    CYCLE_CHATTERS,    /* too many switches in one cycle to follow: the motion stops there */
    CYCLE_DIVERGED,    /* a number became infinite, NaN or larger than the equations allow */
    CYCLE_STIFF,       /* one cycle needs more steps than are taken: the motion stops there */
    CYCLE_INTERRUPTED, /* the end was requested within a cycle: the motion stops there */
} CycleStatus;

enum { CYCLE_SIDES = 2 /* of a joint: upper and lower, or outer and inner */ };

/* What a motion has done since its start. */
typedef struct CycleTally {
    size_t switches, grazes;
    double contact_time; /* s */
    size_t touches;      /* contacts that began; 0 for a kind that does not count them */
    size_t work;         /* evaluations of the equations; 0 for a kind that does not count them */
    double time;         /* s, since the start; 0 where each cycle is as long as `period` */
} CycleTally;

/* A motion among many, and what is recorded of it. */
typedef struct CycleRun {
    const double *start; /* (states) */
    size_t cycles;

    CycleStatus status;
    size_t recorded;               /* cycles; fewer after chatter, divergence or interruption */
    double *peak;                  /* (cycles x CYCLE_SIDES) N */
    double *deflection, *velocity; /* (cycles) of the tip at the end of each cycle, m and m/s */
    double *end;                   /* (states) the last state */
} CycleRun;

/* `given` is the fixed part (of a beam, its rig), which several motions may share; `motion` is what `create` returned.
 * A state has `states` numbers of one unit, in which lengths of states have a meaning. */
typedef struct CycleKind {
    const TraceColumn *columns; /* (column_count) of a recording; the first one is the time, s */
    size_t column_count;
    int samples;    /* rows of a recording per cycle */
    double closing; /* fraction of a state's length within which an orbit closes: what rounding leaves, with room */
    size_t cycles_least, cycles_most; /* after the transient, on which a verdict rests; the most until it is given up */

    /* Work of a cycle above which it is dear: of dear cycles fewer are run, so that an answer comes in bounded time.
     * 0: no cycle is dear. */
    size_t dear;

    /* How a motion that is not periodic is watched (survival.h), by what a cycle costs: by default `lanes` motions for
     * `lane_cycles` cycles each, which forget within `lane_apart` cycles the motion that they were started on; one
     * thread runs `together` of them at a time. */
    size_t lanes, lane_cycles, lane_apart, together;

    size_t (*states)(const void *given);
    double (*period)(const void *given);     /* s, of one cycle */
    double (*rest_tip)(const void *given);   /* deflection of the tip, m, below which it counts as rest */
    double (*rest_state)(const void *given); /* length of a state below which a motion counts as rest */

    /* Creates a motion at rest with `tangents` tangent vectors: deviations of the state to first order, exact or by
     * neighbours. A kind whose cycles may take long polls `stop` within them. */
    void *(*create)(const void *given, size_t tangents, const Stop *stop);
    void (*destroy)(void *motion);
    void (*copy)(void *to, const void *from); /* of the same `given` and number of tangents */

    void (*state)(const void *motion, double *state);
    void (*set_state)(void *motion, const double *state); /* a cycle begins */
    void (*tangent)(const void *motion, size_t index, double *tangent);
    void (*set_tangent)(void *motion, size_t index, const double *tangent);
    void (*unit_tangents)(void *motion); /* sets tangent i to the i-th unit vector */

    /* Turns a motion that begins a cycle into its own mirror image of half a cycle later, which begins one, too: a
     * motion as possible as itself. NULL: the cycle has no such symmetry. */
    void (*mirror)(void *motion);

    CycleStatus (*run)(void *motion); /* to the end of the cycle */
    CycleStatus (*status)(const void *motion);
    CycleTally (*tally)(const void *motion);
    double *(*peaks)(void *motion); /* (CYCLE_SIDES) N, largest forces since they were last reset, which the caller may
                                       do; 0: no contact */
    void (*tip)(const void *motion, double *tip); /* (2) what a section shows: deflection, m, and velocity, m/s */

    /* Computes the row (column_count) at the beginning of part `part` (0 to samples - 1) of the cycle, except the time,
     * and goes on to the end of the part. */
    void (*sample)(void *motion, int part, double *row);

    /* The motion at the beginning of a cycle, without tangents and tally, as saved_size numbers; restored it continues
     * with the same bits. */
    size_t (*saved_size)(const void *given);
    void (*save)(const void *motion, double *saved);
    void (*restore)(void *motion, const double *saved);

    /* Runs many motions faster than one after another, with results that do not depend on the others. NULL: there is
     * no faster way. */
    void (*many)(const void *given, CycleRun *runs, size_t count, const Stop *stop);
} CycleKind;

typedef struct Cycle {
    const CycleKind *kind;
    const void *given;
} Cycle;

/* A motion of a cycle. */
typedef struct CycleMotion {
    Cycle cycle;
    void *own;
    size_t states, tangents;
} CycleMotion;

/* Creates a motion at rest with unit tangents. A request of `stop`, which must outlive it, may end one of its cycles
 * early; NULL: never. */
CycleMotion cycle_create(Cycle cycle, size_t tangents, const Stop *stop);
void cycle_destroy(CycleMotion *motion);

/* Runs many motions; a request of `stop` ends them early. */
void cycle_many(Cycle cycle, CycleRun *runs, size_t count, const Stop *stop);

/* Advances to the end of the cycle. */
static inline CycleStatus cycle_run(CycleMotion *motion) {
    return motion->cycle.kind->run(motion->own);
}

static inline CycleStatus cycle_status(const CycleMotion *motion) {
    return motion->cycle.kind->status(motion->own);
}

static inline size_t cycle_states(Cycle cycle) {
    return cycle.kind->states(cycle.given);
}

static inline double cycle_period(Cycle cycle) {
    return cycle.kind->period(cycle.given);
}

/* Returns the length of a state below which a motion counts as rest. */
static inline double cycle_rest_state(Cycle cycle) {
    return cycle.kind->rest_state(cycle.given);
}
