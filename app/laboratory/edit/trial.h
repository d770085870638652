/* A proposal of the editor as it is tried beside the plan: a session of its own, by the same clock. The plan itself is
 * unchanged until the proposal is accepted.
 *
 *     trial_follow -> trial_update ... trial_span   (each frame)                                      trial_clear */
#pragma once

#include "laboratory/edit/editor.h"
#include "laboratory/laboratory.h"

typedef struct Trial {
    const Laboratory *laboratory;
    void *session;   /* NULL: nothing is tried */
    uint64_t number; /* of the proposal, see editor_chosen_proposal */
    size_t proposal; /* its index */
} Trial;

/* Opens the proposal that is chosen in the editor of a session, or closes it when it is gone. True if another one, or
 * none, is tried now. */
bool trial_follow(Trial *trial, const Laboratory *laboratory, void *session, Fault *fault);

/* Takes over new results, at a time, s; returns LABORATORY_... bits. */
unsigned trial_update(Trial *trial, double time);

/* Returns the span of both: a run that ends earlier stands at its end. */
RecordSpan trial_span(const Trial *trial, RecordSpan span);

/* Returns the time that a session shows when the clock is at `time`. */
double trial_time(const Laboratory *laboratory, const void *session, double time);

/* Returns what is changed first as an item of the trial's session; kind 0: none. `label`: its new width, or NULL. */
Item trial_item(const Trial *trial, Editor *editor, const char **label);

void trial_clear(Trial *trial);
