/* Tests signals: the first one asks for the end, and only a later one ends the program at once. */
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "command/progress.h"

/* Sends a signal twice in a child; returns the child's exit code, 7 if both are one request. */
static int code_after_two(double pause) {
    pid_t child = fork();
    int status = 0;
    if (child == 0) {
        struct timespec time = {0, (long)(pause * 1e9)};
        progress_catch_signals();
        raise(SIGINT);
        nanosleep(&time, NULL);
        raise(SIGTERM);
        _exit(progress_interrupted() ? 7 : 0);
    }
    CHECK(waitpid(child, &status, 0) == child && WIFEXITED(status));
    return WEXITSTATUS(status);
}

TEST(a_signal_that_is_delivered_twice_at_once_does_not_end_the_program) {
    CHECK(code_after_two(0) == 7);
}

TEST(a_later_second_signal_ends_the_program) {
    CHECK(code_after_two(0.5) == 128 + SIGTERM);
}
