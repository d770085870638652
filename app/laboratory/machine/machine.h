/* What the laboratories of machines whose motion repeats, beams and cranks, have in common: parameters, presets, the
 * verdict, the orbit diagram. Each is a struct of functions and tables; this folder knows them only through it. */
#pragma once

#include "beam/beam.h"
#include "crank/crank.h"
#include "experiment/beam_carry.h"
#include "experiment/crank_experiment.h"
#include "result/result.h"
#include "base/stop.h"
#include "cycle/response.h"
#include "study/experiment.h"

/* A machine by value; its texts belong to the machine that was read from a file. */
typedef union Machine {
    Beam beam;
    Crank crank;
} Machine;

/* The display of a parameter. */
typedef struct MachineLooks {
    const char *name, *label;
    const char *unit; /* NULL: the unit of the parameter's row */
    double factor;    /* displayed value = value x factor */
    double low, high; /* range of the slider as multiples of the value in the file; 0 and 0: from `least` to `most` */
    double least, most;
    double from, to; /* range of an orbit diagram as multiples of the value in the file; 0 and 0: the slider's range */
    bool logarithmic, first;
} MachineLooks;

enum { MACHINE_CHANGES = 2, MACHINE_PRESETS_MOST = 6, MACHINE_SWEEPS = 2 };

/* A machine of interest: the file's, with some numbers changed. */
typedef struct MachinePreset {
    const char *name, *meaning;
    struct {
        const char *name; /* NULL: none */
        double value;
        bool times; /* the value multiplies the file's */
    } changes[MACHINE_CHANGES];
} MachinePreset;

/* The state that one run of an orbit diagram hands on to the next one; zeroed: none. */
typedef union MachineCarry {
    BeamCarry beam;
    CrankCarry crank;
} MachineCarry;

struct MachineLines; /* lines.h */

/* What a verdict rests on. */
typedef struct MachineFacts {
    ResponseVerdict verdict;
    size_t period; /* cycles; 0: not periodic */
    SectionPeaks peaks;
    ChaosExponent exponent;
    ResultTable motion, forces;
    bool quick;  /* not confirmed, though it could be */
    char *words; /* further sentences, one per line; NULL: none; who has the facts releases it with their rows */
} MachineFacts;

/* An axis of a map: steps values from `from` to `to`, in the parameter's unit. */
typedef struct MachineMapAxis {
    const char *name; /* of the parameter; NULL: without a map */
    const char *word; /* for display */
    double from, to;
    size_t steps;
} MachineMapAxis;

enum { MACHINE_MAP_AXES = 2, MACHINE_MAP_CELLS = 128 };

typedef struct MachineKind {
    const char *word;   /* "beam" */
    const char *cycle;  /* "cycle", "revolution" */
    const char *from;   /* "From rest", a heading */
    const char *hit;    /* "hit", "push": the largest force of a cycle in plain words, */
    const char *hits;   /* and several of them */
    const char *peak;   /* "hardest hit (peak force)", the title of an axis */
    const char *drive;  /* "how fast it is shaken (excitation)" */
    size_t provenances; /* offset of the provenances, one per row of the table, in a machine */
    const ParameterTable *(*table)(void);
    const MachineLooks *looks; /* (look_count) at most MACHINE_VALUES */
    size_t look_count;
    const char *const *groups; /* (group_count) headings; in a parameter's name, their first letter is small */
    size_t group_count;
    const MachinePreset *presets; /* (preset_count) */
    size_t preset_count;

    /* The orbit diagram. */
    const char *const *sweeps; /* (MACHINE_SWEEPS) where its runs start: afresh, or from their neighbours */
    const char *sweeps_meaning;
    const char *const *over;        /* (over_count) names of the parameters along it, */
    const char *const *over_words;  /* and for display, */
    const char *const *over_titles; /* also with the terms of the trade, as titles of the axis */
    size_t over_count;
    size_t steps, coarse; /* values from rest; steps between the first ones, a power of two */
    size_t carried_steps; /* values of each pass, upwards and downwards */
    size_t together;      /* values that each thread computes at a time */
    size_t before_type;   /* values that are computed before the type */

    const char *const *window; /* (window_count) parameters of the window of types */
    size_t window_count;

    /* Simulates a machine from its start and tells its motion. False: a fault, or it was stopped. */
    bool (*decide)(const Machine *machine, MachineFacts *facts, const Stop *stop);
    int (*cycles)(const Machine *machine); /* of one run */
    size_t lanes;                          /* motions that are watched to confirm a verdict */

    /* Does the same and confirms a quick verdict by watching motions. False: it is not confirmed, or it was stopped.
     * Only kinds whose facts may be quick have it. */
    bool (*confirm)(const Machine *machine, MachineFacts *facts, int jobs, const Stop *stop);

    /* The machine's experiment, see experiment/beam_experiment.h; the machine must outlive it. */
    bool (*open_experiment)(Experiment *experiment, const Machine *machine, Fault *fault);
    void (*close_experiment)(Experiment *experiment);
    void (*be_thorough)(Experiment *experiment);
    void (*run_on)(const Experiment *experiment, const char *name, Trial *trials, size_t count, MachineCarry *carry,
                   const Stop *stop);
    void (*clear_carry)(MachineCarry *carry);

    /* Follows the orbit that a motion from `state` (count; none: from its start) settles on, over a parameter. False:
     * it was stopped. NULL: orbits of this kind cannot be followed. */
    bool (*follow)(const Machine *machine, const double *state, size_t count, const char *name, double from, double to,
                   struct MachineLines *lines, const Stop *stop);

    MachineMapAxis map[MACHINE_MAP_AXES]; /* of types; at most MACHINE_MAP_CELLS cells */

    size_t bands; /* values along the orbit diagram whose types are told by quick runs; 0: none */
} MachineKind;

enum { MACHINE_VALUES = 48 };
_Static_assert((int)MACHINE_VALUES >= (int)BEAM_VALUES && (int)MACHINE_VALUES >= (int)CRANK_VALUES, "room for each");

/* Returns the place of the provenance of a row. */
const char **machine_provenance(const MachineKind *kind, Machine *machine, const Parameter *row);

/* True if all numbers of the machines are equal. */
bool machine_same(const MachineKind *kind, const Machine *a, const Machine *b);
