/* The names of measures in a lesson, checked against its house, beam or crank: see attempt.h. */
#pragma once

#include "lesson/lesson.h"
#include "plan/plan.h"
#include "study/experiment.h"

#define NAMES_SHAKES_OUT "shakes_out"

/* What names are checked against. */
typedef struct Names {
    Plan plan;             /* of a house */
    Experiment experiment; /* of a beam or crank; kind NULL: it is a house */
} Names;

/* Reads the lesson's file with these settings. False: faults, and there is nothing to close. */
bool names_open(Names *names, const Lesson *lesson, const char *const *settings, size_t count, Fault *fault);
void names_close(Names *names, const Lesson *lesson);

/* Finds the measure of a condition and returns its unit; NULL: a fault at the node names the nearest. */
const char *names_unit(const Names *names, const Lesson *lesson, Condition *condition, const JsonNode *node,
                       Fault *fault);

/* Opens and closes the experiment of a beam or crank with thorough trials. */
bool names_open_experiment(Experiment *experiment, const Lesson *lesson, const char *const *settings, size_t count,
                           Fault *fault);
void names_close_experiment(Experiment *experiment, const Lesson *lesson);

/* Returns the index of an observable; the number of observables: there is none of that name. */
size_t names_find_observable(const Experiment *experiment, const char *name);
