/* Types I, II and III: may a machine be run here, or a house be left so? One definition for everything that can be run.
 *
 * Source: Gu and Dubowsky, "Chaotic Vibration and Design Criteria for Machine Systems with Clearance Connections",
 * 1995, who tell three types apart by how the response changes with the design. Made exact here: over a window of +-1 %
 * in each of some parameters (its centre, and both ends of each), from 16 starts at each point,
 *
 *     I           one answer, regular throughout, and no |d ln P / d ln p| of 5 or more: run it
 *     II          regular throughout, but a sensitivity of 5 or more, several answers, or a period that doubles inside
 *                 the window: by tolerances and starts
 *     III         somewhere in the window not regular: do not run it
 *     unresolved  something could not be told, and nothing of what was told makes it III
 *     interrupted the search was stopped before the window was complete
 *
 * Where runs can be carried on, the ends of the window are starts of the centre, too, and the centre of either end:
 * along each parameter a motion is carried upwards and another one downwards. Such a start may reach an answer that the
 * 16 miss.
 *
 * P is what the experiment measures (a beam: the largest peak force; a house: the time to complete). Answers are one
 * when their outcomes are and their measures agree; a motion and its mirror image are one, for theirs do. The mirror
 * image of a start leads to the mirror image of its answer, so that no start needs to be tried with its own. Beyond the
 * window, each parameter is followed outwards alone to where things change: neighbours.h. */
#pragma once

#include "base/fault.h"
#include "base/stop.h"
#include "study/neighbours.h"

#define TYPES_WINDOW 0.01 /* 1, half-width of the window in each parameter */
#define TYPES_STEEP 5.0   /* 1, least |d ln P / d ln p| of a steep response */
#define TYPES_SAME 0.01   /* 1, measures with a smaller relative difference belong to one response */

enum {
    TYPES_STARTS = 16,          /* seeds 0 to 15 at each point */
    TYPES_PARAMETERS_MOST = 8,  /* of a window */
    TYPES_ANSWERS_MOST = 16,    /* responses at a point, at most one per initial state */
    TYPES_THOROUGH_MOST = 256,  /* largest number of thorough repetitions, about the size of a window */
    TYPES_UNDECIDED_MOST = 4,   /* undetermined repetitions after which the others are skipped */
    TYPES_THOROUGH_AT_ONCE = 2, /* repetitions at a time */
};

typedef enum TypesKind { TYPES_UNRESOLVED, TYPES_I, TYPES_II, TYPES_III, TYPES_KIND_INTERRUPTED } TypesKind;

/* The part of the definition that decided. */
typedef enum TypesReason {
    TYPES_ALL_WELL,     /* I */
    TYPES_STEEP_ANSWER, /* II: high sensitivity */
    TYPES_SEVERAL,      /* II: several responses, at one point or between points */
    TYPES_NOT_REGULAR,  /* III */
    TYPES_FLIPS,        /* II: period doubling */
    TYPES_UNDECIDED,    /* unresolved */
    TYPES_INTERRUPTED,  /* interrupted: the window is not complete, and has no points */
} TypesReason;

/* A response at a point. */
typedef struct TypesAnswer {
    double outcome, measure;
    size_t starts;  /* initial states that lead to it */
    size_t carried; /* motions carried on from a neighbouring point that lead to it */
} TypesAnswer;

/* A point of the window. */
typedef struct TypesPoint {
    size_t parameter; /* index into Types.parameters; at the centre, their count */
    double value;     /* value of that parameter; NAN at the centre */
    bool possible;    /* false: the value is out of range and is ignored */
    TypesAnswer answers[TYPES_ANSWERS_MOST];
    size_t answer_count;
    size_t irregular, undecided;                 /* starts */
    size_t carried_irregular, carried_undecided; /* motions carried on from a neighbouring point */
    const char *verdict; /* of an irregular start, as the full analysis told it; NULL: it was not made */
} TypesPoint;

typedef struct TypesParameter {
    const char *name;
    double nominal;
    double sensitivity; /* d ln P / d ln p, the largest over both sides and all responses; HUGE_VAL: P is 0 on one side;
                           NAN: undetermined, or the parameter is 0 and has no window */
    Neighbour below, above;
} TypesParameter;

enum { TYPES_POINTS_MOST = 1 + 2 * TYPES_PARAMETERS_MOST };

typedef struct Types {
    TypesKind kind;
    TypesReason reason;
    TypesParameter parameters[TYPES_PARAMETERS_MOST];
    size_t parameter_count;
    TypesPoint points[TYPES_POINTS_MOST]; /* the centre, then the lower and upper end for each parameter */
    size_t point_count;
    size_t answers;          /* largest number at a point */
    size_t worst;            /* index into points of the deciding point, where that is not the centre */
    size_t runs, thorough;   /* trials of the window, and thorough repetitions among them */
    size_t carried_runs;     /* trials carried on from another point of the window */
    size_t neighbour_runs;   /* trials outside the window */
    NeighboursSought sought; /* the change that the neighbours were searched for */
    bool stopped;            /* interrupted, in the window or beyond it */
} Types;

/* Input of a classification. */
typedef struct TypesTask {
    const Experiment *experiment;
    const Experiment *thorough; /* the same experiment with full analysis, used where the first does not find "regular";
                                   NULL: the first is final */
    const char *const *names;   /* (name_count) parameters of the window */
    size_t name_count;
    size_t starts;    /* at each point, at most TYPES_STARTS; 0: as many as the definition has, and carried motions */
    bool window_only; /* skips the search for neighbours */
    int jobs;
    const Stop *stop;
    void (*progress)(void *context, size_t done,
                     size_t all); /* counts of trials; called by one thread at a time; NULL: none */
    void *context;
} TypesTask;

/* Returns "I", "II", "III", "unresolved" or "interrupted". */
const char *types_kind_name(TypesKind kind);

/* True if a type is defined in a window of these names (name_count); otherwise adds an error. */
bool types_check(const Experiment *experiment, const char *const *names, size_t name_count, Fault *fault);

/* Classifies. Returns false after an error: an unknown parameter, or too many. */
bool types_classify(Types *types, const TypesTask *task, Fault *fault);
