/* The list of undo steps with the times of the clock at which they were made. */
#pragma once

#include "laboratory/edit/editor.h"

/* Notes the time of a new step; called after each change. */
void edit_steps_note(Editor *edit);

/* As editor_next_step and editor_steps. */
bool edit_steps_next(Editor *edit);
size_t edit_steps_list(const Editor *edit, EditStep steps[EDITOR_STEPS_MOST]);
