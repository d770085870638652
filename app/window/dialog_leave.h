/* The dialogs that ask a question: before edits or guesses are lost, and after a crash. */
#pragma once

#include "window/window_state.h"

void dialog_leave_show(Window *window);
void dialog_leave_show_kept(Window *window);
void dialog_leave_show_recovered(Window *window);

/* Asks before a lesson is left whose guesses would be lost. */
void dialog_leave_show_lesson(Window *window);
