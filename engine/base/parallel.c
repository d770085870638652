#include "base/parallel.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>

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

int parallel_processors(void) {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}
