/* The hands of a vote for one option, as a bar with its number: the pattern tells the votes apart without colour. */
#pragma once

#include "classroom/play.h"
#include "widgets/ui.h"

/* Draws the hands of a vote (0: the first) for an option (from 0); bars of all options and votes have one scale. */
void hands_draw(Ui *ui, const PlayStep *guesses, int vote, size_t option, Box box, Arena *arena);
