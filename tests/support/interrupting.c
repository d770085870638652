/* Stands in the place of engine/base/stop.c in a program for app/command/inject.py: the environment interrupts the work
 * at a chosen poll. CLEARANCE_INJECT=poll:N sets the request that is polled at the N-th poll, and poll:count prints at
 * the end how many polls there were. */
#include "base/stop.h"

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

bool stop_requested(const Stop *stop) {
    if (!stop)
        return false;
    if (atomic_fetch_add(&polls, 1) + 1 == interrupts_at)
        stop_request((Stop *)stop);
    return __atomic_load_n(&stop->requested, __ATOMIC_RELAXED);
}

void stop_request(Stop *stop) {
    __atomic_store_n(&stop->requested, 1, __ATOMIC_RELAXED);
}

void stop_withdraw(Stop *stop) {
    __atomic_store_n(&stop->requested, 0, __ATOMIC_RELAXED);
}
