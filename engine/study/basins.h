/* Shares of the basins of what coexists: of many random starts at one value of a parameter, how many lead to each
 * answer. Regular answers are one when their outcomes are and their measures agree (TYPES_SAME); of irregular ones all
 * of one verdict are one. Runs of carried passes, which begin with the end state of their neighbour, and one from the
 * experiment's special start (Experiment.special; unless trials are slow) do not count as random starts: they add to no
 * share, but show answers that the random starts miss. */
#pragma once

#include "study/montecarlo.h"

enum { BASINS_MOST = 8 /* answers at one value */ };

typedef struct Basin {
    double outcome, measure; /* of the experiment; outcome 0: not regular */
    int verdict;             /* index into Experiment.verdicts; -1: none */
    bool regular, contact;   /* contact: the measure is above 0 */
    Share share;             /* of the random starts, Wilson's 95 % interval */
    size_t others;           /* runs from starts that are not random which reach it */
} Basin;

typedef struct Basins {
    Basin of[BASINS_MOST]; /* (count) the largest share first */
    size_t count;
    size_t starts;       /* random ones that were told */
    double unseen_below; /* 1, share below which the basin of an answer lies that none of them reached, 95 % */
} Basins;

/* True if the study has basins: several runs of each value that begin afresh, of an experiment with verdicts
 * and without spreads. */
bool basins_exist(const Study *study);

/* Tells the basins at a step of the first axis; runs the special start there. */
Basins basins_at(const Study *study, size_t step);

/* Writes what an answer is: "period 1", "no contact", "chaotic". */
void basins_name(const Study *study, const Basin *basin, char *name, size_t size);
