/* The names in a lesson, checked against its house, beam or crank: of measures (see attempt.h), of things in the view,
 * and of what is locked.
 *
 *     door d3, person p1, wall w2, exit gallery    things of a house by kind and id, as Tab reads them
 *     wardrobe, shelf (f3)                         furniture by its name, with its id if that is another word
 *     answer, timeline, plots                      parts of the window, which only `mark` takes
 *     walls, doors, furniture, ...                 lists of a house that are locked
 *     drive.frequency                              a number of a machine that is locked */
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

/* Add a fault if the view has no thing of that name (`parts`: or part of the window); if nothing of that name can be
 * locked. */
void names_check_thing(const Names *names, const Lesson *lesson, const char *name, bool parts, const JsonNode *node,
                       Fault *fault);
void names_check_lock(const Names *names, const Lesson *lesson, const char *name, const JsonNode *node, Fault *fault);

/* Returns the locked name that a setting "door.d3.width=0.9" or its name would change; NULL: it is free. */
const char *names_locked(const Lesson *lesson, const char *setting);

/* Returns the index of an observable; the number of observables: there is none of that name. */
size_t names_find_observable(const Experiment *experiment, const char *name);
