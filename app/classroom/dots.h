/* Guesses of a class that are numbers, as dots over an axis: one row of columns for each vote. */
#pragma once

#include "classroom/play.h"
#include "widgets/ui.h"

/* Returns the height of the plot, design points. */
double dots_height(const PlayStep *guesses);

/* Draws the numbers of all votes, and, if it `tells`, a line at the answer. */
void dots_draw(Ui *ui, const LessonStep *step, const PlayStep *guesses, Box box, bool tells, Arena *arena);
