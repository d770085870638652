/* Carries out the actions of the transport. */
#pragma once

#include "window/keys.h"
#include "window/tab.h"

/* Plays, steps or goes to another time; ignores any other action. */
void act_play_do(Tab *tab, Action action);

/* Runs again from the beginning, and keeps playing if it was playing. */
void act_play_again(Tab *tab);
