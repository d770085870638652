#include "house/hazard.h"

#include <stdio.h>

#include "base/memory.h"

static double score_of(const RunSettings *run, double clearance, double peak_force, double lost_time) {
    double near = run->clearance_warning > 0 ? (run->clearance_warning - clearance) / run->clearance_warning : 0;
    double force = run->force_warning > 0 ? peak_force / run->force_warning : 0;
    double loss = run->loss_warning > 0 ? lost_time / run->loss_warning : 0;
    return fmax(near, 0) + force + loss; /* an unknown clearance is infinite */
}

/* The hazard centred on one stretch, and its worst single stretch, which gives its position and name. */
typedef struct Candidate {
    Hazard hazard;
    size_t worst;
    double worst_score;
} Candidate;

/* The stretches and, for each that is not part of a hazard yet, the hazard centred on it. */
typedef struct Ranking {
    const RunSettings *run;
    const Stretch *stretches; /* (count) */
    Candidate *candidates;    /* (count) */
    bool *taken;              /* (count) */
    size_t count;
    Broadphase *places; /* tree of the stretches, to find nearby ones */
} Ranking;

typedef struct Gathering {
    Ranking *ranking;
    Vec2 at;
    Candidate *candidate;
} Gathering;

static bool is_near(const Gathering *gathering, int item) {
    return vec2_distance(gathering->ranking->stretches[item].at, gathering->at) <= HAZARD_RADIUS;
}

static bool gather_stretch(void *context, int item) {
    Gathering *gathering = context;
    const Stretch *stretch = &gathering->ranking->stretches[item];
    if (gathering->ranking->taken[item] || !is_near(gathering, item))
        return true;
    Candidate *candidate = gathering->candidate;
    Hazard *hazard = &candidate->hazard;
    hazard->clearance = fmin(hazard->clearance, stretch->clearance);
    hazard->peak_force = fmax(hazard->peak_force, stretch->peak_force);
    hazard->lost_time += fmax(stretch->lost_time, 0);
    hazard->impact = fmax(hazard->impact, stretch->impact);
    hazard->energy += stretch->energy;
    double score = score_of(gathering->ranking->run, stretch->clearance, stretch->peak_force, stretch->lost_time);
    bool worse = score > candidate->worst_score || (score == candidate->worst_score && (size_t)item < candidate->worst);
    if (worse) {
        candidate->worst = (size_t)item;
        candidate->worst_score = score;
    }
    return true;
}

/* Gathers all stretches near stretch i that are in no other hazard. */
static void gather(Ranking *ranking, size_t i) {
    Candidate *candidate = &ranking->candidates[i];
    Hazard *hazard = &candidate->hazard;
    Vec2 middle = ranking->stretches[i].at;
    *candidate = (Candidate){.hazard.clearance = HUGE_VAL, .worst = i, .worst_score = -HUGE_VAL};
    broadphase_visit(ranking->places, box_around(middle, HAZARD_RADIUS), gather_stretch,
                     &(Gathering){ranking, middle, candidate});
    hazard->at = ranking->stretches[candidate->worst].at;
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

/* Returns the worst hazard among the remaining stretches; count when none is dangerous. */
static size_t find_worst(const Ranking *ranking) {
    size_t worst = ranking->count;
    for (size_t i = 0; i < ranking->count; i++)
        if (!ranking->taken[i] && is_dangerous(&ranking->candidates[i].hazard, ranking->run) &&
            (worst == ranking->count || ranking->candidates[i].hazard.score > ranking->candidates[worst].hazard.score))
            worst = i;
    return worst;
}

size_t hazard_rank(Hazard hazards[HAZARDS_MOST], const Stretch *stretches, size_t count, const House *house) {
    Ranking ranking = {.run = &house->plan.run,
                       .stretches = stretches,
                       .candidates = memory_zeroed(count, sizeof *ranking.candidates),
                       .taken = memory_zeroed(count, sizeof *ranking.taken),
                       .count = count,
                       .places = broadphase_create()};
    for (size_t i = 0; i < count; i++)
        broadphase_insert(ranking.places, box_around(stretches[i].at, 0), (int)i);
    for (size_t i = 0; i < count; i++)
        gather(&ranking, i);
    size_t found = 0, worst;
    while (found < HAZARDS_MOST && (worst = find_worst(&ranking)) < count) {
        Hazard *hazard = &hazards[found++];
        *hazard = ranking.candidates[worst].hazard;
        int other = stretches[ranking.candidates[worst].worst].other;
        if (other >= 0)
            snprintf(hazard->what, sizeof hazard->what, "person %s", house->people[other].id);
        else if (other == HAZARD_ALONE && outline_door_at(&house->plan, hazard->at) < 0)
            snprintf(hazard->what, sizeof hazard->what, OUTLINE_FREE_SPACE);
        else
            outline_place_name(&house->outline, &house->plan, hazard->at, hazard->what, sizeof hazard->what);
        Vec2 middle = stretches[worst].at;
        Gathering taking = {.ranking = &ranking, .at = middle};
        broadphase_visit(ranking.places, box_around(middle, HAZARD_RADIUS), take_stretch, &taking);
        broadphase_visit(ranking.places, box_around(middle, 2 * HAZARD_RADIUS), gather_again, &taking);
    }
    broadphase_destroy(ranking.places);
    memory_free(ranking.taken);
    memory_free(ranking.candidates);
    return found;
}
