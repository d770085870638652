#include "house/run.h"

#include <stdint.h>
#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "house/observer.h"
#include "house/replan.h"
#include "house/shake.h"
#include "house/world.h"

/* simulated s between two reports of progress */
static const double LOOK_UP = 0.2;

enum { TEAM_WORTH = 300 /* people: with fewer a step is over before a second thread has begun */ };

/* People who have the house to themselves, and what was seen of them. */
typedef struct Group {
    const House *house;
    const RunOptions *options;
    int jobs;                  /* threads of its own */
    size_t index, count;       /* of all groups */
    bool *part;                /* (person_count) */
    PersonObservation *people; /* of all groups: each writes its own */
    Observer observer;
    size_t told; /* rows of the trace */
    uint64_t digest, steps;
    int wall_crossings;
} Group;

/* When nobody moves any more, chairs that were pushed off their way look round once more. */
static bool goes_on(World *world, Journeys *journeys, const Group *group) {
    if (!world_goes_on(world))
        replan_strays(world, journeys, group->jobs, group->options->stop);
    return world_goes_on(world);
}

/* Hands over what has been recorded since the last time. */
static void tell_piece(Group *group, const World *world, bool over) {
    const Observer *observer = &group->observer;
    uint64_t step = world->clock.step;
    RunPiece piece = {.group = group->index,
                      .group_count = group->count,
                      .house = group->house,
                      .part = group->part,
                      .time = (double)(step - step % observer->sample_steps) * group->house->plan.run.dt,
                      .over = over,
                      .row_count = observer->trace.rows - group->told,
                      .people = group->people,
                      .door_opened = observer->door_opened};
    piece.rows = piece.row_count ? trace_row(&observer->trace, group->told) : NULL;
    group->told = observer->trace.rows;
    group->options->record(group->options->context, &piece);
}

static void look_up(Group *group, const World *world) {
    const RunOptions *options = group->options;
    if (options->progress && group->index == 0)
        options->progress(options->context, clock_time(&world->clock));
    if (options->record)
        tell_piece(group, world, false);
}

static Reason run_world(World *world, Journeys *journeys, Observer *observer, Group *group) {
    const RunOptions *options = group->options;
    double until = world->house->plan.run.until, next_look = 0, next_closing = replan_next(world, 0);
    double next_stray = REPLAN_PERIOD;
    while (goes_on(world, journeys, group)) {
        double time = clock_time(&world->clock);
        if (time >= until)
            return REASON_TIME_LIMIT;
        if (time >= next_closing) {
            replan_journeys(world, journeys, group->jobs, options->stop);
            next_closing = replan_next(world, time);
        }
        if (time >= next_stray) {
            replan_strays(world, journeys, group->jobs, options->stop);
            next_stray += REPLAN_PERIOD;
        }
        if (parallel_stopped(options->stop))
            return REASON_INTERRUPTED;
        if (time >= next_look) {
            next_look += LOOK_UP;
            look_up(group, world);
        }
        WorldStatus status = world_step(world, NULL);
        observer_watch(observer);
        if (status == WORLD_DIVERGED)
            return REASON_INTERRUPTED; /* for the others; the one has a reason of its own */
    }
    return REASON_NONE;
}

static void run_group(void *context, size_t index) {
    Group *group = (Group *)context + index;
    const RunOptions *options = group->options;
    Journeys journeys = journey_plan_all(group->house, group->part, group->jobs, options->stop);
    World world = world_create(group->house, journeys.of, group->part);
    world.team = parallel_team_create(world.present_count > TEAM_WORTH ? group->jobs : 1);
    observer_init(&group->observer, &world, group->people);
    Reason reason = run_world(&world, &journeys, &group->observer, group);
    observer_end(&group->observer, reason);
    if (options->record)
        tell_piece(group, &world, true);
    group->digest = world.digest;
    group->steps = world.clock.step;
    group->wall_crossings = world.wall_crossings;
    group->observer.world = NULL;
    parallel_team_destroy(world.team);
    world_destroy(&world);
    journey_free_all(&journeys);
}

static size_t route_of(const House *house, size_t i) {
    const PlanRoute *route = house->people[i].route;
    return route ? (size_t)(route - house->plan.routes) : house->plan.route_count;
}

static bool is_asked(const RunOptions *options, size_t route) {
    return options->route == SIZE_MAX || route == options->route;
}

/* Somebody on foot who lies under a piece of furniture is in nobody's way. */
static bool lies_under(const Inhabitant *person) {
    return person->under && person->profile->driving == DRIVING_WALKER;
}

static void note_lying(Observation *observation, const House *house, const RunOptions *options) {
    for (size_t i = 0; i < house->person_count; i++)
        if (lies_under(&house->people[i]) && is_asked(options, route_of(house, i)))
            observation->people[i] =
                (PersonObservation){.took_part = true,
                                    .reason = REASON_CANNOT_PASS,
                                    .blockage = shake_route(&house->plan, &house->people[i]).blockage,
                                    .exit = SIZE_MAX,
                                    .narrowest = BODY_SIGHT,
                                    .narrowest_at = house->people[i].at,
                                    .narrowest_other = -1};
}

/* Who is together with whom: everybody, or route by route and then those without one. Returns the number of groups. */
static size_t make_groups(Group *groups, const House *house, const RunOptions *options) {
    size_t routes = house->plan.route_count, count = 0;
    bool alone = house->plan.run.routes == ROUTES_ALONE;
    for (size_t r = 0; r <= (alone ? routes : 0); r++) {
        Group *group = &groups[count];
        bool anybody = false;
        group->part = memory_allocate(house->person_count, sizeof *group->part);
        for (size_t i = 0; i < house->person_count; i++) {
            size_t own = route_of(house, i);
            group->part[i] = (!alone || own == r) && is_asked(options, own) && !lies_under(&house->people[i]);
            anybody |= group->part[i];
        }
        if (anybody)
            count++;
        else
            memory_free(group->part);
    }
    return count;
}

/* Adds a group to the whole: rows, stretches, sums. */
static void merge_group(Observation *observation, Group *group, Stretch **stretches, size_t *count, size_t *capacity) {
    Observer *observer = &group->observer;
    for (size_t r = 0; r < observer->trace.rows; r++)
        trace_add(&observation->trace, trace_row(&observer->trace, r));
    *stretches = memory_reserve(*stretches, capacity, *count + observer->stretch_count, sizeof **stretches);
    if (observer->stretch_count)
        memcpy(*stretches + *count, observer->stretches, observer->stretch_count * sizeof **stretches);
    *count += observer->stretch_count;
    observation->steps = group->steps > observation->steps ? group->steps : observation->steps;
    observation->wall_crossings += group->wall_crossings;
    for (size_t d = 0; d < group->house->plan.door_count; d++)
        observation->door_opened[d] = fmin(observation->door_opened[d], observer->door_opened[d]);
    observation->digest = digest_chain(observation->digest, group->digest);
}

static void conclude(Observation *observation) {
    observation->completed = true;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (!person->took_part)
            continue;
        observation->completed &= person->completed;
        observation->time = fmax(observation->time, person->time);
    }
}

void run_house(Observation *observation, const House *house, const RunOptions *options) {
    Group *groups = memory_allocate(house->plan.route_count + 1, sizeof *groups);
    *observation = (Observation){
        .people = memory_allocate(house->person_count, sizeof *observation->people),
        .person_count = house->person_count,
        .hazards = memory_allocate(HAZARDS_MOST, sizeof *observation->hazards),
        .door_opened = memory_allocate(house->plan.door_count, sizeof *observation->door_opened),
        .dt = house->plan.run.dt,
        .sample = (double)observer_sample_steps(house) * house->plan.run.dt,
    };
    for (size_t d = 0; d < house->plan.door_count; d++)
        observation->door_opened[d] = HUGE_VAL;
    size_t group_count = make_groups(groups, house, options);
    note_lying(observation, house, options);
    for (size_t g = 0; g < group_count; g++) {
        groups[g].index = g;
        groups[g].count = group_count;
        groups[g].house = house;
        groups[g].options = options;
        groups[g].jobs = group_count > 1 ? 1 : options->jobs;
        groups[g].people = observation->people;
    }
    parallel_for(options->jobs, group_count, run_group, groups);
    Stretch *stretches = NULL;
    size_t stretch_count = 0, capacity = 0;
    trace_init(&observation->trace, observation_columns, TRACE_COLUMNS);
    for (size_t g = 0; g < group_count; g++) {
        merge_group(observation, &groups[g], &stretches, &stretch_count, &capacity);
        observer_clear(&groups[g].observer);
        memory_free(groups[g].part);
    }
    observation->hazard_count = hazard_rank(observation->hazards, stretches, stretch_count, house);
    conclude(observation);
    memory_free(stretches);
    memory_free(groups);
}
