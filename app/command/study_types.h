/* `study --types`: types I, II and III of a house or a beam in a window of named parameters. */
#pragma once

#include "options/options.h"
#include "command/study_laboratory.h"
#include "study/type_map.h"

/* The experiment, the same experiment with the full analysis if there is one, and the parameters of the window. */
typedef struct StudyTypes {
    const StudyLaboratory *laboratory;
    Experiment quick, thorough;
    bool both;
    const char *names[TYPES_PARAMETERS_MOST + 1]; /* (count) */
    size_t count;
    TypeMap map;
    Arena arena;
} StudyTypes;

/* Opens the file of the command line. False: errors were added to `fault`. study_types_close releases it. */
bool study_types_open(StudyTypes *types, const Options *options, Fault *fault);
void study_types_close(StudyTypes *types);

/* Opens the experiment that classifies each run, for a study of several points; it lives as long as `types` is open.
 * False: a name is wrong, `fault` says which. */
bool study_types_of_runs(StudyTypes *types, Experiment *experiment, Fault *fault);

/* Classifies the file of the command line, prints the type, writes --out. Returns the exit code. */
int study_types_answer(const Options *options);
