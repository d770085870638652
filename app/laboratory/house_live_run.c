#include "laboratory/house_live_run.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/parallel.h"
#include "house/observer.h"
#include "house/run.h"
#include "laboratory/route_scene.h"

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

HouseRun *house_live_run_create(const HouseWish *wish) {
    HouseRun *run = memory_allocate(1, sizeof *run);
    run->wish = *wish;
    run->wish.path = arena_text(&run->arena, wish->path);
    run->wish.profiles = arena_text(&run->arena, wish->profiles);
    run->wish.route = wish->route ? arena_text(&run->arena, wish->route) : NULL;
    run->wish.text = arena_text(&run->arena, wish->text);
    pthread_mutex_init(&run->mutex, NULL);
    return run;
}

void house_live_run_destroy(HouseRun *run) {
    observation_free(&run->observation);
    scene_clear(&run->ways);
    house_free(&run->house);
    fault_clear(&run->fault);
    trace_clear(&run->fresh);
    memory_free(run->reach);
    memory_free(run->people);
    memory_free(run->door_opened);
    pthread_mutex_destroy(&run->mutex);
    arena_clear(&run->arena);
    memory_free(run);
}

static void enter(HouseRun *run, HouseStage stage) {
    pthread_mutex_lock(&run->mutex);
    run->stage = stage;
    if (stage == HOUSE_READS)
        run->begun = now();
    pthread_mutex_unlock(&run->mutex);
}

/* Making it ------------------------------------------------------------------------------------------------------- */

static void take_piece(void *context, const RunPiece *piece) {
    HouseRun *run = context;
    pthread_mutex_lock(&run->mutex);
    if (!run->group_count) {
        run->group_count = piece->group_count;
        run->reach = memory_allocate(piece->group_count, sizeof *run->reach);
        run->stage = HOUSE_DRIVES;
    }
    for (size_t r = 0; r < piece->row_count; r++)
        trace_add(&run->fresh, piece->rows + r * TRACE_COLUMNS);
    run->reach[piece->group] = piece->over ? HUGE_VAL : piece->time;
    for (size_t i = 0; i < run->house.person_count; i++)
        if (piece->part[i])
            run->people[i] = piece->people[i];
    for (size_t d = 0; d < run->house.plan.door_count; d++)
        run->door_opened[d] = fmin(run->door_opened[d], piece->door_opened[d]);
    pthread_mutex_unlock(&run->mutex);
}

/* What comes piece by piece has somewhere to go. */
static void make_room(HouseRun *run) {
    Observation empty = house_live_run_begin(run);
    run->people = empty.people;
    run->door_opened = empty.door_opened;
    run->fresh = empty.trace;
}

static void drive(HouseRun *run) {
    size_t route = run->wish.route ? plan_find_route(&run->house.plan, run->wish.route) : SIZE_MAX;
    RunOptions how = {.route = route, .jobs = run->wish.jobs, .stop = &run->stop, .record = take_piece, .context = run};
    run_house(&run->observation, &run->house, &how);
}

static void make_ways(HouseRun *run) {
    Observation all = house_live_run_begin(run);
    route_scene_add(&run->ways, &run->house, &all, true, true, &run->stop);
    observation_free(&all);
}

void house_live_run_make(HouseRun *run) {
    HouseOptions options = {.profiles = run->wish.profiles, .seed = run->wish.seed, .driving = run->wish.driving};
    enter(run, HOUSE_READS);
    if (!house_read_text(&run->house, run->wish.path, run->wish.text, &options, &run->fault)) {
        enter(run, HOUSE_FAILED);
        return;
    }
    make_room(run);
    enter(run, HOUSE_PLANS);
    if (run->wish.job == HOUSE_JOB_WAYS)
        make_ways(run);
    else
        drive(run);
    enter(run, parallel_stopped(&run->stop) ? HOUSE_STOPPED : HOUSE_OVER);
}

/* Watching it ----------------------------------------------------------------------------------------------------- */

HouseStage house_live_run_stage(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    HouseStage stage = run->stage;
    pthread_mutex_unlock(&run->mutex);
    return stage;
}

double house_live_run_age(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    double age = run->begun > 0 ? now() - run->begun : 0;
    pthread_mutex_unlock(&run->mutex);
    return age;
}

/* The mutex is locked. */
static double reach_of(const HouseRun *run) {
    double least = HUGE_VAL, most = 0;
    for (size_t g = 0; g < run->group_count; g++) {
        least = fmin(least, run->reach[g]);
        most = fmax(most, isfinite(run->reach[g]) ? run->reach[g] : 0);
    }
    return isfinite(least) ? least : most;
}

double house_live_run_reach(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    double reach = reach_of(run);
    pthread_mutex_unlock(&run->mutex);
    return reach;
}

bool house_live_run_say(HouseRun *run, const char *who, char *words, size_t size) {
    switch (house_live_run_stage(run)) {
    case HOUSE_WAITS:
    case HOUSE_READS:
        snprintf(words, size, "%sreading the house", who);
        return true;
    case HOUSE_PLANS:
        snprintf(words, size, "%splanning the ways", who);
        return true;
    case HOUSE_DRIVES:
        snprintf(words, size, "%scomputed %.1f s", who, house_live_run_reach(run));
        return true;
    case HOUSE_OVER:
    case HOUSE_FAILED:
    case HOUSE_STOPPED:
        break;
    }
    return false;
}

Observation house_live_run_begin(const HouseRun *run) {
    const House *house = &run->house;
    Observation growing = {.people = memory_allocate(house->person_count, sizeof *growing.people),
                           .person_count = house->person_count,
                           .door_opened = memory_allocate(house->plan.door_count, sizeof *growing.door_opened),
                           .dt = house->plan.run.dt,
                           .sample = (double)observer_sample_steps(house) * house->plan.run.dt};
    trace_init(&growing.trace, observation_columns, TRACE_COLUMNS);
    for (size_t i = 0; i < house->person_count; i++) {
        const PlanRoute *route = house->people[i].route;
        growing.people[i] =
            (PersonObservation){.took_part = !run->wish.route || (route && strcmp(route->id, run->wish.route) == 0),
                                .exit = SIZE_MAX,
                                .narrowest = HUGE_VAL,
                                .narrowest_other = -1};
    }
    for (size_t d = 0; d < house->plan.door_count; d++)
        growing.door_opened[d] = HUGE_VAL;
    return growing;
}

size_t house_live_run_take(HouseRun *run, Observation *growing, size_t least) {
    pthread_mutex_lock(&run->mutex);
    size_t rows = run->fresh.rows;
    if (rows >= least && rows) {
        for (size_t r = 0; r < rows; r++)
            trace_add(&growing->trace, trace_row(&run->fresh, r));
        trace_clear(&run->fresh);
        trace_init(&run->fresh, observation_columns, TRACE_COLUMNS);
        memcpy(growing->people, run->people, growing->person_count * sizeof *growing->people);
        memcpy(growing->door_opened, run->door_opened, run->house.plan.door_count * sizeof *growing->door_opened);
        growing->time = reach_of(run);
    } else {
        rows = 0;
    }
    pthread_mutex_unlock(&run->mutex);
    return rows;
}
