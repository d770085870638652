#include "house/run.h"

#include <pthread.h>
#include <stdint.h>
#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "house/observer.h"
#include "house/queue.h"
#include "house/replan.h"
#include "house/shake.h"
#include "house/phase.h"
#include "house/step.h"
#include "house/world.h"

/* s, simulated time between two reports of progress */
static const double LOOK_UP = 0.2;

enum { TEAM_WORTH = 300 /* people: with fewer, a step ends before a second thread has begun */ };

/* The groups of people in each house, the first one or a changed one: changes do not separate people who are already in
 * one world. */
typedef struct Roster {
    const House **houses; /* (house_count) in order */
    size_t **groups;      /* (house_count x people of each) group of each person; SIZE_MAX: takes no part */
    size_t house_count;
    const char **routes; /* (route_count) ids: people of route r are group r, others are group `without` */
    size_t route_count, without;
    bool alone;        /* False: all people are one group, 0 */
    const char *asked; /* only the people of this route take part; NULL: all */
} Roster;

typedef enum GroupStage { GROUP_WAITS, GROUP_PLANNED, GROUP_DRIVES } GroupStage;

/* People who have the house to themselves, and their records. */
typedef struct Group {
    const Roster *roster;
    const RunOptions *options;
    const House *house; /* the present house */
    size_t changes;     /* number of changes applied */
    int jobs;           /* number of threads */
    Fields *fields;     /* shared by all groups */
    GroupStage stage;
    Journeys journeys;         /* from the plan on */
    double length;             /* m, of the chairs' paths together */
    size_t key;                /* index in the roster */
    size_t index, count;       /* index and number of groups */
    bool *part;                /* (person_count of the present house) */
    PersonObservation *people; /* (as many) */
    Observer observer;
    size_t told; /* rows of the trace handed over */
    uint64_t digest, steps;
    int wall_crossings;
    bool interrupted;
    double *changed; /* (change_count) s, time of each change */
} Group;

/* Groups of people that run together ------------------------------------------------------------------------------- */

static size_t group_of_route(Roster *roster, const char *id) {
    for (size_t r = 0; r < roster->route_count; r++)
        if (strcmp(roster->routes[r], id) == 0)
            return r < roster->without ? r : r + 1;
    roster->routes[roster->route_count++] = id;
    return roster->route_count; /* after those of the first house and the group without a route */
}

static bool is_asked(const Roster *roster, const Inhabitant *person) {
    return !roster->asked || (person->route && strcmp(person->route->id, roster->asked) == 0);
}

/* True for a walker who lies under a piece of furniture and obstructs no one. */
static bool lies_under(const Inhabitant *person) {
    return person->under && person->profile->driving == DRIVING_WALKER;
}

/* Returns the group of a person who is new in the house. */
static size_t group_of_newcomer(Roster *roster, const Inhabitant *person) {
    const char *route = person->route ? person->route->id : NULL;
    if (!is_asked(roster, person) || lies_under(person))
        return SIZE_MAX;
    if (!roster->alone)
        return 0;
    return route ? group_of_route(roster, route) : roster->without;
}

static void add_house(Roster *roster, const House *house) {
    size_t h = roster->house_count++;
    roster->houses[h] = house;
    roster->groups[h] = memory_zeroed(house->person_count, sizeof *roster->groups[h]);
    for (size_t i = 0; i < house->person_count; i++) {
        size_t before = h ? house_find_person(roster->houses[h - 1], house->people[i].id) : SIZE_MAX;
        roster->groups[h][i] =
            before == SIZE_MAX ? group_of_newcomer(roster, &house->people[i]) : roster->groups[h - 1][before];
    }
}

static void roster_init(Roster *roster, const House *house, const RunOptions *options) {
    size_t houses = options->change_count + 1, routes = house->plan.route_count;
    *roster = (Roster){.without = routes, .alone = house->plan.run.routes == ROUTES_ALONE};
    if (options->route != SIZE_MAX)
        roster->asked = house->plan.routes[options->route].id;
    for (size_t c = 0; c < options->change_count; c++)
        routes += options->changes[c].house->plan.route_count;
    roster->routes = memory_zeroed(routes, sizeof *roster->routes);
    roster->houses = memory_zeroed(houses, sizeof *roster->houses);
    roster->groups = memory_zeroed(houses, sizeof *roster->groups);
    for (size_t r = 0; r < house->plan.route_count; r++)
        roster->routes[roster->route_count++] = house->plan.routes[r].id;
    add_house(roster, house);
    for (size_t c = 0; c < options->change_count; c++)
        add_house(roster, options->changes[c].house);
}

static void roster_clear(Roster *roster) {
    for (size_t h = 0; h < roster->house_count; h++)
        memory_free(roster->groups[h]);
    memory_free(roster->groups);
    memory_free(roster->houses);
    memory_free(roster->routes);
}

/* Returns the members of the group in a house (person_count). New. */
static bool *part_of(const Roster *roster, size_t house, size_t key) {
    size_t count = roster->houses[house]->person_count;
    bool *part = memory_zeroed(count, sizeof *part);
    for (size_t i = 0; i < count; i++)
        part[i] = roster->groups[house][i] == key;
    return part;
}

static bool has_anybody(const Roster *roster, size_t key) {
    for (size_t h = 0; h < roster->house_count; h++)
        for (size_t i = 0; i < roster->houses[h]->person_count; i++)
            if (roster->groups[h][i] == key)
                return true;
    return false;
}

/* Makes one group of all people, or one per route, then people without a route, then new routes of later houses.
 * Returns their number. */
static size_t make_groups(Group *groups, const Roster *roster, const RunOptions *options, Fields *fields) {
    size_t count = 0;
    for (size_t key = 0; key <= roster->route_count; key++)
        if (has_anybody(roster, key))
            groups[count++].key = key;
    for (size_t g = 0; g < count; g++) {
        Group *group = &groups[g];
        *group = (Group){.roster = roster,
                         .options = options,
                         .house = roster->houses[0],
                         .jobs = count > 1 ? 1 : options->jobs,
                         .fields = fields,
                         .key = group->key,
                         .index = g,
                         .count = count,
                         .part = part_of(roster, 0, group->key),
                         .people = memory_zeroed(roster->houses[0]->person_count, sizeof *group->people),
                         .changed = memory_zeroed(options->change_count, sizeof *group->changed)};
    }
    return count;
}

/* A group's run ---------------------------------------------------------------------------------------------------- */

/* True while people move. When all have stopped, chairs that were pushed off their path plan once more. */
static bool goes_on(World *world, Journeys *journeys, const Group *group) {
    if (!phase_any_active(world))
        replan_strays(world, journeys, group->jobs, group->options->stop);
    return phase_any_active(world);
}

/* Hands over the records since the last call. */
static void tell_piece(Group *group, const World *world, bool over) {
    const Observer *observer = &group->observer;
    uint64_t step = world->clock.step;
    RunPiece piece = {.group = group->index,
                      .group_count = group->count,
                      .house = group->house,
                      .part = group->part,
                      .time = (double)(step - step % observer->sample_steps) * world->clock.dt,
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

static bool is_changing(const Group *group) {
    return group->changes < group->options->change_count;
}

/* Converts the records from the present house to the next. */
static void rename_group(Group *group, const Change *change) {
    PersonObservation *people = memory_zeroed(change->to->person_count, sizeof *people);
    observer_rename(&group->observer, change, people);
    memory_free(group->people);
    memory_free(group->part);
    group->people = people;
    group->changes++;
    group->house = change->to;
    group->part = part_of(group->roster, group->changes, group->key);
    group->told = group->observer.trace.rows;
}

static void apply_change(Group *group, World *world, Journeys *journeys) {
    Change change;
    change_init(&change, group->house, group->options->changes[group->changes].house);
    observer_catch_up(&group->observer);
    if (group->options->record)
        tell_piece(group, world, false);
    group->changed[group->changes] = clock_time(&world->clock);
    rename_group(group, &change);
    change_world(world, journeys, &change, group->part, group->jobs, group->options->stop);
    observer_resume(&group->observer);
    change_clear(&change);
}

static Reason run_world(World *world, Journeys *journeys, Observer *observer, Group *group) {
    const RunOptions *options = group->options;
    double next_look = 0, next_closing = replan_next(world, 0), next_stray = REPLAN_PERIOD;
    while (goes_on(world, journeys, group) || is_changing(group)) {
        double time = clock_time(&world->clock);
        if (time >= world->house->plan.run.until)
            return REASON_TIME_LIMIT;
        if (is_changing(group) && time >= options->changes[group->changes].time) {
            apply_change(group, world, journeys);
            next_closing = replan_next(world, time);
            continue;
        }
        if (time >= next_closing) {
            replan_journeys(world, journeys, group->jobs, options->stop);
            next_closing = replan_next(world, time);
        }
        if (time >= next_look) { /* before what takes long */
            next_look += LOOK_UP;
            look_up(group, world);
        }
        if (time >= next_stray) {
            replan_strays(world, journeys, group->jobs, options->stop);
            queue_weigh(world, journeys, group->jobs, options->stop);
            next_stray += REPLAN_PERIOD;
        }
        if (stop_requested(options->stop))
            return REASON_INTERRUPTED;
        StepStatus status = step_world(world, NULL);
        observer_watch(observer);
        if (status == STEP_DIVERGED)
            return REASON_OTHER_DIVERGED; /* the diverged person has a reason already */
    }
    return REASON_NONE;
}

static void plan_group(Group *group) {
    const RunOptions *options = group->options;
    group->journeys = options->known
                          ? journey_follow(options->known, group->house, group->part, group->jobs, options->stop)
                          : journey_plan_recalling(group->house, group->part, options->brief, options->recall,
                                                   group->fields, group->jobs, options->stop);
    for (size_t i = 0; i < group->journeys.count; i++)
        group->length += group->journeys.of[i].track.length;
}

static void drive_group(Group *group) {
    const RunOptions *options = group->options;
    Journeys *journeys = &group->journeys;
    World world = world_create(group->house, journeys->of, group->part);
    world.team = parallel_team_create(world.present_count > TEAM_WORTH ? group->jobs : 1);
    observer_init(&group->observer, &world, group->people);
    Reason reason = run_world(&world, journeys, &group->observer, group);
    group->interrupted = stop_requested(options->stop);
    observer_end(&group->observer, group->interrupted ? REASON_INTERRUPTED : reason);
    if (options->record)
        tell_piece(group, &world, true);
    group->digest = world.digest;
    group->steps = world.clock.step;
    group->wall_crossings = world.wall_crossings;
    group->observer.world = NULL;
    parallel_team_destroy(world.team);
    world_destroy(&world);
    journey_free_all(journeys);
}

/* The tasks of all groups: their plans, then their drives as they are planned, the longest first, so that no thread has
 * a long one left when the others have ended. */
typedef struct Tasks {
    Group *groups; /* (count) */
    size_t *order; /* (count) indices of the groups, as they are planned */
    size_t count;
    pthread_mutex_t mutex;
    pthread_cond_t planned;
} Tasks;

/* Returns the planned group with the longest ways whose drive has not begun; NULL: none is planned. */
static Group *find_longest(const Tasks *tasks) {
    Group *longest = NULL;
    for (size_t g = 0; g < tasks->count; g++) {
        Group *group = &tasks->groups[g];
        if (group->stage == GROUP_PLANNED && (!longest || group->length > longest->length))
            longest = group;
    }
    return longest;
}

/* Plans or drives one group. All plans are begun before the first drive, so that a drive can wait for one. */
static void do_task(void *context, size_t index) {
    Tasks *tasks = context;
    Group *planning = index < tasks->count ? &tasks->groups[tasks->order[index]] : NULL;
    if (planning)
        plan_group(planning);
    pthread_mutex_lock(&tasks->mutex);
    Group *group = NULL;
    if (planning) {
        planning->stage = GROUP_PLANNED;
        pthread_cond_broadcast(&tasks->planned);
    } else {
        while (!(group = find_longest(tasks)))
            pthread_cond_wait(&tasks->planned, &tasks->mutex);
        group->stage = GROUP_DRIVES;
    }
    pthread_mutex_unlock(&tasks->mutex);
    if (group)
        drive_group(group);
}

/* Orders the plans: first one of each sense, so that threads do not wait for the same frame. New. */
static size_t *order_plans(const Group *groups, size_t count) {
    size_t *order = memory_zeroed(count, sizeof *order), ordered = 0;
    bool *first = memory_zeroed(count, sizeof *first), begun[FRAME_SENSES] = {false};
    for (size_t g = 0; g < count; g++) {
        int sense = journey_sense(groups[g].house, groups[g].part);
        first[g] = sense < 0 || !begun[sense];
        if (sense >= 0)
            begun[sense] = true;
    }
    for (int rest = 0; rest < 2; rest++)
        for (size_t g = 0; g < count; g++)
            if (first[g] == !rest)
                order[ordered++] = g;
    memory_free(first);
    return order;
}

static void run_groups(Group *groups, size_t count, int jobs) {
    Tasks tasks = {.groups = groups, .order = order_plans(groups, count), .count = count};
    pthread_mutex_init(&tasks.mutex, NULL);
    pthread_cond_init(&tasks.planned, NULL);
    parallel_for(jobs, 2 * count, do_task, &tasks);
    pthread_cond_destroy(&tasks.planned);
    pthread_mutex_destroy(&tasks.mutex);
    memory_free(tasks.order);
}

/* The whole -------------------------------------------------------------------------------------------------------- */

/* Adds a group to the observation: rows, stretches, sums. */
static void merge_group(Observation *observation, Group *group, Stretch **stretches, size_t *count, size_t *capacity,
                        size_t *touch_capacity) {
    Observer *observer = &group->observer;
    for (size_t r = 0; r < observer->trace.rows; r++)
        trace_add(&observation->trace, trace_row(&observer->trace, r));
    *stretches = memory_reserve(*stretches, capacity, *count + observer->stretch_count, sizeof **stretches);
    if (observer->stretch_count)
        memcpy(*stretches + *count, observer->stretches, observer->stretch_count * sizeof **stretches);
    *count += observer->stretch_count;
    for (size_t t = 0; t < observer->touch_count; t++) {
        Touch touch = observer->touches[t];
        observation->touches = memory_reserve(observation->touches, touch_capacity, observation->touch_count + 1,
                                              sizeof *observation->touches);
        observation->touches[observation->touch_count++] = touch;
    }
    observation->steps = group->steps > observation->steps ? group->steps : observation->steps;
    observation->wall_crossings += group->wall_crossings;
    observation->interrupted |= group->interrupted;
    for (size_t i = 0; i < group->house->person_count; i++)
        if (group->part[i])
            observation->people[i] = group->people[i];
    for (size_t d = 0; d < group->house->plan.door_count; d++)
        observation->door_opened[d] = fmin(observation->door_opened[d], observer->door_opened[d]);
    observation->digest = digest_chain(observation->digest, group->digest);
    for (size_t c = 0; c < observation->mixed_count; c++)
        observation->mixed[c] = fmax(observation->mixed[c], group->changed[c]);
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

/* Returns the largest number of changes applied to a group. The records of every group are converted to the last house,
 * even if its run ended before that change. */
static size_t change_the_rest(Group *groups, size_t count, const RunOptions *options) {
    size_t most = 0;
    for (size_t g = 0; g < count; g++) {
        most = groups[g].changes > most ? groups[g].changes : most;
        while (groups[g].changes < options->change_count) {
            Change change;
            change_init(&change, groups[g].house, options->changes[groups[g].changes].house);
            rename_group(&groups[g], &change);
            change_clear(&change);
        }
    }
    return most;
}

static void clear_group(Group *group) {
    observer_clear(&group->observer);
    memory_free(group->part);
    memory_free(group->people);
    memory_free(group->changed);
}

/* Returns an empty observation of a house. */
static Observation blank(const House *house) {
    Observation observation = {
        .people = memory_zeroed(house->person_count, sizeof *observation.people),
        .person_count = house->person_count,
        .hazards = memory_zeroed(HAZARDS_MOST, sizeof *observation.hazards),
        .door_opened = memory_zeroed(house->plan.door_count, sizeof *observation.door_opened),
    };
    for (size_t d = 0; d < house->plan.door_count; d++)
        observation.door_opened[d] = HUGE_VAL;
    trace_init(&observation.trace, observation_columns, TRACE_COLUMNS);
    return observation;
}

static void note_lying(Observation *observation, const House *house, const Roster *roster) {
    for (size_t i = 0; i < house->person_count; i++)
        if (lies_under(&house->people[i]) && is_asked(roster, &house->people[i]))
            observation->people[i] =
                (PersonObservation){.took_part = true,
                                    .reason = REASON_CANNOT_PASS,
                                    .blockage = shake_route(&house->plan, &house->people[i]).blockage,
                                    .exit = SIZE_MAX,
                                    .narrowest = BODY_SIGHT,
                                    .narrowest_at = house->people[i].at,
                                    .narrowest_other = -1};
}

void run_house(Observation *observation, const House *house, const RunOptions *options) {
    Roster roster;
    roster_init(&roster, house, options);
    Group *groups = memory_zeroed(roster.route_count + 1, sizeof *groups);
    Fields *fields = fields_create();
    size_t group_count = make_groups(groups, &roster, options, fields);
    run_groups(groups, group_count, options->jobs);
    fields_destroy(fields);
    size_t changes = change_the_rest(groups, group_count, options);
    const House *last = roster.houses[options->change_count];
    *observation = blank(last);
    observation->dt = house->plan.run.dt;
    observation->sample = (double)observer_sample_steps(house) * house->plan.run.dt;
    note_lying(observation, last, &roster);
    observation->mixed = memory_zeroed(changes, sizeof *observation->mixed);
    observation->mixed_count = changes;
    Stretch *stretches = NULL;
    size_t stretch_count = 0, capacity = 0, touch_capacity = 0;
    for (size_t g = 0; g < group_count; g++) {
        merge_group(observation, &groups[g], &stretches, &stretch_count, &capacity, &touch_capacity);
        clear_group(&groups[g]);
    }
    observation->hazard_count = hazard_rank(observation->hazards, stretches, stretch_count, last);
    conclude(observation);
    memory_free(stretches);
    memory_free(groups);
    roster_clear(&roster);
}
