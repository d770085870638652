#include "experiment/drivers.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "house/journey.h"
#include "house/run.h"

/* m: a known way is driven by a body that keeps this clearance on it, or is at most as large as the one it was planned
 * for. */
static const double KEPT = 0.005;
/* m: a way with changes of direction is only for bodies not much smaller than the one it was planned for, since those
 * may do with fewer. */
static const double MUCH_NARROWER = 0.02, MUCH_SHORTER = 0.10;

/* The bodies for which a person's way is planned in turn, until a driver has an answer. None depends on other drivers,
 * so that a driver does the same alone and among a hundred. */
typedef enum Step {
    STEP_NOMINAL, /* the person's own profile */
    STEP_CLASS,   /* width and length rounded up */
    STEP_SMALLER, /* rounded down: where this body cannot pass, none of the class can */
    STEP_OWN,
    STEP_COUNT
} Step;

/* A plan of one person with some body. */
typedef struct BodyPlan {
    size_t person;
    double width, length; /* m */
    Journeys journeys;
} BodyPlan;

/* The plan that a driver follows as one of the people. */
typedef struct Choice {
    size_t plan; /* index in work->plans */
    bool decided;
} Choice;

typedef struct Work {
    const House *house;
    const Population *population;
    size_t route;
    const Stop *stop;
    House *houses; /* (count) of the drivers */
    BodyPlan *plans;
    size_t plan_count, plan_capacity;
    size_t first;    /* index of the first plan that is not made */
    Choice *choices; /* (count x person_count) by driver */
    Drivers *drivers;
} Work;

static bool varies(const Work *work, const Inhabitant *person) {
    return person->profile->driving != DRIVING_WALKER && strcmp(person->profile->name, work->population->profile) == 0;
}

/* True if ways are planned here for this person: all drivers, of the asked route alone if there is one. The paper's
 * discs plan for themselves. */
static bool takes_part(const Work *work, const Inhabitant *person) {
    const Plan *plan = &work->house->plan;
    bool asked = work->route == SIZE_MAX || person->route == &plan->routes[work->route];
    return asked && person->profile->driving == DRIVING_DRIVER;
}

/* Returns a house on the same plan, with profiles and people of its own: each varying person has a profile, behind
 * those of the house. Texts are shared with the house. */
static House house_alike(const Work *work) {
    const House *house = work->house;
    House alike = *house;
    alike.profiles = memory_zeroed(house->profile_count + house->person_count, sizeof *alike.profiles);
    memcpy(alike.profiles, house->profiles, house->profile_count * sizeof *alike.profiles);
    alike.people = memory_zeroed(house->person_count, sizeof *alike.people);
    for (size_t i = 0; i < house->person_count; i++) {
        size_t which = (size_t)(house->people[i].profile - house->profiles);
        alike.people[i] = house->people[i];
        if (varies(work, &house->people[i])) {
            alike.profiles[alike.profile_count] = house->profiles[which];
            which = alike.profile_count++;
        }
        alike.people[i].profile = &alike.profiles[which];
    }
    return alike;
}

/* Returns a varying person's own profile. */
static Profile *own_profile(const House *house, size_t i) {
    return &house->profiles[house->people[i].profile - house->profiles];
}

static void free_alike(House *house) {
    memory_free(house->profiles);
    memory_free(house->people);
}

static bool is_free(const House *house, const Profile *profile, Vec2 at, double heading) {
    if (profile->driving == DRIVING_MIURA)
        return freespace_exact(&house->space, at, profile->width, NULL) > profile->width / 2;
    Vec2 axis = vec2_heading(heading), middle = vec2_along(at, profile->length / 2 - profile->axle, axis);
    return freespace_clearance(&house->space, middle, axis, profile->length / 2, profile->width / 2, 0.1, NULL) > 0;
}

/* Moves a person's start as far as the walls allow. */
static void move_start(const House *house, Inhabitant *person, PopulationStart start) {
    for (double share = 1; share > 0.05; share /= 2) {
        Vec2 moved = vec2_turn(vec2(start.x, start.y), vec2_heading(person->heading));
        Vec2 at = vec2_along(person->at, share, moved);
        double heading = person->heading + share * start.heading;
        if (is_free(house, person->profile, at, heading)) {
            person->at = at;
            person->heading = heading;
            return;
        }
    }
}

static House house_of_driver(const Work *work, size_t driver) {
    House house = house_alike(work);
    house.driver = driver;
    bool alone = house.plan.run.routes == ROUTES_ALONE;
    for (size_t i = 0; i < house.person_count; i++) {
        Inhabitant *person = &house.people[i];
        if (!varies(work, person))
            continue;
        size_t who = alone ? driver : driver + i * DRIVERS_MOST;
        Profile *profile = own_profile(&house, i);
        PopulationStart start = population_draw(work->population, who, house.seed, profile);
        profile->axle = fmin(profile->axle, profile->length);
        if (work->house->plan.run.hands == SWITCH_OFF)
            profile->hands = 0;
        person->speed = profile->free_speed;
        move_start(&house, person, start);
    }
    return house;
}

/* Plans ------------------------------------------------------------------------------------------------------------*/

static double rounded_up(double length, double step) {
    return step * ceil(length / step - 1e-9);
}

static double rounded_down(double length, double step) {
    return step * fmax(floor(length / step + 1e-9), 1);
}

static const Route *route_of_plan(const BodyPlan *plan) {
    return &plan->journeys.of[plan->person].route;
}

static void plan_body(void *context, size_t i) {
    Work *work = context;
    BodyPlan *plan = &work->plans[work->first + i];
    House house = house_alike(work);
    bool *part = memory_zeroed(house.person_count, sizeof *part);
    part[plan->person] = true;
    Profile *profile = own_profile(&house, plan->person);
    profile->width = plan->width;
    profile->length = plan->length;
    profile->axle = fmin(profile->axle, plan->length);
    if (varies(work, &work->house->people[plan->person]))
        journey_suffice(profile); /* each driver's own strength is tested on the way (journey_follow) */
    plan->journeys = journey_plan_briefly(&house, part, 1, work->stop);
    memory_free(part);
    free_alike(&house);
}

static bool holds(const BodyPlan *plan, const Profile *body) {
    return plan->width >= body->width && plan->length >= body->length;
}

/* True if a body can drive a way that was planned for another one. */
static bool can_follow(const Work *work, const BodyPlan *plan, const Profile *body) {
    const Route *route = route_of_plan(plan);
    if (route->answer != ROUTE_FOUND)
        return false;
    if (route->reversals > 0 &&
        (body->width < plan->width - MUCH_NARROWER || body->length < plan->length - MUCH_SHORTER))
        return false;
    if (holds(plan, body))
        return true;
    double ahead = body->length / 2 - body->axle;
    for (size_t p = 0; p < route->count; p++) {
        Vec2 axis = vec2_heading(route->poses[p].heading);
        if (freespace_clearance(&work->house->space, vec2_along(route->poses[p].at, ahead, axis), axis,
                                body->length / 2, body->width / 2, 2 * KEPT, NULL) < KEPT)
            return false;
    }
    return true;
}

/* Returns the index of the plan of a person for a body, which is made later if it is new. */
static size_t plan_for(Work *work, size_t person, double width, double length) {
    for (size_t p = 0; p < work->plan_count; p++)
        if (work->plans[p].person == person && work->plans[p].width == width && work->plans[p].length == length)
            return p;
    work->plans = memory_reserve(work->plans, &work->plan_capacity, work->plan_count + 1, sizeof *work->plans);
    work->plans[work->plan_count] = (BodyPlan){.person = person, .width = width, .length = length};
    return work->plan_count++;
}

/* Returns the index of the plan that a step asks for. */
static size_t ask_for_plan(Work *work, Step step, size_t person, const Profile *body) {
    const Profile *nominal = work->house->people[person].profile;
    double width = body->width, length = body->length;
    switch (step) {
    case STEP_NOMINAL:
        return plan_for(work, person, nominal->width, nominal->length);
    case STEP_CLASS:
        return plan_for(work, person, rounded_up(width, DRIVERS_WIDTH), rounded_up(length, DRIVERS_LENGTH));
    case STEP_SMALLER:
        return plan_for(work, person, rounded_down(width, DRIVERS_WIDTH), rounded_down(length, DRIVERS_LENGTH));
    default:
        return plan_for(work, person, width, length);
    }
}

/* True if what the plan of a step says holds for a driver, be it a way or that there is none. */
static bool is_answer(const Work *work, Step step, const BodyPlan *plan, const Profile *body) {
    switch (step) {
    case STEP_NOMINAL:
        return !varies(work, &work->house->people[plan->person]) || can_follow(work, plan, body);
    case STEP_CLASS:
        return route_of_plan(plan)->answer != ROUTE_CANNOT_PASS;
    case STEP_SMALLER:
        return route_of_plan(plan)->answer != ROUTE_FOUND || can_follow(work, plan, body);
    default:
        return true;
    }
}

/* Returns the body of choice c's driver if it still needs a way, or NULL. */
static const Profile *body_without_way(const Work *work, size_t c) {
    size_t driver = c / work->house->person_count, person = c % work->house->person_count;
    bool needs = takes_part(work, &work->house->people[person]) && !work->choices[c].decided;
    return needs ? work->houses[driver].people[person].profile : NULL;
}

/* Plans the ways of all drivers, a step after the other; the plans of a step at once. */
static void plan_ways(Work *work, int jobs) {
    size_t people = work->house->person_count, count = work->drivers->count * people;
    work->choices = memory_zeroed(count, sizeof *work->choices);
    for (Step step = STEP_NOMINAL; step < STEP_COUNT; step++) {
        const Profile *body;
        work->first = work->plan_count;
        for (size_t c = 0; c < count; c++)
            if ((body = body_without_way(work, c)))
                work->choices[c].plan = ask_for_plan(work, step, c % people, body);
        parallel_for(jobs, work->plan_count - work->first, plan_body, work);
        for (size_t c = 0; c < count; c++)
            if ((body = body_without_way(work, c)))
                work->choices[c].decided = is_answer(work, step, &work->plans[work->choices[c].plan], body);
    }
}

static void free_plans(Work *work) {
    for (size_t p = 0; p < work->plan_count; p++)
        journey_free_all(&work->plans[p].journeys);
    memory_free(work->plans);
    memory_free(work->choices);
}

/* Drivers ---------------------------------------------------------------------------------------------------------*/

DriverPath drivers_path(const Trace *trace, size_t person) {
    DriverPath path = {0};
    size_t capacity = 0;
    Vec2 last = {0};
    for (size_t r = 0; r < trace->rows; r++) {
        const double *row = trace_row(trace, r);
        Vec2 at = vec2(row[TRACE_X], row[TRACE_Y]);
        if ((size_t)row[TRACE_PERSON] != person || (path.count && vec2_distance(at, last) < DRIVERS_STEP))
            continue;
        path.at = memory_reserve(path.at, &capacity, path.count + 1, sizeof *path.at);
        path.at[path.count][0] = (float)at.x;
        path.at[path.count][1] = (float)at.y;
        path.at[path.count++][2] = (float)row[TRACE_SPEED];
        last = at;
    }
    return path;
}

/* Runs the house of driver k on the ways that are planned. */
static void observe_driver(const Work *work, size_t k, Observation *observation) {
    House *house = &work->houses[k];
    Journeys known = {.of = memory_zeroed(house->person_count, sizeof *known.of), .count = house->person_count};
    for (size_t i = 0; i < house->person_count; i++)
        if (takes_part(work, &work->house->people[i]))
            known.of[i].route = *route_of_plan(&work->plans[work->choices[k * house->person_count + i].plan]);
    run_house(observation, house,
              &(RunOptions){.route = work->route, .jobs = 1, .stop = work->stop, .brief = true, .known = &known});
    memory_free(known.of);
}

/* Keeps the touches of a person of driver k. */
static void keep_touches(Drivers *drivers, const Observation *observation, size_t k, size_t person) {
    size_t run = k * drivers->person_count + person, count = 0;
    Touch *touches = memory_zeroed(observation->touch_count, sizeof *touches);
    for (size_t t = 0; t < observation->touch_count; t++)
        if (observation->touches[t].person == person)
            touches[count++] = observation->touches[t];
    drivers->touches[run] = touches;
    drivers->touch_counts[run] = count;
}

static void run_driver(void *context, size_t k) {
    Work *work = context;
    const House *house = &work->houses[k];
    if (stop_requested(work->stop))
        return;
    Observation observation;
    observe_driver(work, k, &observation);
    for (size_t i = 0; i < house->person_count && !observation.interrupted; i++) {
        const PersonObservation *person = &observation.people[i];
        work->drivers->runs[k * house->person_count + i] =
            (DriverRun){.took_part = person->took_part,
                        .varies = person->took_part && varies(work, &work->house->people[i]),
                        .hands = house->people[i].profile->hands > 0,
                        .completed = person->completed,
                        .reason = person->reason,
                        .time = person->time,
                        .contacts = person->contacts,
                        .impact = person->impact,
                        .energy = person->energy,
                        .impact_at = person->impact_at,
                        .part = person->impact_part,
                        .squeeze = person->squeeze,
                        .narrowest = person->narrowest,
                        .back_length = person->back_length};
    }
    for (size_t i = 0; i < house->person_count && !observation.interrupted; i++)
        if (work->drivers->runs[k * house->person_count + i].varies) {
            work->drivers->paths[k * house->person_count + i] = drivers_path(&observation.trace, i);
            keep_touches(work->drivers, &observation, k, i);
        }
    observation_free(&observation);
}

void drivers_run(Drivers *drivers, const House *house, const Population *population, size_t count, size_t route,
                 int jobs, const Stop *stop) {
    *drivers = (Drivers){.count = count, .person_count = house->person_count};
    drivers->runs = memory_zeroed(count * house->person_count, sizeof *drivers->runs);
    drivers->paths = memory_zeroed(count * house->person_count, sizeof *drivers->paths);
    drivers->touches = memory_zeroed(count * house->person_count, sizeof *drivers->touches);
    drivers->touch_counts = memory_zeroed(count * house->person_count, sizeof *drivers->touch_counts);
    Work work = {.house = house,
                 .population = population,
                 .route = route,
                 .stop = stop,
                 .houses = memory_zeroed(count, sizeof *work.houses),
                 .drivers = drivers};
    for (size_t k = 0; k < count; k++)
        work.houses[k] = house_of_driver(&work, k + 1);
    plan_ways(&work, jobs);
    if (!stop_requested(stop))
        parallel_for(jobs, count, run_driver, &work);
    drivers->interrupted = stop_requested(stop);
    for (size_t k = 0; k < count; k++)
        free_alike(&work.houses[k]);
    drivers->plans = work.plan_count;
    free_plans(&work);
    memory_free(work.houses);
}

void drivers_free(Drivers *drivers) {
    for (size_t r = 0; r < drivers->count * drivers->person_count; r++)
        memory_free(drivers->paths[r].at);
    for (size_t r = 0; r < drivers->count * drivers->person_count; r++)
        memory_free(drivers->touches[r]);
    memory_free(drivers->touches);
    memory_free(drivers->touch_counts);
    memory_free(drivers->paths);
    memory_free(drivers->runs);
    *drivers = (Drivers){0};
}

void drivers_run_one(Observation *observation, const House *house, const Population *population, size_t driver,
                     size_t route, const Stop *stop) {
    Drivers drivers = {.count = 1, .person_count = house->person_count};
    House own;
    Work work = {
        .house = house, .population = population, .route = route, .stop = stop, .houses = &own, .drivers = &drivers};
    own = house_of_driver(&work, driver);
    plan_ways(&work, 1);
    observe_driver(&work, 0, observation);
    free_plans(&work);
    free_alike(&own);
}
