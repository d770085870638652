#include "laboratory/house_live_worker.h"

#include "base/parallel.h"

struct HouseWorker {
    pthread_t thread;
    pthread_mutex_t mutex;
    pthread_cond_t asked;
    HouseRun *waiting[2]; /* the urgent one, the other one */
    HouseRun *current;    /* in work */
    bool forsaken;        /* the current one is abandoned */
    bool ends;
};

/* The next one, or NULL: it ends. The mutex is locked. */
static HouseRun *wait_for_run(HouseWorker *worker) {
    while (!worker->ends && !worker->waiting[0] && !worker->waiting[1])
        pthread_cond_wait(&worker->asked, &worker->mutex);
    if (worker->ends)
        return NULL;
    int which = worker->waiting[0] ? 0 : 1;
    HouseRun *run = worker->waiting[which];
    worker->waiting[which] = NULL;
    return run;
}

static void *work(void *context) {
    HouseWorker *worker = context;
    pthread_mutex_lock(&worker->mutex);
    while ((worker->current = wait_for_run(worker))) {
        HouseRun *run = worker->current;
        pthread_mutex_unlock(&worker->mutex);
        house_live_run_make(run);
        pthread_mutex_lock(&worker->mutex);
        if (worker->forsaken)
            house_live_run_destroy(run);
        worker->forsaken = false;
        worker->current = NULL;
    }
    pthread_mutex_unlock(&worker->mutex);
    return NULL;
}

HouseWorker *house_live_worker_create(void) {
    HouseWorker *worker = memory_allocate(1, sizeof *worker);
    pthread_mutex_init(&worker->mutex, NULL);
    pthread_cond_init(&worker->asked, NULL);
    pthread_create(&worker->thread, NULL, work, worker);
    return worker;
}

void house_live_worker_destroy(HouseWorker *worker) {
    pthread_mutex_lock(&worker->mutex);
    worker->ends = true;
    pthread_cond_signal(&worker->asked);
    pthread_mutex_unlock(&worker->mutex);
    pthread_join(worker->thread, NULL);
    pthread_cond_destroy(&worker->asked);
    pthread_mutex_destroy(&worker->mutex);
    memory_free(worker);
}

void house_live_worker_ask(HouseWorker *worker, HouseRun *run, bool urgent) {
    pthread_mutex_lock(&worker->mutex);
    worker->waiting[urgent ? 0 : 1] = run;
    pthread_cond_signal(&worker->asked);
    pthread_mutex_unlock(&worker->mutex);
}

void house_live_worker_abandon(HouseWorker *worker, HouseRun *run) {
    if (!run)
        return;
    pthread_mutex_lock(&worker->mutex);
    for (int i = 0; i < 2; i++)
        if (worker->waiting[i] == run)
            worker->waiting[i] = NULL;
    bool in_work = worker->current == run;
    if (in_work) {
        worker->forsaken = true;
        parallel_stop(&run->stop);
    }
    pthread_mutex_unlock(&worker->mutex);
    if (!in_work)
        house_live_run_destroy(run);
}
