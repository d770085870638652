/* How drivers differ: rows of a profile as distributions, between people and between two runs of one person, read from
 * assets/populations.
 *
 * Driver k of a seed takes, in the row with the j-th prime p_j, the quantile at frac(u + k sqrt(p_j)), u a number of
 * the seed and the row's name (Richtmyer's sequence): the first ten of a hundred are the ten, they are spread already,
 * and neither a row more nor the order of the rows disturbs any other. Rows of one group are correlated:
 * z = sqrt(rho) z_group + sqrt(1 - rho) z_row.
 * Driver 0 is the profile itself. */
#pragma once

#include <stdint.h>

#include "base/parameters.h"
#include "plan/profile.h"

enum { DRIVERS_MOST = 10000 /* the streams of chance of the people of a house are this far apart */ };

typedef enum PopulationLaw { LAW_LOGNORMAL, LAW_NORMAL, LAW_FACTOR } PopulationLaw;

/* A row draws a value: lognormal(median, sigma of the logarithm), normal(mean, deviation), or a factor, lognormal(1,
 * sigma), on the profile's value or that of the row of the same name at the level "person". */
typedef struct PopulationRow {
    const char *name;         /* "drive.free_speed", or a row of the start: "start.x", "start.y", "start.heading" */
    const Parameter *profile; /* the profile's row; NULL: of the start */
    const char *level;        /* "person" or "run" */
    int law;                  /* PopulationLaw */
    double middle, spread;    /* median and sigma, mean and deviation, or 1 and sigma */
    double low, high;         /* the values are cut to these */
    const char *group;        /* NULL: independent */
    const char *provenance;
} PopulationRow;

typedef struct Population {
    const char *id, *title, *note;
    const char *profile; /* the profile that it varies */
    double correlation;  /* 1, rho of the rows of one group */
    PopulationRow *rows;
    size_t count;
    Arena arena;
} Population;

/* What a driver has of their own at the start of a run. */
typedef struct PopulationStart {
    double x, y;    /* m, ahead and to the left, in the frame of the chair at its start */
    double heading; /* rad, added to it */
} PopulationStart;

/* Reads a population file. Returns false after an error, with the population unchanged. population_free releases it. */
bool population_read(Population *population, const char *path, Fault *fault);
void population_free(Population *population);

/* Changes a profile of the driving model `driver` to that of driver k. Returns what is particular to the start. */
PopulationStart population_draw(const Population *population, size_t driver, uint64_t seed, Profile *profile);
