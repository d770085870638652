/* Tries a lesson by its script, without a window: does what a good pupil does and, before that, what a bad one does,
 * and compares the goals with what the script expects.
 *
 * Of the script's commands (script.h), key, set and expect count here; those that only a window can follow are left
 * out. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/stop.h"
#include "classroom/play.h"

/* What the goal of a task said during the trial. */
typedef struct TrialTask {
    size_t step;    /* from 0 */
    size_t no, yes; /* expectations that were met */
} TrialTask;

typedef struct TrialResult {
    TrialTask tasks[LESSON_STEPS_MOST]; /* (task_count) */
    size_t task_count;
    size_t expected; /* expectations in the script */
    bool interrupted;
} TrialResult;

typedef struct TrialOptions {
    const char *profiles; /* directory of the shipped profiles */
    int jobs;
    const Stop *stop;
} TrialOptions;

/* Plays the lesson, whose numbers are computed, by its script. Faults: the script cannot be read, an expectation is not
 * met, a task is never reached or never missed, or the script does not come to the last step. */
TrialResult trial_run(Play *play, const TrialOptions *options, Fault *fault);

/* Adds a fault for each computed number that is outside its limits: a right option or a text no longer holds. */
void trial_check_numbers(const Lesson *lesson, Fault *fault);
