/* A lesson that is given in the window: it opens the house or machine, hides what the class shall guess, plays what it
 * shall watch, and has goals judged for the state on the screen. The card (classroom/card.h) stands beside the view. */
#pragma once

#include <jansson.h>

#include "classroom/progress.h"
#include "window/window_state.h"

/* Opens a file: a lesson, by its contents, in place of the present one; otherwise as opening_file. False: faults were
 * posted. lesson_close ends the lesson; what it had opened stays open. */
bool lesson_open_any(Window *window, const char *path);
void lesson_close(Window *window);

/* True while the tab of an open lesson is shown. */
bool lesson_is_shown(const Window *window);

/* True if nothing of the result may be seen; if it may not be said yet; if the step's answer needs the panel. */
bool lesson_hides(const Window *window);
bool lesson_hides_words(const Window *window);
bool lesson_has_panel(const Window *window);

/* Returns the title of what is open: of the lesson, or of the file. */
const char *lesson_title(Window *window);

/* Returns the words that stand in place of a hidden answer. */
const char *lesson_question(const Window *window);

/* Uses a key; false: it is not the lesson's. */
bool lesson_key(Window *window, const SdlWindowEvent *event);

/* Closes the panel that lies over the card in presentation mode. */
void lesson_close_panel(Window *window);

/* Does an action of the menu Learn; false: it is another action. */
bool lesson_do(Window *window, Action action);

/* Leaves the lesson, and asks first if it has begun. */
void lesson_leave(Window *window);

/* Ends the lesson; after its last step, the guesses are forgotten. */
void lesson_end(Window *window);

/* True if the last step is shown; if the guesses and the place are kept for the next time. */
bool lesson_is_last(const Window *window);
bool lesson_is_kept(const Window *window);

/* Returns what was kept of the open lesson, while it is not chosen whether to go on with it; NULL: nothing. */
const Progress *lesson_kept(const Window *window);

/* Forgets it. */
void lesson_restart(Window *window);

/* Returns the tab that a file opens in: that of a lesson's house or machine, or that of its own kind. */
size_t lesson_tab_of(const char *path);

/* True if quitting, or opening this file (LEAVE_OPEN), would lose guesses or the place in the lesson, because they
 * cannot be kept. */
bool lesson_would_lose(const Window *window, Leave leave, const char *path);

/* Takes over verdicts, and asks for the goal of a new state. */
void lesson_update(Window *window);

/* True while the goal of the shown state is not judged yet. */
bool lesson_works(const Window *window);

/* Returns the width of the card, design points; 0: there is none, or it is folded to a line of this height. */
double lesson_width(const Window *window, Vec2 page);
double lesson_line(const Window *window);
void lesson_show(Window *window);

/* Draws frames round what the step names, over the view and the parts of the window. */
void lesson_mark(Window *window);

/* Returns why a row of the menu Learn cannot be used; NULL: it can. */
const char *lesson_reason(const Window *window, Action action);

/* Returns what scripts expect of; new, json_decref it. */
json_t *lesson_state(const Window *window);
