#include "laboratory/machine/worker.h"

#include <math.h>
#include <pthread.h>
#include <string.h>
#include <time.h>

#include "base/stopwatch.h"
#include "base/stop.h"
#include "laboratory/urgency.h"

typedef struct Question {
    bool asked;
    double since; /* s, time of the request */
    Stop stop;    /* stops the work on the previous question */
} Question;

struct MachineWorker {
    pthread_t thread;
    pthread_mutex_t lock; /* guards all members that follow except those of the thread alone */
    pthread_cond_t wake;
    bool quit;
    int jobs;
    Question verdict, sweep, follow, map;
    Stop stop_type; /* set by each question */
    const MachineKind *kind;
    Machine machine, map_machine;
    bool maps, map_paused; /* there is a map; it is not shown */
    MachineSweepTask task, follow_task;
    double state[MACHINE_STATES_MOST]; /* (state_count) */
    size_t state_count;
    bool decided, typed; /* the verdict is known, and its type */
    bool confirmed;      /* the verdict needs no confirmation, or it was tried */
    bool deciding;
    MachineNews news;

    /* Used by the thread alone. */
    MachineVerdict own;
    MachineSweep sweeping;
    bool sweeps, swept;
};

static bool is_due(const Question *question, double now) {
    return question->asked && now >= question->since + MACHINE_WORKER_PAUSE;
}

/* Accepts a question. */
static void take_up(Question *question) {
    question->asked = false;
    stop_withdraw(&question->stop);
}

/* True if there is a question, which the type and what comes after it must wait for. */
static bool is_asked(const MachineWorker *worker) {
    return worker->verdict.asked || worker->sweep.asked || worker->follow.asked || worker->map.asked;
}

/* Verdict and type --------------------------------------------------------------------------------------------------*/

/* Publishes a copy of the verdict; the lock must be held. */
static void publish_verdict(MachineWorker *worker) {
    machine_verdict_clear(&worker->news.result);
    worker->news.result = machine_verdict_copy(&worker->own);
    worker->news.verdict = true;
}

/* Computes the verdict; the lock must be held, and is released during the computation. */
static void tell_verdict(MachineWorker *worker) {
    Machine machine = worker->machine;
    take_up(&worker->verdict);
    worker->decided = worker->typed = worker->confirmed = false;
    worker->deciding = true;
    pthread_mutex_unlock(&worker->lock);
    machine_verdict_clear(&worker->own);
    bool decided = machine_verdict_decide(&worker->own, worker->kind, &machine, &worker->verdict.stop);
    pthread_mutex_lock(&worker->lock);
    worker->deciding = false;
    worker->decided = decided && !worker->verdict.asked;
    if (worker->decided)
        publish_verdict(worker);
}

static void note_types(void *context, size_t done, size_t all) {
    MachineWorker *worker = context;
    pthread_mutex_lock(&worker->lock);
    worker->news.types_done = done;
    worker->news.types_all = all;
    pthread_mutex_unlock(&worker->lock);
}

static void tell_type(MachineWorker *worker) {
    stop_withdraw(&worker->stop_type);
    pthread_mutex_unlock(&worker->lock);
    bool typed = machine_verdict_tell_type(&worker->own, worker->jobs, &worker->stop_type, note_types, worker);
    pthread_mutex_lock(&worker->lock);
    worker->news.types_done = worker->news.types_all = 0;
    bool stopped = is_asked(worker) || worker->quit;
    worker->typed = typed || !stopped; /* a type that cannot be determined is not tried again */
    if (typed && !worker->verdict.asked)
        publish_verdict(worker);
}

/* Replaces the quick verdict; the lock must be held, and is released during the computation. */
static void confirm_verdict(MachineWorker *worker) {
    stop_withdraw(&worker->stop_type);
    worker->news.confirming = true;
    pthread_mutex_unlock(&worker->lock);
    bool confirmed = machine_verdict_confirm(&worker->own, worker->jobs, &worker->stop_type);
    pthread_mutex_lock(&worker->lock);
    worker->news.confirming = false;
    worker->confirmed = confirmed || !(is_asked(worker) || worker->quit);
    if (confirmed && !worker->verdict.asked)
        publish_verdict(worker);
}

/* Orbit diagram -----------------------------------------------------------------------------------------------------*/

/* Discards the unpublished points; the lock must be held. */
static void forget_points(MachineWorker *worker) {
    for (int pass = 0; pass < MACHINE_SWEEP_PASSES; pass++)
        machine_sweep_points_clear(&worker->news.points[pass]);
}

static void begin_sweep(MachineWorker *worker) {
    MachineSweepTask task = worker->task;
    take_up(&worker->sweep);
    pthread_mutex_unlock(&worker->lock);
    Fault fault = {0};
    if (worker->sweeps)
        machine_sweep_close(&worker->sweeping);
    worker->sweeps = machine_sweep_open(&worker->sweeping, &task, &fault);
    worker->swept = !worker->sweeps;
    fault_clear(&fault);
    pthread_mutex_lock(&worker->lock);
    forget_points(worker);
    worker->news.swept = worker->news.sweep_begins = true;
    worker->news.sweep_done = 0;
    worker->news.bands = (MachineBands){.count = 0};
    worker->news.bands_all = 0;
    worker->news.sweep_all = machine_sweep_values(&task);
}

static void go_on_sweeping(MachineWorker *worker) {
    MachineSweepPoints points[MACHINE_SWEEP_PASSES] = {{0}};
    pthread_mutex_unlock(&worker->lock);
    worker->swept = !machine_sweep_advance(&worker->sweeping, worker->jobs, &worker->sweep.stop, points);
    pthread_mutex_lock(&worker->lock);
    for (int pass = 0; pass < MACHINE_SWEEP_PASSES; pass++) {
        for (size_t i = 0; i < points[pass].count && !worker->sweep.asked; i++)
            machine_sweep_points_add(&worker->news.points[pass], points[pass].value[i], points[pass].peak[i]);
        machine_sweep_points_clear(&points[pass]);
    }
    if (worker->sweep.asked)
        return;
    worker->news.swept = true;
    worker->news.sweep_done = worker->sweeping.done;
}

/* Following and types along the diagram -----------------------------------------------------------------------------*/

static void follow(MachineWorker *worker) {
    MachineSweepTask task = worker->follow_task;
    double state[MACHINE_STATES_MOST];
    size_t count = worker->state_count;
    MachineLines lines = {.period = 0};
    memcpy(state, worker->state, sizeof state);
    take_up(&worker->follow);
    worker->news.following = true;
    pthread_mutex_unlock(&worker->lock);
    bool whole =
        worker->kind->follow(&task.machine, state, count, task.name, task.from, task.to, &lines, &worker->follow.stop);
    pthread_mutex_lock(&worker->lock);
    worker->news.following = false;
    if (!whole || worker->follow.asked || stop_requested(&worker->follow.stop)) {
        machine_lines_clear(&lines);
        return;
    }
    machine_lines_clear(&worker->news.lines);
    worker->news.lines = lines;
    worker->news.followed = true;
}

static void tell_band(MachineWorker *worker) {
    const MachineSweepTask task = worker->sweeping.task;
    MachineBands *bands = &worker->news.bands;
    bands->step = (task.to - task.from) / (double)worker->kind->bands;
    double value = task.from + ((double)bands->count + 0.5) * bands->step;
    stop_withdraw(&worker->stop_type);
    worker->news.bands_all = worker->kind->bands;
    pthread_mutex_unlock(&worker->lock);
    TypesKind type =
        machine_verdict_type_at(worker->kind, &task.machine, task.name, value, worker->jobs, &worker->stop_type);
    pthread_mutex_lock(&worker->lock);
    if (stop_requested(&worker->stop_type))
        return;
    bands->value[bands->count] = value;
    bands->type[bands->count++] = type >= TYPES_I && type <= TYPES_III ? (double)type : (double)NAN;
    worker->news.bands_all = bands->count < worker->kind->bands ? worker->kind->bands : 0;
    worker->news.banded = true;
}

/* Map ---------------------------------------------------------------------------------------------------------------*/

static void begin_map(MachineWorker *worker) {
    MachineCells *map = &worker->news.map;
    take_up(&worker->map);
    worker->maps = true;
    map->done = 0;
    map->all = machine_map_cells_count(worker->kind);
    for (size_t i = 0; i < MACHINE_MAP_CELLS; i++)
        map->type[i] = NAN;
    worker->news.mapped = true;
}

static void tell_cell(MachineWorker *worker) {
    MachineCells *map = &worker->news.map;
    Machine machine = worker->map_machine;
    size_t cell = machine_map_cells_nth(worker->kind, map->done);
    stop_withdraw(&worker->stop_type);
    pthread_mutex_unlock(&worker->lock);
    TypesKind type = machine_map_cells_type(worker->kind, &machine, cell, worker->jobs, &worker->stop_type);
    pthread_mutex_lock(&worker->lock);
    if (stop_requested(&worker->stop_type) || worker->map.asked)
        return;
    map->type[cell] = type;
    map->done++;
    worker->news.mapped = true;
}

/* The thread --------------------------------------------------------------------------------------------------------*/

static void wait_for_questions(MachineWorker *worker) {
    double until = HUGE_VAL;
    const Question *const questions[] = {&worker->verdict, &worker->sweep, &worker->follow, &worker->map};
    for (size_t q = 0; q < sizeof questions / sizeof *questions; q++)
        if (questions[q]->asked)
            until = fmin(until, questions[q]->since + MACHINE_WORKER_PAUSE);
    if (isinf(until)) {
        pthread_cond_wait(&worker->wake, &worker->lock);
        return;
    }
    struct timespec at = {(time_t)floor(until), (long)(1e9 * (until - floor(until)))};
    pthread_cond_timedwait(&worker->wake, &worker->lock, &at);
}

static bool sweeps(const MachineWorker *worker) {
    return worker->sweeps && !worker->swept && !worker->sweep.asked;
}

static bool wants_cell(const MachineWorker *worker) {
    return worker->maps && !worker->map_paused && worker->news.map.done < worker->news.map.all && !is_asked(worker);
}

static bool wants_type(const MachineWorker *worker) {
    return worker->decided && !worker->typed && !is_asked(worker);
}

static bool wants_confirmation(const MachineWorker *worker) {
    return worker->typed && worker->own.facts.quick && !worker->confirmed && !is_asked(worker);
}

static bool wants_band(const MachineWorker *worker) {
    return worker->sweeps && worker->swept && !is_asked(worker) && worker->news.bands.count < worker->kind->bands;
}

/* Works until the worker is stopped. */
static void *work(void *context) {
    MachineWorker *worker = context;
    urgency_set(URGENCY_ANSWER);
    pthread_mutex_lock(&worker->lock);
    while (!worker->quit) {
        double now = stopwatch_now();
        if (is_due(&worker->verdict, now))
            tell_verdict(worker);
        else if (is_due(&worker->follow, now))
            follow(worker);
        else if (is_due(&worker->sweep, now))
            begin_sweep(worker);
        else if (is_due(&worker->map, now))
            begin_map(worker);
        else if (sweeps(worker) &&
                 (worker->sweeping.done < worker->kind->before_type || !(wants_type(worker) || wants_cell(worker))))
            go_on_sweeping(worker);
        else if (wants_cell(worker))
            tell_cell(worker);
        else if (wants_type(worker))
            tell_type(worker);
        else if (wants_confirmation(worker))
            confirm_verdict(worker);
        else if (wants_band(worker))
            tell_band(worker);
        else
            wait_for_questions(worker);
    }
    pthread_mutex_unlock(&worker->lock);
    return NULL;
}

MachineWorker *machine_worker_start(const MachineKind *kind, int jobs) {
    MachineWorker *worker = memory_zeroed(1, sizeof *worker);
    worker->kind = kind;
    worker->jobs = jobs > 2 ? jobs - 1 : 1;
    pthread_condattr_t monotonic;
    pthread_condattr_init(&monotonic);
    pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
    pthread_cond_init(&worker->wake, &monotonic);
    pthread_condattr_destroy(&monotonic);
    pthread_mutex_init(&worker->lock, NULL);
    if (pthread_create(&worker->thread, NULL, work, worker) == 0)
        return worker;
    worker->quit = true; /* no thread could be started: nothing will be computed */
    return worker;
}

void machine_worker_stop(MachineWorker *worker) {
    pthread_mutex_lock(&worker->lock);
    bool runs = !worker->quit;
    worker->quit = true;
    stop_request(&worker->verdict.stop);
    stop_request(&worker->sweep.stop);
    stop_request(&worker->follow.stop);
    stop_request(&worker->map.stop);
    stop_request(&worker->stop_type);
    pthread_cond_signal(&worker->wake);
    pthread_mutex_unlock(&worker->lock);
    if (runs)
        pthread_join(worker->thread, NULL);
    machine_verdict_clear(&worker->own);
    if (worker->sweeps)
        machine_sweep_close(&worker->sweeping);
    machine_verdict_clear(&worker->news.result);
    machine_lines_clear(&worker->news.lines);
    forget_points(worker);
    pthread_cond_destroy(&worker->wake);
    pthread_mutex_destroy(&worker->lock);
    memory_free(worker);
}

/* Stores a question; the lock must be held. */
static void ask(MachineWorker *worker, Question *question) {
    question->asked = true;
    question->since = stopwatch_now();
    stop_request(&question->stop);
    stop_request(&worker->stop_type);
    pthread_cond_signal(&worker->wake);
}

void machine_worker_ask_verdict(MachineWorker *worker, const Machine *machine) {
    pthread_mutex_lock(&worker->lock);
    worker->machine = *machine;
    ask(worker, &worker->verdict);
    pthread_mutex_unlock(&worker->lock);
}

void machine_worker_ask_sweep(MachineWorker *worker, const MachineSweepTask *task) {
    pthread_mutex_lock(&worker->lock);
    worker->task = *task;
    forget_points(worker);
    worker->news.swept = false;
    ask(worker, &worker->sweep);
    pthread_mutex_unlock(&worker->lock);
}

void machine_worker_ask_follow(MachineWorker *worker, const MachineSweepTask *task, const double *state, size_t count) {
    pthread_mutex_lock(&worker->lock);
    worker->follow_task = *task;
    worker->state_count = count < MACHINE_STATES_MOST ? count : 0;
    if (worker->state_count)
        memcpy(worker->state, state, worker->state_count * sizeof *state);
    ask(worker, &worker->follow);
    worker->follow.since = 0; /* at once: a key asks once */
    pthread_mutex_unlock(&worker->lock);
}

void machine_worker_ask_map(MachineWorker *worker, const Machine *machine) {
    pthread_mutex_lock(&worker->lock);
    worker->map_machine = *machine;
    ask(worker, &worker->map);
    pthread_mutex_unlock(&worker->lock);
}

void machine_worker_pause_map(MachineWorker *worker, bool paused) {
    pthread_mutex_lock(&worker->lock);
    worker->map_paused = paused;
    pthread_cond_signal(&worker->wake);
    pthread_mutex_unlock(&worker->lock);
}

void machine_worker_drop_follow(MachineWorker *worker) {
    pthread_mutex_lock(&worker->lock);
    worker->follow.asked = false;
    stop_request(&worker->follow.stop);
    machine_lines_clear(&worker->news.lines);
    worker->news.followed = false;
    pthread_mutex_unlock(&worker->lock);
}

void machine_worker_take(MachineWorker *worker, MachineNews *news) {
    pthread_mutex_lock(&worker->lock);
    *news = worker->news;
    news->deciding = worker->deciding || worker->verdict.asked;
    news->following = worker->news.following || worker->follow.asked;
    news->map.all = worker->maps && !worker->map_paused && news->map.done < news->map.all ? news->map.all : 0;
    worker->news.verdict = worker->news.swept = worker->news.sweep_begins = false;
    worker->news.followed = worker->news.banded = worker->news.mapped = false;
    worker->news.lines = (MachineLines){.period = 0};
    worker->news.result = (MachineVerdict){.advice = NULL};
    memset(worker->news.points, 0, sizeof worker->news.points);
    pthread_mutex_unlock(&worker->lock);
}
