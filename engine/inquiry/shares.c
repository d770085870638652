#include "inquiry/shares.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "house/journey.h"

/* m: what a way must keep from everything to be a way of a larger body. */
static const double KEPT = 0.005;

/* Bodies that are tried at once for one person, and the candidates for them: numbers of the result's order, whatever
 * the number of threads. */
enum { AT_ONCE = 4, CANDIDATES = 64 };

/* A driver's body with what is known of its best passage. */
typedef struct Size {
    double width, length; /* m */
    Passage least, most;
} Size;

/* A body that was tried and is not driven. */
typedef struct Refusal {
    double width, length; /* m */
    Vec2 at;
    char what[96];
} Refusal;

typedef struct Crew {
    size_t index;
    Size *bodies; /* (count) */
    Refusal *refusals;
    size_t refusal_count, refusal_capacity, tried;
} Crew;

/* A route to plan for one body. */
typedef struct Trial {
    Crew *person;
    size_t body;
    bool skids; /* True if skids are tried as well */
    RouteAnswer answer;
    bool fits;
    double narrowest; /* m */
    Blockage blockage;
} Trial;

typedef struct Work {
    const House *house;
    size_t count;
    const Stop *stop;
    Trial *trials;
    size_t trial_count, trial_capacity;
} Work;

static void plan_trial(void *context, size_t t) {
    const Work *work = context;
    Trial *trial = &work->trials[t];
    const House *house = work->house;
    size_t i = trial->person->index;
    const Size *body = &trial->person->bodies[trial->body];
    Profile profile = *house->people[i].profile;
    profile.width = body->width;
    profile.length = body->length;
    profile.axle = fmin(profile.axle, body->length);
    House other = *house;
    other.people = memory_zeroed(house->person_count, sizeof *other.people);
    memcpy(other.people, house->people, house->person_count * sizeof *other.people);
    other.people[i].profile = &profile;
    bool *part = memory_zeroed(house->person_count, sizeof *part);
    part[i] = true;
    Journeys journeys = trial->skids ? journey_plan_all(&other, part, 1, work->stop)
                                     : journey_plan_briefly(&other, part, 1, work->stop);
    const Route *route = &journeys.of[i].route;
    trial->answer = route->answer;
    trial->fits = route->fits;
    trial->narrowest = route->narrowest;
    trial->blockage = route->blockage;
    journey_free_all(&journeys);
    memory_free(part);
    memory_free(other.people);
}

/* True if the first body contains the second one. */
static bool contains(const Size *body, const Size *other) {
    return other->width <= body->width && other->length <= body->length;
}

/* True if what is asked of a body is not known: whether it drives or fits, or else whether it passes with a skid. */
static bool is_open(const Size *body, bool skids) {
    if (skids)
        return body->least < PASSAGE_SKIDS && body->most == PASSAGE_SKIDS;
    return body->least < body->most && !(body->least == PASSAGE_CARRIED && body->most == PASSAGE_SKIDS);
}

static void at_least(const Work *work, const Crew *person, const Size *larger, Passage passage) {
    for (size_t k = 0; k < work->count; k++)
        if (contains(larger, &person->bodies[k]) && person->bodies[k].least < passage)
            person->bodies[k].least = passage;
}

static void at_most(const Work *work, const Crew *person, const Size *smaller, Passage passage) {
    for (size_t k = 0; k < work->count; k++)
        if (contains(&person->bodies[k], smaller) && person->bodies[k].most > passage)
            person->bodies[k].most = passage;
}

static void note_refusal(Crew *person, const Size *body, const Blockage *blockage) {
    person->refusals = memory_reserve(person->refusals, &person->refusal_capacity, person->refusal_count + 1,
                                      sizeof *person->refusals);
    Refusal *refusal = &person->refusals[person->refusal_count++];
    *refusal = (Refusal){.width = body->width, .length = body->length, .at = blockage->at};
    memcpy(refusal->what, blockage->what, sizeof refusal->what);
}

/* Decides all bodies of a person that this trial decides. */
static void learn(const Work *work, const Trial *trial) {
    Crew *person = trial->person;
    Size body = person->bodies[trial->body];
    person->tried++;
    if (trial->answer == ROUTE_FOUND) {
        double grown = fmax(trial->narrowest - KEPT, 0) * M_SQRT1_2;
        body.width += 2 * grown;
        body.length += grown;
        at_least(work, person, &body, PASSAGE_DRIVES);
        return;
    }
    bool skids = trial->skids && trial->blockage.skid > 0;
    at_most(work, person, &body,
            !trial->fits             ? PASSAGE_NONE
            : trial->skids && !skids ? PASSAGE_CARRIED
                                     : PASSAGE_SKIDS);
    if (trial->fits)
        at_least(work, person, &body, skids ? PASSAGE_SKIDS : PASSAGE_CARRIED);
    if (!trial->skids)
        note_refusal(person, &body, &trial->blockage);
}

/* Returns how many open bodies this one decides for sure, whatever the answer. */
static size_t worth(const Work *work, const Crew *person, const Size *body, bool skids) {
    size_t below = 0, above = 0;
    for (size_t k = 0; k < work->count; k++)
        if (is_open(&person->bodies[k], skids)) {
            below += contains(body, &person->bodies[k]);
            above += contains(&person->bodies[k], body);
        }
    return below < above ? below : above;
}

/* True if a body that is tried already may decide this one. */
static bool is_comparable(const Work *work, size_t first, const Crew *person, const Size *body) {
    for (size_t t = first; t < work->trial_count; t++) {
        const Size *tried = &person->bodies[work->trials[t].body];
        if (contains(tried, body) || contains(body, tried))
            return true;
    }
    return false;
}

/* Adds up to AT_ONCE trials for a person, of bodies none of which contains another one. */
static void choose_trials(Work *work, Crew *person, bool skids) {
    size_t first = work->trial_count, open = 0;
    for (size_t k = 0; k < work->count; k++)
        open += is_open(&person->bodies[k], skids);
    size_t stride = (open + CANDIDATES - 1) / CANDIDATES;
    for (int chosen = 0; chosen < AT_ONCE && open > 0; chosen++) {
        size_t best = SIZE_MAX, most = 0, seen = 0;
        for (size_t k = 0; k < work->count; k++) {
            const Size *body = &person->bodies[k];
            if (!is_open(body, skids) || seen++ % stride != 0 || is_comparable(work, first, person, body))
                continue;
            size_t decided = worth(work, person, body, skids);
            if (decided > most) {
                most = decided;
                best = k;
            }
        }
        if (best == SIZE_MAX)
            return;
        work->trials = memory_reserve(work->trials, &work->trial_capacity, work->trial_count + 1, sizeof *work->trials);
        work->trials[work->trial_count++] = (Trial){.person = person, .body = best, .skids = skids};
    }
}

/* Tries bodies of all people until nothing is open. */
static void decide(Work *work, Crew *people, size_t person_count, bool skids, int jobs) {
    do {
        work->trial_count = 0;
        for (size_t p = 0; p < person_count; p++)
            if (!skids || work->house->people[people[p].index].profile->skid_time > 0)
                choose_trials(work, &people[p], skids);
        parallel_for(jobs, work->trial_count, plan_trial, work);
        for (size_t t = 0; t < work->trial_count && !stop_requested(work->stop); t++)
            learn(work, &work->trials[t]);
    } while (work->trial_count > 0 && !stop_requested(work->stop));
}

/* Returns the refusal of the largest body that this one contains, or NULL. */
static const Refusal *refusal_of(const Crew *person, const Size *body) {
    const Refusal *nearest = NULL;
    double least = HUGE_VAL;
    for (size_t r = 0; r < person->refusal_count; r++) {
        const Refusal *refusal = &person->refusals[r];
        double larger = body->width - refusal->width + body->length - refusal->length;
        if (refusal->width <= body->width && refusal->length <= body->length && larger < least) {
            least = larger;
            nearest = refusal;
        }
    }
    return nearest;
}

static void count_refusals(const Work *work, const Crew *person, Shares *shares) {
    size_t *counts = memory_zeroed(person->refusal_count, sizeof *counts);
    for (size_t k = 0; k < work->count; k++) {
        const Refusal *refusal =
            person->bodies[k].least < PASSAGE_DRIVES ? refusal_of(person, &person->bodies[k]) : NULL;
        if (!refusal)
            continue;
        size_t first = 0;
        while (strcmp(person->refusals[first].what, refusal->what) != 0)
            first++;
        if (++counts[first] > shares->refused) {
            shares->refused = counts[first];
            shares->at = person->refusals[first].at;
            memcpy(shares->what, refusal->what, sizeof shares->what);
        }
    }
    memory_free(counts);
}

static void count_shares(const Work *work, const Crew *person, Shares *shares) {
    shares->drivers = work->count;
    shares->tried = person->tried;
    shares->interrupted = stop_requested(work->stop);
    if (shares->interrupted)
        return;
    for (size_t k = 0; k < work->count; k++)
        shares->count[person->bodies[k].least]++;
    count_refusals(work, person, shares);
}

static void draw_bodies(const House *house, const Population *population, Crew *person, size_t count) {
    person->bodies = memory_zeroed(count, sizeof *person->bodies);
    size_t first = house->plan.run.routes == ROUTES_ALONE ? 1 : 1 + person->index * DRIVERS_MOST;
    for (size_t k = 0; k < count; k++) {
        Profile profile = *house->people[person->index].profile;
        population_draw(population, first + k, house->seed, &profile);
        person->bodies[k] = (Size){profile.width, profile.length, PASSAGE_NONE, PASSAGE_DRIVES};
    }
}

void shares_find(Shares *shares, const House *house, const Population *population, size_t count, size_t route, int jobs,
                 const Stop *stop) {
    Work work = {.house = house, .count = count, .stop = stop};
    Crew *people = memory_zeroed(house->person_count, sizeof *people);
    size_t person_count = 0;
    for (size_t i = 0; i < house->person_count; i++) {
        const Inhabitant *person = &house->people[i];
        bool asked = route == SIZE_MAX || person->route == &house->plan.routes[route];
        shares[i] = (Shares){0};
        if (asked && person->profile->driving == DRIVING_DRIVER &&
            strcmp(person->profile->name, population->profile) == 0) {
            people[person_count].index = i;
            draw_bodies(house, population, &people[person_count++], count);
        }
    }
    decide(&work, people, person_count, false, jobs);
    decide(&work, people, person_count, true, jobs);
    for (size_t p = 0; p < person_count; p++) {
        count_shares(&work, &people[p], &shares[people[p].index]);
        memory_free(people[p].bodies);
        memory_free(people[p].refusals);
    }
    memory_free(people);
    memory_free(work.trials);
}
