/* The same house driven by many drivers of a population: whether each gets out, in what time, and what is touched.
 *
 * Driver 0 is the nominal one. The others differ in body, strength, speed and caution (population.h) and make errors of
 * steering (drive.c); on a route alone driver k is the same person on every route, and in company everybody is another
 * one. A driver takes the way of the nominal one if the own body passes it and is not so much smaller that it may need
 * fewer changes of direction; otherwise that of the body's class, the width rounded up to DRIVERS_WIDTH and the length
 * to DRIVERS_LENGTH; and where that class cannot pass, one planned for the body itself, unless the class rounded down
 * cannot pass either. So a driver's way depends on no other driver, and the first ten of a hundred are the ten,
 * whatever the number of threads. Speeds are each driver's own. Ways are planned for the nominal driver's speeds.
 */
#pragma once

#include "base/stop.h"
#include "house/house.h"
#include "house/observation.h"
#include "plan/population.h"

#define DRIVERS_WIDTH 0.01  /* m */
#define DRIVERS_LENGTH 0.05 /* m */

/* What one driver in one place of the house does. */
typedef struct DriverRun {
    bool took_part;
    bool varies; /* True if this person is of the population and took part */
    bool hands;  /* True if the driver pushes rims with hands (body.hands) */
    bool completed;
    Reason reason; /* why not */
    double time;   /* s */
    int contacts;
    double impact, energy; /* m/s of the fastest impact, J of all */
    Vec2 impact_at;        /* m */
    int part;              /* BodyPart */
    double squeeze;        /* N, greatest mean of the contact force over OBSERVATION_SQUEEZE */
    double narrowest;      /* m */
    double back_length;    /* m, driven backwards */
} DriverRun;

/* The path of a reference point, a point each DRIVERS_STEP of way. */
typedef struct DriverPath {
    float (*at)[3]; /* (count) x and y, m, speed along the heading, m/s */
    size_t count;
} DriverPath;

#define DRIVERS_STEP 0.1 /* m */

typedef struct Drivers {
    size_t count, person_count;
    DriverRun *runs;   /* (count x person_count) */
    DriverPath *paths; /* (count x person_count) */
    Touch **touches;   /* (count x person_count) of each run (touch_counts) */
    size_t *touch_counts;
    size_t plans; /* number of ways that were planned, of all people */
    bool interrupted;
} Drivers;

/* Runs drivers 1 to count. drivers_free releases the result. */
void drivers_run(Drivers *drivers, const House *house, const Population *population, size_t count, size_t route,
                 int jobs, const Stop *stop);
void drivers_free(Drivers *drivers);

/* Runs the house with driver `driver` (>= 1) alone, who does the same as among many. observation_free releases the
 * observation. */
void drivers_run_one(Observation *observation, const House *house, const Population *population, size_t driver,
                     size_t route, const Stop *stop);

/* Returns the path of a person in the trace of a run; memory_free its points. */
DriverPath drivers_path(const Trace *trace, size_t person);
