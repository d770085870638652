#include "result/tight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "result/census.h"
#include "result/jam.h"

static int compare(const void *a, const void *b) {
    const Tight *p = a, *q = b;
    if (p->lost_time != q->lost_time)
        return (p->lost_time < q->lost_time) - (p->lost_time > q->lost_time);
    return p->peak_force != q->peak_force ? (p->peak_force < q->peak_force) - (p->peak_force > q->peak_force)
                                          : (p->hazard > q->hazard) - (p->hazard < q->hazard);
}

/* True if two dangerous points are one place: at the same thing, in a crowd at the same exit, door or room. */
static bool is_same(const House *house, const Hazard *a, const Hazard *b) {
    return house->person_count > CENSUS_FEW ? jam_is_same(&house->plan, a, b) : strcmp(a->what, b->what) == 0;
}

static size_t gather(const House *house, const Observation *observation, Tight all[HAZARDS_MOST]) {
    size_t count = 0;
    for (size_t h = 0; h < observation->hazard_count; h++) {
        const Hazard *hazard = &observation->hazards[h];
        size_t i = 0;
        while (i < count && !is_same(house, &observation->hazards[all[i].hazard], hazard))
            i++;
        if (i == count)
            all[count++] = (Tight){.hazard = h, .clearance = HUGE_VAL};
        all[i].clearance = fmin(all[i].clearance, hazard->clearance);
        all[i].peak_force = fmax(all[i].peak_force, hazard->peak_force);
        all[i].lost_time += hazard->lost_time;
    }
    return count;
}

size_t tight_all(const House *house, const Observation *observation, Tight places[HAZARDS_MOST]) {
    size_t count = gather(house, observation, places);
    qsort(places, count, sizeof *places, compare);
    return count;
}

size_t tight_places(const House *house, const Observation *observation, Tight places[TIGHT_MOST]) {
    Tight all[HAZARDS_MOST];
    size_t count = tight_all(house, observation, all);
    count = count < TIGHT_MOST ? count : TIGHT_MOST;
    memcpy(places, all, count * sizeof *all);
    return count;
}

size_t tight_count(const House *house, const Observation *observation) {
    Tight all[HAZARDS_MOST];
    return gather(house, observation, all);
}

const char *tight_number(const House *house, const Observation *observation, size_t listed, Arena *arena) {
    bool all = observation->hazard_count < HAZARDS_MOST;
    return text_in_arena(arena, all ? "%zu" : "at least %zu", tight_count(house, observation) - listed);
}

const char *tight_to_spare(double clearance, Arena *arena) {
    if (clearance <= 0)
        return "touches";
    if (isinf(clearance))
        return NULL;
    return clearance < 1 ? text_in_arena(arena, "%.1f cm", 100 * clearance) : text_in_arena(arena, "%.2f m", clearance);
}
