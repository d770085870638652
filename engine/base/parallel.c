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
    pthread_t *threads = memory_zeroed(helpers, sizeof *threads);
    size_t started = 0;
    while (started < helpers && pthread_create(&threads[started], NULL, crew_work, &crew) == 0)
        started++;
    crew_work(&crew); /* if no thread could be created, the calling thread does all the work */
    for (size_t i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    memory_free(threads);
}

/* Teams. One number describes a call: the number of the call, the number of its pieces, and how many of them are taken.
 * A thread that increments the number has taken a piece. A call ends when all its pieces are done, even if a helper has
 * not noticed the call, so that a helper without a processor delays no other thread. Helpers poll for the next call for
 * a while and then sleep. */

enum { LOOKS = 4000 /* each some nanoseconds: longer than the serial part of a step */ };

#define PIECE_BITS 24
#define PIECE_MASK ((UINT64_C(1) << PIECE_BITS) - 1)

struct ParallelTeam {
    atomic_uint_fast64_t call; /* number << 2 PIECE_BITS | pieces << PIECE_BITS | taken */
    atomic_size_t done;        /* finished pieces of the present call */
    void (*work)(void *context, size_t i);
    void *context;
    size_t calls;
    atomic_bool ends;
    atomic_int sleepers;
    pthread_mutex_t mutex;
    pthread_cond_t called;
    int helpers;
    pthread_t *threads; /* (helpers) */
};

static bool has_pieces(uint64_t call) {
    return (call & PIECE_MASK) < (call >> PIECE_BITS & PIECE_MASK);
}

/* Takes pieces of the present call while there are any. Work and context do not change while a piece is unfinished. */
static void take_pieces(ParallelTeam *team) {
    while (has_pieces(atomic_load(&team->call))) {
        uint64_t call = atomic_fetch_add(&team->call, 1);
        if (!has_pieces(call))
            return;
        team->work(team->context, (size_t)(call & PIECE_MASK));
        atomic_fetch_add(&team->done, 1);
    }
}

static void wait_a_little(void) {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/* Waits until there may be new work. */
static void wait_for_call(ParallelTeam *team) {
    for (int look = 0; look < LOOKS; look++) {
        if (has_pieces(atomic_load_explicit(&team->call, memory_order_relaxed)) || atomic_load(&team->ends))
            return;
        wait_a_little();
    }
    pthread_mutex_lock(&team->mutex);
    atomic_fetch_add(&team->sleepers, 1);
    while (!has_pieces(atomic_load(&team->call)) && !atomic_load(&team->ends))
        pthread_cond_wait(&team->called, &team->mutex);
    atomic_fetch_sub(&team->sleepers, 1);
    pthread_mutex_unlock(&team->mutex);
}

static void wake_helpers(ParallelTeam *team) {
    if (atomic_load(&team->sleepers) == 0)
        return;
    pthread_mutex_lock(&team->mutex);
    pthread_cond_broadcast(&team->called);
    pthread_mutex_unlock(&team->mutex);
}

static void *help(void *argument) {
    ParallelTeam *team = argument;
    while (!atomic_load(&team->ends)) {
        take_pieces(team);
        wait_for_call(team);
    }
    return NULL;
}

ParallelTeam *parallel_team_create(int jobs) {
    if (jobs < 2)
        return NULL;
    ParallelTeam *team = memory_zeroed(1, sizeof *team);
    pthread_mutex_init(&team->mutex, NULL);
    pthread_cond_init(&team->called, NULL);
    team->threads = memory_zeroed((size_t)jobs - 1, sizeof *team->threads);
    while (team->helpers < jobs - 1 && pthread_create(&team->threads[team->helpers], NULL, help, team) == 0)
        team->helpers++;
    return team;
}

void parallel_team_destroy(ParallelTeam *team) {
    if (!team)
        return;
    atomic_store(&team->ends, true);
    wake_helpers(team);
    for (int i = 0; i < team->helpers; i++)
        pthread_join(team->threads[i], NULL);
    pthread_cond_destroy(&team->called);
    pthread_mutex_destroy(&team->mutex);
    memory_free(team->threads);
    memory_free(team);
}

void parallel_team_for(ParallelTeam *team, size_t count, void (*work)(void *context, size_t i), void *context) {
    if (!team || count < 2 || count > PIECE_MASK / 2) {
        for (size_t i = 0; i < count; i++)
            work(context, i);
        return;
    }
    team->work = work;
    team->context = context;
    atomic_store(&team->done, 0);
    atomic_store(&team->call, (uint64_t)++team->calls << 2 * PIECE_BITS | (uint64_t)count << PIECE_BITS);
    wake_helpers(team);
    take_pieces(team);
    for (int look = 0; atomic_load(&team->done) < count; look++)
        if (look < LOOKS)
            wait_a_little();
        else
            sched_yield();
}

int parallel_processors(void) {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}
