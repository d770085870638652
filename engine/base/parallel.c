#include "base/parallel.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/memory.h"

typedef struct Crew {
    void (*work)(void *context, size_t i);
    void *context;
    size_t count;
    atomic_size_t next;
} Crew;

static void *crew_work(void *argument) {
    Crew *crew = argument;
    for (size_t i = atomic_fetch_add(&crew->next, 1); i < crew->count; i = atomic_fetch_add(&crew->next, 1))
        crew->work(crew->context, i);
    return NULL;
}

void parallel_for(int jobs, size_t count, void (*work)(void *context, size_t i), void *context) {
    Crew crew = {.work = work, .context = context, .count = count};
    size_t helpers = jobs > 1 && count > 1 ? ((size_t)jobs < count ? (size_t)jobs : count) - 1 : 0;
    pthread_t *threads = memory_allocate(helpers, sizeof *threads);
    size_t started = 0;
    while (started < helpers && pthread_create(&threads[started], NULL, crew_work, &crew) == 0)
        started++;
    crew_work(&crew); /* with no thread to be had, this one does it all */
    for (size_t i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    memory_free(threads);
}

/* Teams: who has nothing to do looks a while for the next call, then sleeps until it comes. */

enum { LOOKS = 4000 /* at some nanoseconds each: longer than the serial part of a step */ };

struct ParallelTeam {
    Crew crew;
    atomic_uint call;  /* counts the calls */
    atomic_int inside; /* helpers at work on the present call */
    atomic_bool ends;
    bool may_spin; /* a processor for each thread */
    pthread_mutex_t mutex;
    pthread_cond_t called;
    int helpers;
    pthread_t *threads; /* (helpers) */
};

static void wait_a_little(void) {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/* Waits for a call after `seen`; returns its number. */
static unsigned wait_for_call(ParallelTeam *team, unsigned seen) {
    for (int look = 0; team->may_spin && look < LOOKS; look++) {
        unsigned call = atomic_load_explicit(&team->call, memory_order_acquire);
        if (call != seen)
            return call;
        wait_a_little();
    }
    pthread_mutex_lock(&team->mutex);
    while (atomic_load(&team->call) == seen)
        pthread_cond_wait(&team->called, &team->mutex);
    unsigned call = atomic_load(&team->call);
    pthread_mutex_unlock(&team->mutex);
    return call;
}

static void *help(void *argument) {
    ParallelTeam *team = argument;
    unsigned seen = 0;
    for (;;) {
        seen = wait_for_call(team, seen);
        if (atomic_load(&team->ends))
            return NULL;
        crew_work(&team->crew);
        atomic_fetch_sub_explicit(&team->inside, 1, memory_order_release);
    }
}

static void call_helpers(ParallelTeam *team) {
    pthread_mutex_lock(&team->mutex);
    atomic_fetch_add_explicit(&team->call, 1, memory_order_release);
    pthread_cond_broadcast(&team->called);
    pthread_mutex_unlock(&team->mutex);
}

ParallelTeam *parallel_team_create(int jobs) {
    if (jobs < 2)
        return NULL;
    ParallelTeam *team = memory_allocate(1, sizeof *team);
    team->may_spin = jobs <= parallel_processors();
    pthread_mutex_init(&team->mutex, NULL);
    pthread_cond_init(&team->called, NULL);
    team->threads = memory_allocate((size_t)jobs - 1, sizeof *team->threads);
    while (team->helpers < jobs - 1 && pthread_create(&team->threads[team->helpers], NULL, help, team) == 0)
        team->helpers++;
    return team;
}

void parallel_team_destroy(ParallelTeam *team) {
    if (!team)
        return;
    atomic_store(&team->ends, true);
    call_helpers(team);
    for (int i = 0; i < team->helpers; i++)
        pthread_join(team->threads[i], NULL);
    pthread_cond_destroy(&team->called);
    pthread_mutex_destroy(&team->mutex);
    memory_free(team->threads);
    memory_free(team);
}

void parallel_team_for(ParallelTeam *team, size_t count, void (*work)(void *context, size_t i), void *context) {
    if (!team || count < 2) {
        for (size_t i = 0; i < count; i++)
            work(context, i);
        return;
    }
    team->crew.work = work;
    team->crew.context = context;
    team->crew.count = count;
    atomic_store(&team->crew.next, 0);
    atomic_store(&team->inside, team->helpers);
    call_helpers(team);
    crew_work(&team->crew);
    while (atomic_load_explicit(&team->inside, memory_order_acquire) > 0)
        if (team->may_spin)
            wait_a_little();
        else
            sched_yield();
}

int parallel_processors(void) {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}
