/* An experiment whose runs also say of which type the place is where they are (types.h): regions of types on a map.
 * Each run takes the runs of a whole window. */
#pragma once

#include "study/types.h"

typedef struct Typed {
    const Experiment *of;       /* the experiment that is looked at */
    const Experiment *thorough; /* as in TypesTask, or NULL */
    const char *const *names;   /* (name_count) of the window's parameters */
    size_t name_count;
    Observable *observables; /* those of the experiment, and "type": 1, 2, 3; NAN: unresolved */
} Typed;

/* The experiment of `typed`, whose fields but the last are given; both must outlive it. False: a fault of the names.
 * typed_close releases it. */
bool typed_open(Typed *typed, Experiment *experiment, Fault *fault);
void typed_close(Typed *typed);
