/* The strip of three first things to try, between the view and the timeline; in a small window it is the next one
 * alone, in the strip of keys. Each is ticked once it has been done, the third once a piece was fixed to the wall
 * after an earthquake and the house was shaken again; after all three, or its cross, the strip is gone until Help > Try
 * this. */
#pragma once

#include "window/window_state.h"

/* Takes the strip's room from the layout, if there is something left to try. */
void tries_take_room(Window *window);

/* Shows the strip and notes what has been done. */
void tries_show(Window *window);
