#include "command/progress.h"

#include <stdlib.h>
#include <unistd.h>

volatile sig_atomic_t progress_interrupted;

static void interrupt(int signal_number) {
    if (progress_interrupted)
        _exit(128 + signal_number);
    progress_interrupted = 1;
}

void progress_catch_signals(void) {
    signal(SIGINT, interrupt);
    signal(SIGTERM, interrupt);
}

bool progress_is_shown(const Options *options) {
    return !options->quiet && (isatty(STDERR_FILENO) || getenv("CLEARANCE_PROGRESS"));
}
