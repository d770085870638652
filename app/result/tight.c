#include "result/tight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int compare(const void *a, const void *b) {
    const Tight *p = a, *q = b;
    if (p->lost_time != q->lost_time)
        return (p->lost_time < q->lost_time) - (p->lost_time > q->lost_time);
    return p->peak_force != q->peak_force ? (p->peak_force < q->peak_force) - (p->peak_force > q->peak_force)
                                          : (p->hazard > q->hazard) - (p->hazard < q->hazard);
}

size_t tight_places(const Observation *observation, Tight places[TIGHT_MOST]) {
    Tight all[HAZARDS_MOST];
    size_t count = 0;
    for (size_t h = 0; h < observation->hazard_count; h++) {
        const Hazard *hazard = &observation->hazards[h];
        size_t i = 0;
        while (i < count && strcmp(observation->hazards[all[i].hazard].what, hazard->what) != 0)
            i++;
        if (i == count)
            all[count++] = (Tight){.hazard = h, .clearance = HUGE_VAL};
        all[i].clearance = fmin(all[i].clearance, hazard->clearance);
        all[i].peak_force = fmax(all[i].peak_force, hazard->peak_force);
        all[i].lost_time += hazard->lost_time;
    }
    qsort(all, count, sizeof *all, compare);
    count = count < TIGHT_MOST ? count : TIGHT_MOST;
    memcpy(places, all, count * sizeof *all);
    return count;
}
