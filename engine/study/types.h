/* Types I, II and III: may a machine be run here, or a house be left so? One definition for everything that can be run.
 *
 * Source: Gu and Dubowsky, "Chaotic Vibration and Design Criteria for Machine Systems with Clearance Connections",
 * 1995, who tell three types apart by how the response changes with the design. Made exact here: over a window of +-1 %
 * in each of some parameters (its centre, and both ends of each), from 16 starts at each point,
 *
 *     I           one answer, regular throughout, and no |d ln P / d ln p| of 5 or more: run it
 *     II          regular throughout, but a sensitivity of 5 or more, or several answers: by tolerances and starts
 *     III         somewhere in the window not regular, or an answer whose period doubles inside it: do not run it
 *     unresolved  something could not be told, and nothing of what was told makes it III
 *
 * P is what the experiment measures (a beam: the largest peak force; a house: the time to complete). Answers are one
 * when their outcomes are and their measures agree; a motion and its mirror image are one, for theirs do. Beyond the
 * window, each parameter is followed outwards alone to where things change: neighbours.h. */
#pragma once

#include "base/fault.h"
#include "study/neighbours.h"

#define TYPES_WINDOW 0.01 /* 1, of each parameter, either way */
#define TYPES_STEEP 5.0   /* 1, |d ln P / d ln p| from which on a response is steep */
#define TYPES_SAME 0.01   /* 1, measures that differ by less are of one answer */

enum {
    TYPES_STARTS = 16,          /* seeds 0 to 15 at each point */
    TYPES_PARAMETERS_MOST = 8,  /* of a window */
    TYPES_ANSWERS_MOST = 16,    /* at a point: as many as starts */
    TYPES_THOROUGH_MOST = 256,  /* trials that are made again thoroughly, at most: as many as a window mostly has */
    TYPES_UNTOLD_MOST = 4,      /* of them that cannot be told then either, before the others are left alone */
    TYPES_THOROUGH_AT_ONCE = 2, /* of them before it is seen whether that is enough */
};

typedef enum TypesKind { TYPES_UNRESOLVED, TYPES_I, TYPES_II, TYPES_III } TypesKind;

/* What of the definition it is. */
typedef enum TypesReason {
    TYPES_ALL_WELL,      /* I */
    TYPES_STEEP_ANSWER,  /* II: a sensitivity */
    TYPES_SEVERAL,       /* II: answers, at one point or from point to point */
    TYPES_NOT_REGULAR,   /* III */
    TYPES_FLIPS,         /* III: a period doubles */
    TYPES_CANNOT_BE_TOLD /* unresolved */
} TypesReason;

/* One answer at a point. */
typedef struct TypesAnswer {
    double outcome, measure;
    size_t starts; /* that end there */
} TypesAnswer;

/* A point of the window. */
typedef struct TypesPoint {
    size_t parameter; /* index into Types.parameters; of the centre, their count */
    double value;     /* of that parameter; of the centre, NAN */
    bool possible;    /* false: the value is out of range, and nothing is said of it */
    TypesAnswer answers[TYPES_ANSWERS_MOST];
    size_t answer_count;
    size_t irregular, untold; /* starts */
} TypesPoint;

typedef struct TypesParameter {
    const char *name;
    double nominal;
    double sensitivity; /* d ln P / d ln p, the steeper of both sides and of all answers; HUGE_VAL: P is 0 on one side;
                           NAN: cannot be told, or the parameter is 0 and has no window */
    Neighbour below, above;
} TypesParameter;

enum { TYPES_POINTS_MOST = 1 + 2 * TYPES_PARAMETERS_MOST };

typedef struct Types {
    TypesKind kind;
    TypesReason reason;
    TypesParameter parameters[TYPES_PARAMETERS_MOST];
    size_t parameter_count;
    TypesPoint points[TYPES_POINTS_MOST]; /* the centre, then the lower and the upper end of each parameter */
    size_t point_count;
    size_t answers;          /* at the point that has most */
    size_t worst;            /* index into points: where the reason is seen; the centre when it is seen there */
    size_t runs, thorough;   /* trials of the window; of them made again thoroughly */
    size_t neighbour_runs;   /* trials beyond it */
    NeighboursSought sought; /* what the neighbours are: trouble, or regular answers */
    bool stopped;            /* before it was complete */
} Types;

/* What is asked. */
typedef struct TypesTask {
    const Experiment *experiment;
    const Experiment *thorough; /* the same, told with more effort where the first does not tell "regular"; NULL: the
                                   first is believed */
    const char *const *names;   /* (name_count) of the parameters */
    size_t name_count;
    bool window_only; /* neighbours are not looked for */
    int jobs;
    const volatile sig_atomic_t *stop;
    void (*progress)(void *context, size_t done, size_t all); /* trials; from one thread at a time; NULL: none */
    void *context;
} TypesTask;

/* "I", "II", "III", "unresolved" */
const char *types_kind_name(TypesKind kind);

/* Can types be told in a window of these names (name_count)? False: a fault. */
bool types_check(const Experiment *experiment, const char *const *names, size_t name_count, Fault *fault);

/* Tells the type. False: a fault, of a name that is no parameter's or too many of them. */
bool types_tell(Types *types, const TypesTask *task, Fault *fault);
