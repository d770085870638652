/* What a study runs: anything that can be run and observed when its named parameters are given values: an evacuation, a
 * beam in its clearance. A study knows neither; a laboratory makes the experiment (app/laboratory). */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/fault.h"
#include "base/memory.h"
#include "base/parameters.h"

/* One number that is seen of a run. */
typedef struct Observable {
    const char *name; /* "peak_max" */
    const char *unit;
    const char *meaning; /* a sentence's beginning: axis titles, headers, help */
} Observable;

/* One run: what it is asked, and what came of it. */
typedef struct Trial {
    const double *at; /* (names) value of each varied parameter, in its unit */
    uint64_t seed;    /* of all chance: starts, deviations; 0: the nominal start */
    double *observed; /* (observables) NAN: there is none */
    double *series;   /* (series_count) the numbers that a run lists, by memory_zeroed; trial_clear releases it */
    size_t series_count;
    char *fault; /* NULL, or why it could not be run with these values; by memory_zeroed */
    bool done;   /* false: it was stopped before */
} Trial;

typedef struct Experiment {
    const char *kind; /* "house", "beam" */
    const Observable *observables;
    size_t observable_count;
    const Observable *series; /* what a run lists, or NULL */

    /* What types are told by (types.h), indices into observables. */
    size_t regular; /* 1: the answer is regular (a stable periodic orbit; everybody out), 0: not, NAN: cannot be told */
    size_t outcome; /* which of several regular answers it is: another number is another one */
    bool periods;   /* the outcome is a period: where it doubles, there is a flip */
    size_t measure; /* what sensitivities are of, and what tells apart equal outcomes: a peak force, a time */

    bool carries; /* a run can begin where the one before it ended: sweeps up and down */
    size_t batch; /* runs that are best made together */
    void *given;  /* the laboratory's; any number of threads read it at once */

    /* Digest of what `given` was made of, beside the file and the settings; 0: of nothing else. */
    uint64_t identity;

    /* The parameter of that name, for its unit, range and meaning. NULL: none. */
    const Parameter *(*parameter)(const void *given, const char *name);

    /* Adds a fault, beginning with `place`, about a name that is no parameter's, and says which is meant. NULL: nobody
     * knows. */
    void (*unknown)(const void *given, const char *name, const char *place, Fault *fault);

    /* Its value when nothing varies it. */
    double (*nominal)(const void *given, const char *name);

    /* Makes the runs (count), whose trials have values for `names` (name_count); `carry`: one after the other, each
     * from where the one before ended. What comes of a run does not depend on the others, unless it is carried, nor on
     * how many there are. `stop`, when it becomes other than 0, ends it early; NULL: nothing does. */
    void (*run)(const void *given, const char *const *names, size_t name_count, Trial *trials, size_t count, bool carry,
                const volatile sig_atomic_t *stop);
} Experiment;

static inline void trial_clear(Trial *trial) {
    memory_free(trial->series);
    memory_free(trial->fault);
    trial->series = NULL;
    trial->fault = NULL;
    trial->series_count = 0;
}
