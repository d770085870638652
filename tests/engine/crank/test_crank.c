#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "crank/crank.h"
#include "cranks.h"
#include "scratch.h"

TEST(every_number_of_the_shipped_crank_is_assumed_and_says_so) {
    Crank crank = cranks_read(NULL);
    CHECK_TEXT(crank.name, "ssc");
    for (size_t i = 0; i < crank_table()->count; i++)
        CHECK(strncmp(crank.provenance[i], "assumed: ", 9) == 0);
    CHECK_NEAR(crank.frequency * 60, 700, 1e-9);
    CHECK(crank.shortening);
    crank_free(&crank);
}

TEST(a_written_crank_is_the_same_crank) {
    char path[CHECK_PATH];
    check_temporary(path, "crank.json");
    Crank crank = cranks_read((const char *const[]){"joint.friction=0.1", "coupler.shortening=false", NULL}),
          again = {0};
    Fault fault = {0};
    CHECK(crank_write(&crank, path) == 0);
    CHECK(crank_is_file(path));
    CHECK(crank_read(&again, path, NULL, 0, &fault));
    check_say(&fault);
    for (size_t i = 0; i < crank_table()->count; i++)
        CHECK_TEXT(again.provenance[i], crank.provenance[i]);
    CHECK_NEAR(again.contact.friction, 0.1, 0);
    CHECK_NEAR(again.frequency, crank.frequency, 0);
    CHECK(!again.shortening);
    CHECK_TEXT(again.note, crank.note);
    crank_free(&crank);
    crank_free(&again);
    remove(path);
}

TEST(a_wrong_setting_says_what_would_be_right) {
    static const char *const wrong[][2] = {
        {"crank.radus=1", "--set crank.radus: "},
        {"joint.clearance=-1", "--set joint.clearance: "},
        {"drive.frequency", "--set drive.frequency: must be NAME=VALUE"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        Crank crank = {0};
        Fault fault = {0};
        CHECK(!crank_read(&crank, scratch_source("assets/cranks/ssc.json"), &wrong[i][0], 1, &fault));
        CHECK(fault.count == 1);
        CHECK(strncmp(fault.lines[0], wrong[i][1], strlen(wrong[i][1])) == 0);
        fault_clear(&fault);
    }
}

static void read_bad(const char *path, Fault *fault) {
    Crank crank = {.radius = 7};
    CHECK(!crank_read(&crank, path, NULL, 0, fault));
    CHECK(crank.radius == 7 && !crank.name);
}

TEST(every_bad_crank_gives_exactly_its_faults) {
    scratch_check_faults("tests/data/bad/cranks", read_bad);
}
