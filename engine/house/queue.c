/* A person on foot estimates the time to leave by exit e as
 *
 *     T_e = max(l_e / v, n_e / (q b_e))
 *
 *     l_e  length of the path to the exit, m      n_e  people who go to e and are nearer to it
 *     v    free speed, m/s                        b_e  width of the exit, m
 *     q    people who pass a metre of width in a second
 *
 * since those who are nearer go first, and pass the exit while the person walks. It is the best response of Ehtamo,
 * Heliovaara, Korhonen and Hostikka (2010; known, not read again), who add the times of walking and of queueing up
 * instead of taking the longer one. A person turns to the exit with the least time if it saves a share of the present
 * one, so that small differences do not make people turn back and forth. People decide one after another in the order
 * of the house, each with the choices of those before, so that not all turn at once. */
#include "house/queue.h"

#include <stdint.h>

#include "base/memory.h"
#include "base/real.h"
#include "house/replan.h"
#include "plan/plan_geometry.h"

/* 1/(m s): q, the largest specific flow through a door of Nelson and Mowrer (SFPE handbook; known, not read again). */
static const double SPECIFIC_FLOW = 1.3;
/* 1 and s: another exit must take less than this share of the present time, and this much less. Assumed. */
static const double WORTH = 0.8, WORTH_BY = 2;
/* m: people see an exit if they see the floor this far before the middle of its line. Assumed. */
static const double BEFORE = 1.0;
/* Each person decides once in so many calls. Assumed: people look up from the person ahead every few seconds. */
enum { TURNS = 3 };

/* m: people within one such length count as equally near to an exit. */
static const double BIN = 0.5;
enum { BINS = 1024 };

/* An exit and the people who go there. */
typedef struct Queue {
    size_t exit;
    const FloorField *field; /* times to this exit alone */
    Vec2 before;             /* m, the place that shows the exit */
    double capacity;         /* 1/s */
    int sums[BINS + 1];      /* people by their distance, as a binary indexed tree: from 1 */
} Queue;

static int bin_of(const Queue *queue, Vec2 at) {
    double length = floor_field_time(queue->field, at) * queue->field->speed;
    return (int)real_min(length / BIN, BINS - 1);
}

static void add_people(Queue *queue, int bin, int count) {
    for (int b = bin + 1; b <= BINS; b += b & -b)
        queue->sums[b] += count;
}

static int people_below(const Queue *queue, int bin) {
    int sum = 0;
    for (int b = bin; b > 0; b -= b & -b)
        sum += queue->sums[b];
    return sum;
}

static bool chooses(const World *world, size_t i) {
    return !world_rides(world, i) && world->phase[i] == PHASE_MOVING && !world->house->people[i].route;
}

/* Returns the profile of the narrowest person who chooses, who can go wherever the others can; NULL: fewer than two
 * people move, or nobody chooses. */
static const Profile *narrowest_of(const World *world) {
    const Profile *narrowest = NULL;
    size_t moving = 0;
    for (size_t p = 0; p < world->present_count; p++) {
        size_t i = world->present[p];
        const Profile *profile = world->house->people[i].profile;
        moving += world->phase[i] == PHASE_MOVING;
        if (chooses(world, i) && (!narrowest || profile->width < narrowest->width))
            narrowest = profile;
    }
    return moving > 1 ? narrowest : NULL;
}

static Vec2 place_before(const FloorField *field, const Exit *exit) {
    Vec2 middle = vec2_scale(vec2_add(exit->from, exit->to), 0.5);
    if (!field->exit_count)
        return middle;
    Vec2 outwards = vec2_left(field->exits[0].along);
    return vec2_along(middle, -BEFORE * field->exits[0].outward, outwards);
}

/* Fills in the exits that are open now. Returns their number. */
static size_t list_exits(Queue *queues, const World *world, Journeys *journeys, const Profile *profile, int jobs,
                         const Stop *stop) {
    const Plan *plan = &world->house->plan;
    double time = clock_time(&world->clock);
    size_t count = 0;
    size_t *open = memory_zeroed(plan->exit_count, sizeof *open);
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan_geometry_is_open(&plan->exits[e], time))
            open[count++] = e;
    if (count > 1)
        journey_lead_to(journeys, world->house, profile, open, count, time, jobs, stop);
    for (size_t k = 0; k < count && count > 1 && !stop_requested(stop); k++) {
        const Exit *exit = &plan->exits[open[k]];
        const FloorField *field = *journey_leg_to(journeys, world->house, profile, open[k], time);
        queues[k] = (Queue){.exit = open[k],
                            .field = field,
                            .before = place_before(field, exit),
                            .capacity = SPECIFIC_FLOW * vec2_distance(exit->from, exit->to)};
    }
    memory_free(open);
    return stop_requested(stop) ? 0 : count;
}

/* Returns the queue that a moving person belongs to: that of the nearest exit to which the journey may lead. `count`:
 * none. */
static size_t queue_of(const Queue *queues, size_t count, const World *world, size_t i) {
    const Journey *journey = &world->journeys[i];
    size_t exit = journey->route.exit, nearest = count;
    double least = HUGE_VAL;
    for (size_t k = 0; k < count; k++) {
        const Goal *goal = journey->leg_count ? &journey->legs[journey->leg_count - 1]->goal : NULL;
        bool leads = goal ? field_exit_usable(goal, &world->house->plan, queues[k].exit) : exit == queues[k].exit;
        double time = leads ? floor_field_time(queues[k].field, world->centre[i]) : HUGE_VAL;
        if (time < least) {
            least = time;
            nearest = k;
        }
    }
    return nearest;
}

/* Returns T_e; `walk` is the least time to walk there. */
static double time_by(const Queue *queue, Vec2 at, double walk) {
    return real_max(walk, people_below(queue, bin_of(queue, at)) / queue->capacity);
}

static double time_to_walk(const Queue *queue, Vec2 at, double speed) {
    return floor_field_time(queue->field, at) * queue->field->speed / speed;
}

static bool is_in_sight(const World *world, size_t i, const Queue *queue) {
    return freespace_sees(&world->house->space, world->centre[i], queue->before);
}

/* Returns the queue that the person turns to, or `own`. */
static size_t choose(const Queue *queues, size_t count, const World *world, size_t i, size_t own) {
    Vec2 at = world->centre[i];
    double speed = world->house->people[i].speed, walk = time_to_walk(&queues[own], at, speed);
    double present = time_by(&queues[own], at, walk), least = real_min(WORTH * present, present - WORTH_BY);
    size_t best = own;
    if (present <= walk || !is_in_sight(world, i, &queues[own]))
        return own; /* the way is free, or its queue is unknown */
    for (size_t k = 0; k < count; k++) {
        double walk_there = k == own ? HUGE_VAL : time_to_walk(&queues[k], at, speed);
        if (!(walk_there < least))
            continue;
        double time = time_by(&queues[k], at, walk_there);
        if (time < least && is_in_sight(world, i, &queues[k])) {
            least = time;
            best = k;
        }
    }
    return best;
}

/* Leads person i to an exit. Returns false if this person finds no path there. */
static bool turn_to(World *world, Journeys *journeys, size_t i, size_t exit, int jobs, const Stop *stop) {
    const Profile *profile = world->house->people[i].profile;
    Journey *journey = &journeys->of[i];
    double time = clock_time(&world->clock);
    journey_lead_to(journeys, world->house, profile, &exit, 1, time, jobs, stop);
    const FloorField *const *leg = journey_leg_to(journeys, world->house, profile, exit, time);
    if (stop_requested(stop) || !(floor_field_time(*leg, world->centre[i]) < HUGE_VAL))
        return false;
    journey->legs = leg;
    journey->since = journey_since(world->house, time);
    journey->leg_count = 1;
    journey->route.exit = exit;
    replan_set_out(world, i, false);
    return true;
}

void queue_weigh(World *world, Journeys *journeys, int jobs, const Stop *stop) {
    size_t turn = (size_t)(clock_time(&world->clock) / REPLAN_PERIOD + 0.5), exits = world->house->plan.exit_count;
    const Profile *narrowest = exits > 1 ? narrowest_of(world) : NULL;
    if (!narrowest)
        return;
    Queue *queues = memory_zeroed(exits, sizeof *queues);
    size_t count = list_exits(queues, world, journeys, narrowest, jobs, stop);
    size_t *own = memory_zeroed(world->present_count, sizeof *own);
    for (size_t p = 0; p < world->present_count && count > 1; p++) {
        size_t i = world->present[p];
        own[p] = world->phase[i] == PHASE_MOVING ? queue_of(queues, count, world, i) : count;
        if (own[p] < count)
            add_people(&queues[own[p]], bin_of(&queues[own[p]], world->centre[i]), 1);
    }
    for (size_t p = 0; p < world->present_count && count > 1 && !stop_requested(stop); p++) {
        size_t i = world->present[p];
        if ((i + turn) % TURNS || own[p] == count || !chooses(world, i))
            continue;
        size_t best = choose(queues, count, world, i, own[p]);
        if (best == own[p] || !turn_to(world, journeys, i, queues[best].exit, jobs, stop))
            continue;
        add_people(&queues[own[p]], bin_of(&queues[own[p]], world->centre[i]), -1);
        add_people(&queues[best], bin_of(&queues[best], world->centre[i]), 1);
    }
    memory_free(own);
    memory_free(queues);
}
