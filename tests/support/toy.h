/* A synthetic experiment with closed-form results, for tests of studies. */
#pragma once

#include "base/stop.h"
#include "study/study.h"

/* Observables of a run at (x, y): `regular`, 1 where x + memory < 2; `sum`, x + 10 y + the seed / 1000; `memory`, when
 * carried the sum of all x before in the chain, otherwise 0. Its series lists the first floor(x) + 1 squares. x is from
 * -10 to 100, over 50 is a fault of the run; n is whole; nominal are x = 1, y = 2, n = 3 and nothing = 0. */
enum { TOY_REGULAR, TOY_SUM, TOY_MEMORY, TOY_OBSERVABLES };

typedef struct Toy {
    int interrupted_after; /* number of trials after which it behaves like an interruption by Ctrl-C; 0: never */
    int run;               /* trials so far */
    Stop stop;
} Toy;

/* The experiment points at `toy`. */
Experiment toy_experiment(Toy *toy);

/* Returns a study with all features: two axes, three passes, three seeds, a tolerance. */
Study toy_study(const Experiment *experiment);
