/* How quickly the answer follows the hand: what --benchmark-edit prints. A piece of furniture is dragged along a small
 * circle, by the mouse as the window has it; each step waits until the answer to the one before is on the screen, or
 * for a second. */
#pragma once

#include "window/window_state.h"

/* After each frame; true: it is over, and what was measured has been printed. */
bool edit_benchmark_advance(Window *window, double begun);
void edit_benchmark_clear(Window *window);
