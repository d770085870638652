#include "laboratory/beam/worker.h"

#include <math.h>
#include <pthread.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

#include "base/stopwatch.h"
#include "base/stop.h"

enum {
    GIVES_WAY = 10, /* nice value of the thread */
    COARSE = 121, /* values of the orbit diagram that are computed before the type; the others follow after the type */
};

typedef struct Question {
    bool asked;
    double since; /* s, time of the request */
    Stop stop;    /* stops the work on the previous question */
} Question;

struct BeamWorker {
    pthread_t thread;
    pthread_mutex_t lock; /* guards all members that follow except those of the thread alone */
    pthread_cond_t wake;
    bool quit;
    int jobs;
    Question verdict, sweep;
    Stop stop_type; /* set by either question */
    Beam beam;
    BeamSweepTask task;
    bool decided, typed; /* the verdict is known, and its type */
    bool deciding;
    BeamNews news;

    /* Used by the thread alone. */
    BeamVerdict own;
    BeamSweep sweeping;
    bool sweeps, swept;
};

static bool is_due(const Question *question, double now) {
    return question->asked && now >= question->since + BEAM_WORKER_PAUSE;
}

/* Accepts a question. */
static void take_up(Question *question) {
    question->asked = false;
    stop_withdraw(&question->stop);
}

/* Verdict and type --------------------------------------------------------------------------------------------------*/

/* Publishes a copy of the verdict; the lock must be held. */
static void publish_verdict(BeamWorker *worker) {
    beam_verdict_clear(&worker->news.result);
    worker->news.result = beam_verdict_copy(&worker->own);
    worker->news.verdict = true;
}

/* Computes the verdict; the lock must be held, and is released during the computation. */
static void tell_verdict(BeamWorker *worker) {
    Beam beam = worker->beam;
    take_up(&worker->verdict);
    worker->decided = worker->typed = false;
    worker->deciding = true;
    pthread_mutex_unlock(&worker->lock);
    beam_verdict_clear(&worker->own);
    bool decided = beam_verdict_decide(&worker->own, &beam, &worker->verdict.stop);
    pthread_mutex_lock(&worker->lock);
    worker->deciding = false;
    worker->decided = decided && !worker->verdict.asked;
    if (worker->decided)
        publish_verdict(worker);
}

static void note_types(void *context, size_t done, size_t all) {
    BeamWorker *worker = context;
    pthread_mutex_lock(&worker->lock);
    worker->news.types_done = done;
    worker->news.types_all = all;
    pthread_mutex_unlock(&worker->lock);
}

static void tell_type(BeamWorker *worker) {
    stop_withdraw(&worker->stop_type);
    pthread_mutex_unlock(&worker->lock);
    bool typed = beam_verdict_tell_type(&worker->own, worker->jobs, &worker->stop_type, note_types, worker);
    pthread_mutex_lock(&worker->lock);
    worker->news.types_done = worker->news.types_all = 0;
    bool stopped = worker->verdict.asked || worker->sweep.asked || worker->quit;
    worker->typed = typed || !stopped; /* a type that cannot be determined is not tried again */
    if (typed && !worker->verdict.asked)
        publish_verdict(worker);
}

/* Orbit diagram -----------------------------------------------------------------------------------------------------*/

/* Discards the unpublished points; the lock must be held. */
static void forget_points(BeamWorker *worker) {
    for (int pass = 0; pass < BEAM_SWEEP_PASSES; pass++)
        beam_sweep_points_clear(&worker->news.points[pass]);
}

static void begin_sweep(BeamWorker *worker) {
    BeamSweepTask task = worker->task;
    take_up(&worker->sweep);
    pthread_mutex_unlock(&worker->lock);
    Fault fault = {0};
    if (worker->sweeps)
        beam_sweep_close(&worker->sweeping);
    worker->sweeps = beam_sweep_open(&worker->sweeping, &task, &fault);
    worker->swept = !worker->sweeps;
    fault_clear(&fault);
    pthread_mutex_lock(&worker->lock);
    forget_points(worker);
    worker->news.swept = worker->news.sweep_begins = true;
    worker->news.sweep_done = 0;
    worker->news.sweep_all = beam_sweep_values(&task);
}

static void go_on_sweeping(BeamWorker *worker) {
    BeamSweepPoints points[BEAM_SWEEP_PASSES] = {{0}};
    pthread_mutex_unlock(&worker->lock);
    worker->swept = !beam_sweep_advance(&worker->sweeping, worker->jobs, &worker->sweep.stop, points);
    pthread_mutex_lock(&worker->lock);
    for (int pass = 0; pass < BEAM_SWEEP_PASSES; pass++) {
        for (size_t i = 0; i < points[pass].count && !worker->sweep.asked; i++)
            beam_sweep_points_add(&worker->news.points[pass], points[pass].value[i], points[pass].peak[i]);
        beam_sweep_points_clear(&points[pass]);
    }
    worker->news.swept = true;
    worker->news.sweep_done = worker->sweeping.done;
}

/* The thread --------------------------------------------------------------------------------------------------------*/

static void wait_for_questions(BeamWorker *worker) {
    double until = HUGE_VAL;
    const Question *const questions[] = {&worker->verdict, &worker->sweep};
    for (size_t q = 0; q < 2; q++)
        if (questions[q]->asked)
            until = fmin(until, questions[q]->since + BEAM_WORKER_PAUSE);
    if (isinf(until)) {
        pthread_cond_wait(&worker->wake, &worker->lock);
        return;
    }
    struct timespec at = {(time_t)floor(until), (long)(1e9 * (until - floor(until)))};
    pthread_cond_timedwait(&worker->wake, &worker->lock, &at);
}

static bool sweeps(const BeamWorker *worker) {
    return worker->sweeps && !worker->swept && !worker->sweep.asked;
}

static bool wants_type(const BeamWorker *worker) {
    return worker->decided && !worker->typed && !worker->verdict.asked && !worker->sweep.asked;
}

/* Works until the worker is stopped. Threads started by this one inherit its low priority. */
static void *work(void *context) {
    BeamWorker *worker = context;
    setpriority(PRIO_PROCESS, 0, GIVES_WAY);
    pthread_mutex_lock(&worker->lock);
    while (!worker->quit) {
        double now = stopwatch_now();
        if (is_due(&worker->verdict, now))
            tell_verdict(worker);
        else if (is_due(&worker->sweep, now))
            begin_sweep(worker);
        else if (sweeps(worker) && (worker->sweeping.done < COARSE || !wants_type(worker)))
            go_on_sweeping(worker);
        else if (wants_type(worker))
            tell_type(worker);
        else
            wait_for_questions(worker);
    }
    pthread_mutex_unlock(&worker->lock);
    return NULL;
}

BeamWorker *beam_worker_start(int jobs) {
    BeamWorker *worker = memory_zeroed(1, sizeof *worker);
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

void beam_worker_stop(BeamWorker *worker) {
    pthread_mutex_lock(&worker->lock);
    bool runs = !worker->quit;
    worker->quit = true;
    stop_request(&worker->verdict.stop);
    stop_request(&worker->sweep.stop);
    stop_request(&worker->stop_type);
    pthread_cond_signal(&worker->wake);
    pthread_mutex_unlock(&worker->lock);
    if (runs)
        pthread_join(worker->thread, NULL);
    beam_verdict_clear(&worker->own);
    if (worker->sweeps)
        beam_sweep_close(&worker->sweeping);
    beam_verdict_clear(&worker->news.result);
    forget_points(worker);
    pthread_cond_destroy(&worker->wake);
    pthread_mutex_destroy(&worker->lock);
    memory_free(worker);
}

/* Stores a question; the lock must be held. */
static void ask(BeamWorker *worker, Question *question) {
    question->asked = true;
    question->since = stopwatch_now();
    stop_request(&question->stop);
    stop_request(&worker->stop_type);
    pthread_cond_signal(&worker->wake);
}

void beam_worker_ask_verdict(BeamWorker *worker, const Beam *beam) {
    pthread_mutex_lock(&worker->lock);
    worker->beam = *beam;
    ask(worker, &worker->verdict);
    pthread_mutex_unlock(&worker->lock);
}

void beam_worker_ask_sweep(BeamWorker *worker, const BeamSweepTask *task) {
    pthread_mutex_lock(&worker->lock);
    worker->task = *task;
    forget_points(worker);
    ask(worker, &worker->sweep);
    pthread_mutex_unlock(&worker->lock);
}

void beam_worker_take(BeamWorker *worker, BeamNews *news) {
    pthread_mutex_lock(&worker->lock);
    *news = worker->news;
    news->deciding = worker->deciding || worker->verdict.asked;
    worker->news.verdict = worker->news.swept = worker->news.sweep_begins = false;
    worker->news.result = (BeamVerdict){.advice = NULL};
    memset(worker->news.points, 0, sizeof worker->news.points);
    pthread_mutex_unlock(&worker->lock);
}
