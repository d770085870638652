#include "base/stop.h"

#include <stddef.h>

#ifdef CLEARANCE_INJECT

/* In a build with -Dinject=true the environment interrupts the work at a chosen poll: CLEARANCE_INJECT=poll:N sets the
 * request that is polled at the N-th poll, and poll:count prints at the end how many polls there were. */

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static atomic_long polls;
static long interrupts_at; /* 0: never */
static bool counts;

__attribute__((constructor)) static void read_injection(void) {
    const char *word = getenv("CLEARANCE_INJECT");
    counts = word && strcmp(word, "poll:count") == 0;
    interrupts_at = word && !counts && strncmp(word, "poll:", 5) == 0 ? strtol(word + 5, NULL, 10) : 0;
}

__attribute__((destructor)) static void print_count(void) {
    if (counts)
        fprintf(stderr, "polls: %ld\n", atomic_load(&polls));
}

static void inject(const Stop *stop) {
    if (atomic_fetch_add(&polls, 1) + 1 == interrupts_at)
        stop_request((Stop *)stop);
}

#else

static void inject(const Stop *stop) {
    (void)stop;
}

#endif

bool stop_requested(const Stop *stop) {
    if (!stop)
        return false;
    inject(stop);
    return __atomic_load_n(&stop->requested, __ATOMIC_RELAXED);
}

void stop_request(Stop *stop) {
    __atomic_store_n(&stop->requested, 1, __ATOMIC_RELAXED);
}

void stop_withdraw(Stop *stop) {
    __atomic_store_n(&stop->requested, 0, __ATOMIC_RELAXED);
}
