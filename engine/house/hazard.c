#include "house/hazard.h"

#include <stdio.h>

#include "base/memory.h"

static double score_of(const RunSettings *run, double clearance, double peak_force, double lost_time) {
    double near = run->clearance_warning > 0 ? (run->clearance_warning - clearance) / run->clearance_warning : 0;
    double force = run->force_warning > 0 ? peak_force / run->force_warning : 0;
    double loss = run->loss_warning > 0 ? lost_time / run->loss_warning : 0;
    return fmax(near, 0) + force + loss; /* no clearance known is an infinite one */
}

/* The stretches and, for each that no hazard has taken yet, the hazard that it would be the middle of. */
typedef struct Ranking {
    const RunSettings *run;
    const Stretch *stretches; /* (count) */
    Hazard *hazards;          /* (count) */
    bool *taken;              /* (count) */
    size_t count;
    Broadphase *places; /* of the stretches: who is near is not looked for among all */
} Ranking;

typedef struct Gathering {
    Ranking *ranking;
    Vec2 at;
    Hazard *hazard;
} Gathering;

static bool is_near(const Gathering *gathering, int item) {
    return vec2_distance(gathering->ranking->stretches[item].at, gathering->at) <= HAZARD_RADIUS;
}

static bool gather_stretch(void *context, int item) {
    Gathering *gathering = context;
    const Stretch *stretch = &gathering->ranking->stretches[item];
    if (gathering->ranking->taken[item] || !is_near(gathering, item))
        return true;
    Hazard *hazard = gathering->hazard;
    hazard->clearance = fmin(hazard->clearance, stretch->clearance);
    hazard->peak_force = fmax(hazard->peak_force, stretch->peak_force);
    hazard->lost_time += fmax(stretch->lost_time, 0);
    return true;
}

/* Gathers everything near stretch i that no other hazard has taken. */
static void gather(Ranking *ranking, size_t i) {
    Hazard *hazard = &ranking->hazards[i];
    *hazard = (Hazard){.at = ranking->stretches[i].at, .clearance = HUGE_VAL};
    broadphase_visit(ranking->places, box_around(hazard->at, HAZARD_RADIUS), gather_stretch,
                     &(Gathering){ranking, hazard->at, hazard});
    hazard->score = score_of(ranking->run, hazard->clearance, hazard->peak_force, hazard->lost_time);
}

static bool take_stretch(void *context, int item) {
    Gathering *gathering = context;
    gathering->ranking->taken[item] |= is_near(gathering, item);
    return true;
}

static bool gather_again(void *context, int item) {
    Gathering *gathering = context;
    if (!gathering->ranking->taken[item])
        gather(gathering->ranking, (size_t)item);
    return true;
}

static bool is_dangerous(const Hazard *hazard, const RunSettings *run) {
    return hazard->clearance < run->clearance_warning || hazard->peak_force > run->force_warning ||
           hazard->lost_time > run->loss_warning;
}

/* The worst hazard among the stretches that are left; count when none is dangerous. */
static size_t find_worst(const Ranking *ranking) {
    size_t worst = ranking->count;
    for (size_t i = 0; i < ranking->count; i++)
        if (!ranking->taken[i] && is_dangerous(&ranking->hazards[i], ranking->run) &&
            (worst == ranking->count || ranking->hazards[i].score > ranking->hazards[worst].score))
            worst = i;
    return worst;
}

size_t hazard_rank(Hazard hazards[HAZARDS_MOST], const Stretch *stretches, size_t count, const House *house) {
    Ranking ranking = {.run = &house->plan.run,
                       .stretches = stretches,
                       .hazards = memory_allocate(count, sizeof *ranking.hazards),
                       .taken = memory_allocate(count, sizeof *ranking.taken),
                       .count = count,
                       .places = broadphase_create()};
    for (size_t i = 0; i < count; i++)
        broadphase_insert(ranking.places, box_around(stretches[i].at, 0), (int)i);
    for (size_t i = 0; i < count; i++)
        gather(&ranking, i);
    size_t found = 0, worst;
    while (found < HAZARDS_MOST && (worst = find_worst(&ranking)) < count) {
        Hazard *hazard = &hazards[found++];
        *hazard = ranking.hazards[worst];
        if (stretches[worst].other >= 0)
            snprintf(hazard->what, sizeof hazard->what, "person %s", house->people[stretches[worst].other].id);
        else
            outline_place_name(&house->outline, &house->plan, hazard->at, hazard->what, sizeof hazard->what);
        Gathering taking = {.ranking = &ranking, .at = hazard->at};
        broadphase_visit(ranking.places, box_around(hazard->at, HAZARD_RADIUS), take_stretch, &taking);
        broadphase_visit(ranking.places, box_around(hazard->at, 2 * HAZARD_RADIUS), gather_again, &taking);
    }
    broadphase_destroy(ranking.places);
    memory_free(ranking.taken);
    memory_free(ranking.hazards);
    return found;
}
