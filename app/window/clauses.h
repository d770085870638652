/* Parts of a text that is too long for its place: whole lines and whole clauses. */
#pragma once

#include "window/window_state.h"

/* Returns the first line of a detail: of several faults the first, since the panel has them all. "": no detail. */
const char *clauses_first_line(Window *window, const char *detail);

/* Returns the first clauses of a text, whole ones, that fit into a width; "": none does. */
const char *clauses_whole(Window *window, UiTextStyle size, const char *text, double width);

/* Returns the first clauses of a text that fit into a width; if none does, all of them, to be shortened. */
const char *clauses_some(Window *window, UiTextStyle size, const char *text, double width);
