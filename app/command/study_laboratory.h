/* Chooses the experiment for the file of a study. */
#pragma once

#include "document/document.h"
#include "options/options.h"
#include "study/experiment.h"

typedef struct StudyLaboratory {
    bool (*is_file)(const char *path); /* NULL: any other file */
    bool (*open)(Experiment *experiment, const Options *options, Fault *fault);
    void (*close)(Experiment *experiment);
    void (*add_numbers)(Document *document, const void *options); /* of the file, with their sources; NULL: none */
    /* Returns the origin of the numbers, in the arena, as a foot of plots. */
    const char *(*source)(const Options *options, const Experiment *experiment, Arena *arena);
    void (*type_thoroughly)(Experiment *experiment); /* makes later trials thorough enough for a type; NULL: all are */
} StudyLaboratory;

/* Returns how many drivers drive each point, by the command line or, where it says nothing of runs, by the house. */
size_t study_laboratory_drivers(const Options *options, const Experiment *experiment);

/* Opens the experiment of the command line's file. NULL: `fault` says where and what is wrong. Its `close`
 * releases it. */
const StudyLaboratory *study_laboratory_open(Experiment *experiment, const Options *options, Fault *fault);
