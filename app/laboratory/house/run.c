#include "laboratory/house/run.h"

#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/stop.h"
#include "house/observer.h"
#include "house/run.h"
#include "visual/house/route_scene.h"

HouseRun *house_run_create(const HouseWish *wish) {
    HouseRun *run = memory_zeroed(1, sizeof *run);
    run->wish = *wish;
    run->wish.path = arena_text(&run->arena, wish->path);
    run->wish.profiles = arena_text(&run->arena, wish->profiles);
    run->wish.route = wish->route ? arena_text(&run->arena, wish->route) : NULL;
    const char **settings = arena_allocate(&run->arena, (wish->setting_count + 1) * sizeof *settings);
    for (size_t i = 0; i < wish->setting_count; i++)
        settings[i] = arena_text(&run->arena, wish->settings[i]);
    run->wish.settings = settings;
    run->wish.epochs = house_history_copy(wish->epochs, wish->epoch_count, &run->arena);
    run->earlier = memory_zeroed(wish->epoch_count, sizeof *run->earlier);
    pthread_mutex_init(&run->mutex, NULL);
    return run;
}

void house_run_destroy(HouseRun *run) {
    observation_free(&run->observation);
    scene_clear(&run->routes);
    memory_free(run->grades);
    for (int step = 0; step < CREW_STEPS; step++)
        crew_clear(&run->crews[step]);
    for (int step = 0; step < OUTLOOK_STEPS; step++)
        outlook_clear(&run->outlooks[step]);
    house_free(&run->house);
    for (size_t i = 0; i + 1 < run->wish.epoch_count; i++)
        house_free(&run->earlier[i]);
    memory_free(run->earlier);
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
        run->begun = stopwatch_now();
    pthread_mutex_unlock(&run->mutex);
}

/* Computing a run ------------------------------------------------------------------------------------------------- */

/* Finds a person of the piece's house among the people of the last house; SIZE_MAX: not found. */
static size_t place_of(const HouseRun *run, const RunPiece *piece, size_t person) {
    return piece->house == &run->house ? person : house_find_person(&run->house, piece->house->people[person].id);
}

static void take_rows(HouseRun *run, const RunPiece *piece) {
    double row[TRACE_COLUMNS];
    for (size_t r = 0; r < piece->row_count; r++) {
        memcpy(row, piece->rows + r * TRACE_COLUMNS, sizeof row);
        size_t place = place_of(run, piece, (size_t)row[TRACE_PERSON]);
        row[TRACE_PERSON] = (double)place;
        if (place != SIZE_MAX)
            trace_add(&run->fresh, row);
    }
}

/* Removes the widths that a brief run has only estimated: the complete search may find others. */
static void forget_needs(PersonObservation *people, size_t count) {
    for (size_t i = 0; i < count; i++)
        people[i].blockage.needs = 0;
}

static void take_piece(void *context, const RunPiece *piece) {
    HouseRun *run = context;
    pthread_mutex_lock(&run->mutex);
    if (!run->group_count) {
        run->group_count = piece->group_count;
        run->reach = memory_zeroed(piece->group_count, sizeof *run->reach);
        run->stage = HOUSE_DRIVES;
    }
    take_rows(run, piece);
    run->reach[piece->group] = piece->over ? HUGE_VAL : piece->time;
    for (size_t i = 0; i < piece->house->person_count; i++) {
        size_t place = piece->part[i] ? place_of(run, piece, i) : SIZE_MAX;
        if (place != SIZE_MAX)
            run->people[place] = piece->people[i];
        if (place != SIZE_MAX && run->wish.brief)
            forget_needs(&run->people[place], 1);
    }
    for (size_t d = 0; piece->house == &run->house && d < run->house.plan.door_count; d++)
        run->door_opened[d] = fmin(run->door_opened[d], piece->door_opened[d]);
    pthread_mutex_unlock(&run->mutex);
}

/* Allocates the record into which rows are added while the run is computed. */
static void make_room(HouseRun *run) {
    Observation empty = house_run_begin(run);
    run->people = empty.people;
    run->door_opened = empty.door_opened;
    run->fresh = empty.trace;
}

static void drive(HouseRun *run) {
    size_t earlier = run->wish.epoch_count - 1;
    RunChange *changes = memory_zeroed(earlier + 1, sizeof *changes);
    for (size_t i = 0; i < earlier; i++)
        changes[i] = (RunChange){run->wish.epochs[i + 1].time, i + 1 < earlier ? &run->earlier[i + 1] : &run->house};
    const House *first = earlier ? &run->earlier[0] : &run->house;
    size_t route = run->wish.route ? plan_find_route(&first->plan, run->wish.route) : SIZE_MAX;
    RunOptions how = {.route = route,
                      .jobs = run->wish.jobs,
                      .stop = &run->stop,
                      .record = take_piece,
                      .context = run,
                      .brief = run->wish.brief,
                      .recall = run->wish.recall,
                      .changes = changes,
                      .change_count = earlier};
    run_house(&run->observation, first, &how);
    if (run->wish.brief)
        forget_needs(run->observation.people, run->observation.person_count);
    memory_free(changes);
}

static void make_routes(HouseRun *run) {
    Observation all = house_run_begin(run);
    route_scene_add(&run->routes, &run->house, &all, true, true, &run->stop);
    observation_free(&all);
}

/* Grades the people of the wanted route. */
static void make_grades(HouseRun *run) {
    const House *house = &run->house;
    bool *part = memory_zeroed(house->person_count, sizeof *part);
    run->grades = memory_zeroed(house->person_count, sizeof *run->grades);
    for (size_t i = 0; i < house->person_count; i++) {
        const PlanRoute *route = house->people[i].route;
        part[i] = !run->wish.route || (route && strcmp(route->id, run->wish.route) == 0);
    }
    grade_all_letters(run->grades, house, part, run->wish.jobs, &run->stop);
    memory_free(part);
}

static void make_crews(HouseRun *run) {
    const HouseWish *wish = &run->wish;
    size_t route = wish->route ? plan_find_route(&run->house.plan, wish->route) : SIZE_MAX;
    for (int step = 0; step < CREW_STEPS; step++) {
        if (!crew_make(&run->crews[step], step, &run->house, route, wish->jobs, &run->stop, &run->fault))
            return;
        pthread_mutex_lock(&run->mutex);
        run->crew_count = step + 1;
        pthread_mutex_unlock(&run->mutex);
    }
}

static HouseOptions options_of(const HouseWish *wish) {
    return (HouseOptions){.profiles = wish->profiles,
                          .settings = wish->settings,
                          .setting_count = wish->setting_count,
                          .seed = wish->seed,
                          .driving = wish->driving};
}

static void make_outlooks(HouseRun *run) {
    const HouseWish *wish = &run->wish;
    const HouseOptions options = options_of(wish);
    for (int step = 0; step < OUTLOOK_STEPS; step++) {
        if (!outlook_make(&run->outlooks[step], step, wish->path, wish->epochs[0].text, &options, wish->route,
                          wish->jobs, &run->stop, &run->fault))
            return;
        pthread_mutex_lock(&run->mutex);
        run->outlook_count = step + 1;
        pthread_mutex_unlock(&run->mutex);
    }
}

/* Reads the houses of all epochs. */
static bool read_houses(HouseRun *run) {
    const HouseWish *wish = &run->wish;
    const HouseOptions options = options_of(wish);
    bool good = true;
    for (size_t i = 0; good && i < wish->epoch_count; i++) {
        House *house = i + 1 < wish->epoch_count ? &run->earlier[i] : &run->house;
        good = house_read_text(house, wish->path, wish->epochs[i].text, &options, &run->fault);
    }
    return good;
}

void house_run_make(HouseRun *run) {
    enter(run, HOUSE_READS);
    if (!read_houses(run)) {
        enter(run, HOUSE_FAILED);
        return;
    }
    make_room(run);
    enter(run, HOUSE_PLANS);
    if (run->wish.job == HOUSE_JOB_ROUTES)
        make_routes(run);
    else if (run->wish.job == HOUSE_JOB_GRADES)
        make_grades(run);
    else if (run->wish.job == HOUSE_JOB_CREW)
        make_crews(run);
    else if (run->wish.job == HOUSE_JOB_SHAKES)
        make_outlooks(run);
    else
        drive(run);
    enter(run, stop_requested(&run->stop) ? HOUSE_STOPPED : HOUSE_OVER);
}

size_t house_run_epoch(const HouseRun *run, double time) {
    size_t epoch = run->wish.epoch_count - 1;
    while (epoch && time < run->wish.epochs[epoch].time)
        epoch--;
    return epoch;
}

bool house_run_alike(const House *a, const House *b) {
    bool same = a->person_count == b->person_count && a->plan.exit_count == b->plan.exit_count;
    for (size_t i = 0; same && i < a->person_count; i++)
        same = strcmp(a->people[i].id, b->people[i].id) == 0;
    for (size_t e = 0; same && e < a->plan.exit_count; e++)
        same = strcmp(a->plan.exits[e].id, b->plan.exits[e].id) == 0;
    return same;
}

const House *house_run_house(const HouseRun *run, size_t epoch) {
    const House *last = &run->house, *house = epoch + 1 < run->wish.epoch_count ? &run->earlier[epoch] : last;
    return house_run_alike(house, last) ? house : last;
}

/* Watching a run -------------------------------------------------------------------------------------------------- */

HouseStage house_run_stage(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    HouseStage stage = run->stage;
    pthread_mutex_unlock(&run->mutex);
    return stage;
}

double house_run_age(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    double age = run->begun > 0 ? stopwatch_now() - run->begun : 0;
    pthread_mutex_unlock(&run->mutex);
    return age;
}

const Crew *house_run_crew(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    const Crew *crew = run->crew_count ? &run->crews[run->crew_count - 1] : NULL;
    pthread_mutex_unlock(&run->mutex);
    return crew;
}

const Outlook *house_run_outlook(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    const Outlook *outlook = run->outlook_count ? &run->outlooks[run->outlook_count - 1] : NULL;
    pthread_mutex_unlock(&run->mutex);
    return outlook;
}

/* Returns the time up to which all groups are recorded, s. The mutex must be locked. */
static double reach_of(const HouseRun *run) {
    double least = HUGE_VAL, most = 0;
    for (size_t g = 0; g < run->group_count; g++) {
        least = fmin(least, run->reach[g]);
        most = fmax(most, isfinite(run->reach[g]) ? run->reach[g] : 0);
    }
    return isfinite(least) ? least : most;
}

double house_run_reach(HouseRun *run) {
    pthread_mutex_lock(&run->mutex);
    double reach = reach_of(run);
    pthread_mutex_unlock(&run->mutex);
    return reach;
}

bool house_run_describe(HouseRun *run, const char *model, char *text, size_t size) {
    char progress[64] = "";
    switch (house_run_stage(run)) {
    case HOUSE_WAITS:
    case HOUSE_READS:
        snprintf(progress, sizeof progress, "reading the house");
        break;
    case HOUSE_PLANS:
        snprintf(progress, sizeof progress, "planning the routes");
        break;
    case HOUSE_DRIVES:
        snprintf(progress, sizeof progress, "computed %.1f s", house_run_reach(run));
        break;
    case HOUSE_OVER:
    case HOUSE_FAILED:
    case HOUSE_STOPPED:
        return false;
    }
    if (model)
        snprintf(text, size, "%s: %s", model, progress);
    else
        snprintf(text, size, "%s", progress);
    return true;
}

Observation house_run_begin(const HouseRun *run) {
    const House *house = &run->house;
    Observation growing = {.people = memory_zeroed(house->person_count, sizeof *growing.people),
                           .person_count = house->person_count,
                           .door_opened = memory_zeroed(house->plan.door_count, sizeof *growing.door_opened),
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

size_t house_run_copy_rows(HouseRun *run, Observation *growing, size_t least) {
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
