/* The card of a lesson: what the step says and asks, the guesses of the class as bars, and the goal's verdict in words.
 * The window places it beside the view, so that it never covers the plan, the answer or the scale bar. */
#pragma once

#include "classroom/play.h"
#include "widgets/ui.h"

/* A press on the card: a key of play.h, or a request to leave the lesson or to start its step again. */
typedef struct CardPress {
    bool pressed, leaves, folds, restarts;
    PlayKey key;
    int digit; /* of an option, from 1 */
} CardPress;

/* How the card is shown. */
typedef struct CardLook {
    bool working;  /* the goal is being judged */
    bool folded;   /* one line: the step, what came of it so far, and the buttons */
    bool headline; /* the question stands above, in the place of the answer */
} CardLook;

/* Shows the card in a pane of its own, "lesson". Letters shrink before anything is left out. */
CardPress card_show(Ui *ui, const Play *play, Box box, const CardLook *look, Arena *arena);
