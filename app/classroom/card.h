/* The card of a lesson: what the step says and asks, the guesses of the class as bars, and the goal's verdict in words.
 * The window places it beside the view, so that it never covers the plan, the answer or the scale bar. */
#pragma once

#include "classroom/play.h"
#include "widgets/ui.h"

/* A press on the card: a key of play.h, or a request to leave the lesson, to start its step again, or to show
 * numbers. */
typedef struct CardPress {
    bool pressed, leaves, folds, restarts, numbers;
    PlayKey key;
    int digit; /* of an option, from 1 */
} CardPress;

/* How the card is shown. */
typedef struct CardLook {
    bool working;        /* the goal is being judged */
    bool folded;         /* one line: the step, what came of it so far, and the buttons */
    bool headline;       /* the question stands above, in the place of the answer */
    const char *numbers; /* label of a button that shows the numbers to change; NULL: there is none */
} CardLook;

/* Shows the card in a pane of its own, "lesson". Letters shrink before anything is left out. */
CardPress card_show(Ui *ui, const Play *play, Box box, const CardLook *look, Arena *arena);
