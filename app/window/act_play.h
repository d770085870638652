/* What actions do to the clock of what is shown. */
#pragma once

#include "window/keys.h"
#include "window/tab.h"

/* Plays, steps and goes to another time; any other action is nothing. */
void act_play_do(Tab *tab, Action action);

/* From the beginning on, once more; it plays where it did. */
void act_play_again(Tab *tab);
