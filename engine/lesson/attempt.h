/* What a state of a lesson's house, beam or crank shows: the values of conditions, computed by a run of its own that
 * gives the same bits as the window's or `clearance run`.
 *
 * Measures of a house: those of measure.h; those of difference.h, against the beginning of the lesson; shakes_out,
 * the number of the earthquakes of seeds 1 to ATTEMPT_SHAKES after which all people are out; and any number that --set
 * takes, "door.d3.width". Of a beam or a crank: the observables of its experiment (beam_experiment.h), "period",
 * "regular", "peak_max", and any of its numbers. Of a person: see person.h. */
#pragma once

#include <stdbool.h>

#include "base/stop.h"
#include "lesson/person.h"

enum { ATTEMPT_SHAKES = 30 };

/* A state: the lesson's file, or the house `text` instead of it, with the settings of the lesson and then these. */
typedef struct AttemptState {
    const char *text;            /* a house as file text; NULL: as the file */
    const char *const *settings; /* (setting_count) NAME=VALUE */
    size_t setting_count;
    const char *profiles; /* directory of the shipped profiles */
    int jobs;             /* threads */
    const Stop *stop;
    PersonState person;

    /* NULL, or told by attempt_numbers how many numbers are known, after each; later calls leave those as they are. */
    void (*note)(void *context, size_t known);
    void *context;
} AttemptState;

/* Judges the conditions of a step's goal. False: interrupted, or a fault says why the state cannot be run; then no
 * verdict has changed. */
bool attempt_goal(const Lesson *lesson, LessonStep *step, const AttemptState *state, Fault *fault);

/* Computes the values of all numbers of the lesson. False as above. */
bool attempt_numbers(Lesson *lesson, const AttemptState *state, Fault *fault);
