/* Measures what --benchmark-window and --benchmark-edit ask for, and prints it.
 *
 * Of the window: its pictures while it plays, then while the view, twice as near, is moved along a circle besides.
 *
 * Of edits: how quickly the result follows one. A piece of furniture is dragged along a small circle by mouse events.
 * Each step waits until the answer to the plan as the step before left it is on the screen, at most one second; a step
 * that leaves the plan as it was, since pieces snap, counts as none. */
#pragma once

#include "window/window_state.h"

/* Advances the benchmark, if there is one; call it after each frame. `begun`: s of wall time, when the window began.
 * True: it has ended and printed its results. */
bool benchmark_advance(Window *window, double begun);

/* True if frames are to follow one another without a pause. */
bool benchmark_hurries(const Window *window);

/* True if each frame shows something else, whether or not the simulation goes on. */
bool benchmark_moves(const Window *window);

void benchmark_clear(Window *window);
