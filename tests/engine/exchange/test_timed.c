/* Tests the reader of measured times. */

#include "exchange/timed.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "scratch.h"

TEST(times_are_read_with_and_without_deviations) {
    char path[SCRATCH_PATH];
    Timed timed = {0};
    Fault fault = {0};
    scratch_write(path, "driver;deviation [s];Time [s];route\n1;0.5;13.1;A\n2;;12.5;B\n");
    CHECK(timed_read(&timed, path, &fault));
    check_say(&fault);
    CHECK(timed.count == 2 && strcmp(timed.runs[0].route, "A") == 0 && strcmp(timed.runs[1].route, "B") == 0);
    CHECK_NEAR(timed.runs[0].time, 13.1, 0);
    CHECK_NEAR(timed.runs[0].deviation, 0.5, 0);
    CHECK(isnan(timed.runs[1].deviation) && timed.runs[1].line == 3);
    timed_free(&timed);
    remove(path);
}

static void read_bad(const char *path, Fault *fault) {
    Timed timed = {0};
    CHECK(!timed_read(&timed, path, fault) && timed.count == 0);
    timed_free(&timed);
}

TEST(bad_files_are_refused_with_the_place) {
    scratch_check_faults("tests/data/bad/timed", read_bad);
}
