/* The interface between studies and simulators: anything that runs with given parameter values and returns
 * observables, such as an evacuation or a beam in its clearance. A study knows neither; engine/experiment/ has the
 * adaptors. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/parameters.h"
#include "base/stop.h"

/* A number that each run returns. */
typedef struct Observable {
    const char *name; /* "peak_max" */
    const char *unit;
    const char *meaning; /* beginning of a sentence, for axis titles, headings and help */
} Observable;

/* A run: its parameter values and its results. */
typedef struct Trial {
    const double *at; /* (names) value of each varied parameter, in the unit of the parameter */
    uint64_t seed;    /* seed of all random numbers: initial states, deviations; 0: nominal initial state */
    double *observed; /* (observables) NAN: no value */
    double *series;   /* (series_count) values that a run lists, by memory_zeroed; trial_clear releases them */
    size_t series_count;
    char *fault; /* NULL, or the reason why these values cannot be run; by memory_zeroed */
    char *note;  /* NULL, or words that belong to a result, such as the place of a grade; by memory_zeroed */
    bool done;   /* false: interrupted before the run */
} Trial;

typedef struct Experiment {
    const char *kind; /* "house", "beam" */
    const Observable *observables;
    size_t observable_count;
    const Observable *series; /* values that a run lists, or NULL */

    /* Observables that decide types (types.h), by index. */
    size_t
        regular; /* 1: the response is regular (a stable periodic orbit; all people out), 0: not, NAN: undetermined */
    size_t outcome; /* number that distinguishes regular responses */
    bool periods;   /* the outcome is a period: a doubled value is a flip */
    size_t measure; /* the observable of sensitivities, which also separates equal outcomes: a peak force, a time */

    size_t verdict; /* observable that is a class, by index into its words; one of them is known to be final
                       if it is below verdict_quick */
    const char *const *verdicts; /* (verdict_count) its words */
    size_t verdict_count;        /* 0: no observable is one */
    size_t verdict_quick;        /* the first of the words of quick runs */

    size_t rank;              /* observable that is an index into words, best first */
    const char *const *ranks; /* (rank_count) the words */
    size_t rank_count;        /* 0: no observable is one */
    const char *note;         /* name of the note of a run, which belongs to the rank: "grade_place"; NULL: none */

    const char *turning; /* frequency, Hz, of a shaft, which people read in rpm: its name; NULL: none */
    const char *cycle;   /* the word for what repeats: "revolution"; NULL: "cycle" */
    const char *chance;  /* what differs between runs of one point: "drivers"; NULL: only their seeds */
    bool slow;           /* True if a trial may take seconds */
    uint64_t special;    /* seed of a start of its own, which is always among those of a type; 0: none */
    bool carries;        /* a run can continue from the end of the previous one: sweeps up and down */
    size_t batch;        /* number of runs that are best simulated together */
    void *given;         /* owned by the experiment; read by any number of threads at once */

    /* digest of the origin of `given` besides the file and the settings; 0: nothing else */
    uint64_t identity;

    /* Returns the parameter of that name, with its unit, range and meaning, or NULL. */
    const Parameter *(*parameter)(const void *given, const char *name);

    /* Adds an error, beginning with `place`, about an unknown parameter name, with a suggestion. NULL: no
     * suggestions. */
    void (*unknown)(const void *given, const char *name, const char *place, Fault *fault);

    /* Returns the value of a parameter that is not varied. */
    double (*nominal)(const void *given, const char *name);

    /* Runs `count` trials, which have values for `names` (name_count). `carry`: one after another, each continuing
     * from the end of the previous one. A result depends neither on the other trials, unless carried, nor on their
     * number. A request of `stop` interrupts; NULL: never. */
    void (*run)(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count, bool carry,
                const Stop *stop);
} Experiment;

#define EXPERIMENT_RPM 60.0 /* rpm per Hz */

/* True if people read the parameter in rpm. */
static inline bool experiment_turns(const Experiment *experiment, const char *name) {
    return experiment->turning && strcmp(experiment->turning, name) == 0;
}

/* Returns the word for what repeats. */
static inline const char *experiment_cycle(const Experiment *experiment) {
    return experiment->cycle ? experiment->cycle : "cycle";
}

/* Returns the word of a trial's class, or NULL. */
static inline const char *trial_verdict(const Trial *trial, const Experiment *experiment) {
    double value = experiment->verdict_count ? trial->observed[experiment->verdict] : -1;
    return trial->done && value >= 0 && value < (double)experiment->verdict_count ? experiment->verdicts[(size_t)value]
                                                                                  : NULL;
}

/* Returns the word of a trial's rank, or NULL. */
static inline const char *trial_rank(const Trial *trial, const Experiment *experiment) {
    double value = experiment->rank_count ? trial->observed[experiment->rank] : -1;
    return trial->done && value >= 0 && value < (double)experiment->rank_count ? experiment->ranks[(size_t)value]
                                                                               : NULL;
}

static inline void trial_clear(Trial *trial) {
    memory_free(trial->series);
    memory_free(trial->fault);
    memory_free(trial->note);
    trial->series = NULL;
    trial->fault = NULL;
    trial->note = NULL;
    trial->series_count = 0;
}
