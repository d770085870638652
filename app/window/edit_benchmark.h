/* Measures how quickly the result follows an edit, for --benchmark-edit: drags a piece of furniture along a small
 * circle by mouse events. Each step waits until the answer to the plan as the step before left it is on the screen, at
 * most one second; a step that leaves the plan as it was, since pieces snap, counts as none. */
#pragma once

#include "window/window_state.h"

/* Advances the benchmark; call it after each frame. True: it has ended and printed its results. */
bool edit_benchmark_advance(Window *window, double begun);
void edit_benchmark_clear(Window *window);
