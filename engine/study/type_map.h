/* An experiment whose runs also return the type at their values (types.h), for maps of types. Each run needs the
 * runs of a whole window. */
#pragma once

#include "study/types.h"

typedef struct TypeMap {
    const Experiment *of;       /* the experiment that is classified */
    const Experiment *thorough; /* as in TypesTask, or NULL */
    const char *const *names;   /* (name_count) parameters of the window */
    size_t name_count;
    Observable *observables; /* the experiment's observables, and "type": 1, 2, 3; NAN: unresolved */
} TypeMap;

/* Opens an experiment from all fields except the last, which are given; both structures must outlive it. Returns
 * false after an error in the names. The close function releases it. */
bool type_map_open(TypeMap *map, Experiment *experiment, Fault *fault);
void type_map_close(TypeMap *map);
