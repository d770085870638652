#include "laboratory/house/worker.h"

#include "base/stop.h"
#include "laboratory/urgency.h"

struct HouseWorker {
    pthread_t thread;
    pthread_mutex_t mutex;
    pthread_cond_t asked;
    HouseRun *waiting[HOUSE_JOBS];
    HouseRun *current; /* the run in progress */
    bool forsaken;     /* the run in progress is abandoned */
    bool low;          /* the thread has a low priority */
    bool ends;
};

/* Returns the first job with a waiting run; HOUSE_JOBS: none. */
static int first_waiting(const HouseWorker *worker) {
    int job = 0;
    while (job < HOUSE_JOBS && !worker->waiting[job])
        job++;
    return job;
}

/* Waits for the next run; NULL: the worker must end. The mutex must be locked. */
static HouseRun *wait_for_run(HouseWorker *worker) {
    while (!worker->ends && first_waiting(worker) == HOUSE_JOBS)
        pthread_cond_wait(&worker->asked, &worker->mutex);
    if (worker->ends)
        return NULL;
    int job = first_waiting(worker);
    HouseRun *run = worker->waiting[job];
    worker->waiting[job] = NULL;
    return run;
}

static void *work(void *context) {
    HouseWorker *worker = context;
    urgency_set(worker->low ? URGENCY_AFTERWARDS : URGENCY_ANSWER);
    pthread_mutex_lock(&worker->mutex);
    while ((worker->current = wait_for_run(worker))) {
        HouseRun *run = worker->current;
        pthread_mutex_unlock(&worker->mutex);
        house_run_make(run);
        pthread_mutex_lock(&worker->mutex);
        if (worker->forsaken)
            house_run_destroy(run);
        worker->forsaken = false;
        worker->current = NULL;
    }
    pthread_mutex_unlock(&worker->mutex);
    return NULL;
}

static void release(HouseWorker *worker) {
    pthread_cond_destroy(&worker->asked);
    pthread_mutex_destroy(&worker->mutex);
    memory_free(worker);
}

HouseWorker *house_worker_create(bool low) {
    HouseWorker *worker = memory_zeroed(1, sizeof *worker);
    worker->low = low;
    pthread_mutex_init(&worker->mutex, NULL);
    pthread_cond_init(&worker->asked, NULL);
    if (pthread_create(&worker->thread, NULL, work, worker) == 0)
        return worker;
    release(worker);
    return NULL;
}

void house_worker_destroy(HouseWorker *worker) {
    pthread_mutex_lock(&worker->mutex);
    worker->ends = true;
    pthread_cond_signal(&worker->asked);
    pthread_mutex_unlock(&worker->mutex);
    pthread_join(worker->thread, NULL);
    release(worker);
}

void house_worker_ask(HouseWorker *worker, HouseRun *run) {
    pthread_mutex_lock(&worker->mutex);
    worker->waiting[run->wish.job] = run;
    pthread_cond_signal(&worker->asked);
    pthread_mutex_unlock(&worker->mutex);
}

void house_worker_abandon(HouseWorker *worker, HouseRun *run) {
    if (!run)
        return;
    pthread_mutex_lock(&worker->mutex);
    for (int i = 0; i < HOUSE_JOBS; i++)
        if (worker->waiting[i] == run)
            worker->waiting[i] = NULL;
    bool in_work = worker->current == run;
    if (in_work) {
        worker->forsaken = true;
        stop_request(&run->stop);
    }
    pthread_mutex_unlock(&worker->mutex);
    if (!in_work)
        house_run_destroy(run);
}
