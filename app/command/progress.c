#include "command/progress.h"

#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

Stop progress_stop;

bool progress_interrupted(void) {
    return stop_requested(&progress_stop);
}

static int64_t now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (int64_t)time.tv_sec * 1000000000 + time.tv_nsec;
}

/* May run in several threads at once. */
static void interrupt(int signal_number) {
    const int64_t together = 300000000; /* ns: signals within this time are one request */
    static _Atomic int64_t first;       /* ns; 0: none yet */
    int64_t before = 0, time = now();
    if (!atomic_compare_exchange_strong(&first, &before, time) && time - before > together)
        _exit(128 + signal_number);
    stop_request(&progress_stop);
}

void progress_catch_signals(void) {
    struct sigaction action = {.sa_handler = interrupt}; /* without SA_RESTART: a wait for a pipe ends */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

bool progress_is_shown(const Options *options) {
    return !options->quiet && (isatty(STDERR_FILENO) || getenv("CLEARANCE_PROGRESS"));
}
