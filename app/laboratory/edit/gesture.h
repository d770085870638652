/* The common part of all gestures: a step that is repeated at each pointer movement, tried, and completed or
 * cancelled.
 *
 * A gesture is a table of functions. `update` turns the pointer and the typed numbers into a target; `make` turns
 * the target into changes of the draft. Both are repeated whenever the pointer moves: the step is rewound, made, and
 * tried.
 *
 *     pointer, fields -> update -> now -> make -> draft_try -> good, or a refusal */
#pragma once

#include "laboratory/edit/editor_state.h"

struct EditGesture {
    void (*update)(Editor *edit);
    const char *(*refuse)(const Editor *edit); /* why the target is no place for the item, before it is tried */
    void (*make)(Editor *edit);                /* NULL: the gesture does not change the draft */
    bool (*limit)(Editor *edit); /* moves a refused target to the nearest valid place; NULL or false: there is none */
    bool (*confirm)(Editor *edit, bool keys);  /* a press, or Enter */
    bool (*nudge)(Editor *edit, Vec2 by);      /* an arrow, m; NULL or false: it moves the typed place */
    bool (*back)(Editor *edit);                /* Backspace; NULL: cancels the gesture */
    bool (*escape)(Editor *edit);              /* Escape; NULL: cancels the gesture */
    void (*release)(Editor *edit, bool moved); /* of the press that began the gesture, or of a later press */
    void (*describe)(Editor *edit, Text *text);
    void (*promise)(const Editor *edit, Text *text); /* what a click does: "back to the wall"; NULL: no words */
    const char *(*warn)(Editor *edit);               /* what the item would touch there; NULL: nothing */
    void (*show)(Editor *edit);                      /* adds marks */
    void (*end)(Editor *edit);                       /* releases the data of the gesture; NULL: there are none */
};

/* Begins a gesture; `name` is the name of its step. `keys`: the pointer is ignored at first. The table must outlive
 * the editor. */
void edit_gesture_begin(Editor *edit, const EditGesture *gesture, const char *name, bool keys);

/* Repeats the gesture with the present pointer and fields. */
void edit_gesture_update(Editor *edit);

/* Completes the gesture as one step. False: the step is refused, and the gesture continues. */
bool edit_gesture_end(Editor *edit);

/* Cancels the gesture, if there is one: the draft is as before it. */
void edit_gesture_cancel(Editor *edit);

/* Completes the gesture at the last valid target. False: there is none, or it is refused; nothing has changed. */
bool edit_gesture_end_valid(Editor *edit);

/* Open and close an undo step without a gesture; closing reports the change to the owner. False: the fault says why
 * the step is invalid. */
void edit_gesture_begin_step(Editor *edit, const char *name);
bool edit_gesture_end_step(Editor *edit, Fault *fault);

/* Returns the snapped place of the pointer, m, and stores the snap; `ask` holds the deviations from the usual
 * request. */
Vec2 edit_gesture_snap(Editor *edit, SnapAsk ask);
