/* Which experiment a file is studied by. */
#pragma once

#include "options/options.h"
#include "study/experiment.h"

typedef struct StudyLaboratory {
    bool (*is_file)(const char *path); /* NULL: whatever is left */
    bool (*open)(Experiment *experiment, const Options *options, Fault *fault);
    void (*close)(Experiment *experiment);
    const char *hidden;                      /* the observable that only tells runs apart: "way"; "" for none */
    const char *regular, *irregular, *mixed; /* runs, in a word or two: "out", "not out", "sometimes out" */
} StudyLaboratory;

/* Opens the experiment of the command line's file. NULL: faults say where and what. Its `close` releases it. */
const StudyLaboratory *study_laboratory_open(Experiment *experiment, const Options *options, Fault *fault);
