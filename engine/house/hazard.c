#include "house/hazard.h"

#include <stdio.h>

#include "base/memory.h"

static double score_of(const RunSettings *run, double clearance, double peak_force, double lost_time) {
    double near = run->clearance_warning > 0 ? (run->clearance_warning - clearance) / run->clearance_warning : 0;
    double force = run->force_warning > 0 ? peak_force / run->force_warning : 0;
    double loss = run->loss_warning > 0 ? lost_time / run->loss_warning : 0;
    return fmax(near, 0) + force + loss;
}

/* Gathers everything near stretch `first` that no other hazard has taken. */
static Hazard gather(const Stretch *stretches, size_t count, const bool *taken, size_t first, const RunSettings *run) {
    Hazard hazard = {.at = stretches[first].at, .clearance = HUGE_VAL};
    for (size_t k = 0; k < count; k++) {
        if (taken[k] || vec2_distance(stretches[k].at, stretches[first].at) > HAZARD_RADIUS)
            continue;
        hazard.clearance = fmin(hazard.clearance, stretches[k].clearance);
        hazard.peak_force = fmax(hazard.peak_force, stretches[k].peak_force);
        hazard.lost_time += fmax(stretches[k].lost_time, 0);
    }
    hazard.score = score_of(run, hazard.clearance, hazard.peak_force, hazard.lost_time);
    return hazard;
}

static bool is_dangerous(const Hazard *hazard, const RunSettings *run) {
    return hazard->clearance < run->clearance_warning || hazard->peak_force > run->force_warning ||
           hazard->lost_time > run->loss_warning;
}

size_t hazard_rank(Hazard hazards[HAZARDS_MOST], const Stretch *stretches, size_t count, const House *house) {
    const RunSettings *run = &house->plan.run;
    bool *taken = memory_allocate(count, sizeof *taken);
    size_t found = 0;
    while (found < HAZARDS_MOST) {
        size_t best = count;
        Hazard worst = {.score = -HUGE_VAL};
        for (size_t i = 0; i < count; i++) {
            if (taken[i])
                continue;
            Hazard hazard = gather(stretches, count, taken, i, run);
            if (is_dangerous(&hazard, run) && hazard.score > worst.score) {
                worst = hazard;
                best = i;
            }
        }
        if (best == count)
            break;
        for (size_t k = 0; k < count; k++)
            taken[k] |= vec2_distance(stretches[k].at, stretches[best].at) <= HAZARD_RADIUS;
        int other = stretches[best].other;
        if (other >= 0)
            snprintf(worst.what, sizeof worst.what, "person %s", house->people[other].id);
        else
            outline_place_name(&house->outline, &house->plan, worst.at, worst.what, sizeof worst.what);
        hazards[found++] = worst;
    }
    memory_free(taken);
    return found;
}
