/* Makes a way free and comfortable: see relax.c. */
#pragma once

#include "base/stop.h"
#include "route/way.h"

/* How a way is made free: `comfort` is the weight of clearances below RELAX_COMFORT (60 to keep off walls, 20 to be
 * short). */
typedef struct RelaxOptions {
    double margin;  /* m, that is kept where there is room */
    double barely;  /* m, that is enough where there is none */
    double comfort; /* 1 */
    bool soon;      /* True to end as soon as the way is free, however uncomfortable it is */
    const Stop *stop;
} RelaxOptions;

#define RELAX_COMFORT 0.14 /* m */

/* Moves the stations, which may begin within obstacles, until the body is free. Returns the clearance that is kept all
 * along, m: the margin, or else at least `barely`; 0: the way is not free, or it was interrupted. `lacking`, m, is how
 * much of the margin the stations lack at last. */
double relax_way(Way *way, const FreeSpace *space, const Rectangle *body, const RelaxOptions *options, double *lacking);
