/* `study --types`: types I, II and III of a house or a beam in a window of named parameters. */
#pragma once

#include "options/options.h"
#include "command/study_laboratory.h"
#include "study/type_map.h"

/* The experiment, the same told more thoroughly where there is such, and the window's parameters. */
typedef struct StudyTypes {
    const StudyLaboratory *laboratory;
    Experiment quick, thorough;
    bool both;
    const char *names[TYPES_PARAMETERS_MOST + 1]; /* (count) */
    size_t count;
    TypeMap map;
    Arena arena;
} StudyTypes;

/* Opens the command line's file. False: faults. study_types_close releases it. */
bool study_types_open(StudyTypes *types, const Options *options, Fault *fault);
void study_types_close(StudyTypes *types);

/* The experiment whose runs tell types, for a study over more than one place; as long as `types` is open. False: a
 * fault of the names. */
bool study_types_of_runs(StudyTypes *types, Experiment *experiment, Fault *fault);

/* Tells the type of the command line's file, prints it, writes --out. Returns the exit code. */
int study_types_answer(const Options *options);
