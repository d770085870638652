#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "beam/beam.h"
#include "check.h"
#include "scratch.h"

TEST(every_shipped_beam_reads_and_every_value_says_where_it_comes_from) {
    size_t count;
    char **paths = scratch_list("assets/beams", &count);
    CHECK(count >= 2);
    for (size_t i = 0; i < count; i++) {
        Beam beam = {0};
        Fault fault = {0};
        CHECK(beam_is_file(scratch_source(paths[i])));
        CHECK(beam_read(&beam, scratch_source(paths[i]), NULL, 0, &fault));
        check_say(&fault);
        char path[100];
        snprintf(path, sizeof path, "assets/beams/%s.json", beam.name);
        CHECK_TEXT(path, paths[i]);
        CHECK(strstr(beam.note, "not published"));
        for (size_t r = 0; r < beam_table()->count; r++)
            CHECK(beam.provenance[r] && strcmp(beam_table()->rows[r].name, "") != 0);
        beam_free(&beam);
    }
    scratch_free_list(paths, count);
}

TEST(a_house_is_no_beam) {
    CHECK(!beam_is_file(scratch_source("houses/corner-0.90-0.90.json")));
    CHECK(!beam_is_file(scratch_source("houses/there-is-none.json")));
}

TEST(settings_change_a_beam_and_say_so) {
    const char *settings[] = {"drive.frequency=290", "joint.release=gap", "clearance=0.25e-3"};
    Beam beam = {0};
    Fault fault = {0};
    CHECK(beam_read(&beam, scratch_source("assets/beams/ibs.json"), settings, 3, &fault));
    check_say(&fault);
    CHECK_NEAR(beam.frequency, 290, 0);
    CHECK_NEAR(beam.clearance, 0.25e-3, 0);
    CHECK(beam.release == RELEASE_GAP);
    for (size_t r = 0; r < beam_table()->count; r++)
        if (strcmp(beam_table()->rows[r].name, "drive.frequency") == 0)
            CHECK_TEXT(beam.provenance[r], "assumed: set for this run");
    beam_free(&beam);
}

static bool same_number(const Parameter *row, const Beam *a, const Beam *b) {
    const char *one = (const char *)a + row->offset, *other = (const char *)b + row->offset;
    if (row->kind == PARAMETER_NUMBER)
        return *(const double *)one == *(const double *)other;
    return *(const int *)one == *(const int *)other;
}

TEST(a_beam_that_is_written_reads_the_same) {
    const char *settings[] = {"drive.frequency=291.3", "joint.release=gap", "beam.modes=4"};
    Beam beam = {0}, again = {0};
    Fault fault = {0};
    CHECK(beam_read(&beam, scratch_source("assets/beams/ibs-r.json"), settings, 3, &fault));
    char path[SCRATCH_PATH];
    scratch_write(path, "");
    CHECK(beam_write(&beam, path) == 0);
    CHECK(beam_is_file(path) && beam_read(&again, path, NULL, 0, &fault));
    check_say(&fault);
    for (size_t r = 0; r < beam_table()->count; r++) {
        CHECK(same_number(&beam_table()->rows[r], &beam, &again));
        CHECK_TEXT(again.provenance[r], beam.provenance[r]);
    }
    CHECK_TEXT(again.name, beam.name);
    CHECK_TEXT(again.note, beam.note);
    CHECK(beam_write(&beam, "/there/is/none.json") != 0);
    beam_free(&beam);
    beam_free(&again);
    unlink(path);
}

TEST(a_wrong_setting_leaves_the_beam_and_names_what_would_be_right) {
    static const char *const wrong[][2] = {
        {"drive.frequency=0", "--set drive.frequency: drive.frequency is 0, must be from 1 to 100000 Hz"},
        {"drive.frequenzy=300",
         "--set drive.frequenzy: beam has no parameter \"drive.frequenzy\", did you mean \"drive.frequency\"?"},
        {"joint.release=late", "--set joint.release: joint.release is \"late\", must be force or gap"},
        {"position=0", "--set position: beam parameter \"position\" must be pivot.position or shaker.position"},
        {"clearance", "--set clearance: must be NAME=VALUE, for instance drive.frequency=300"},
        {"run.cycles=99999999999", "--set run.cycles: run.cycles is 1e+11, must be from 1 to 1e+06"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        Beam beam = {.frequency = 7};
        Fault fault = {0};
        CHECK(!beam_read(&beam, scratch_source("assets/beams/ibs.json"), &wrong[i][0], 1, &fault));
        CHECK(beam.frequency == 7 && !beam.name);
        CHECK(fault.count == 1);
        if (fault.count)
            CHECK_TEXT(fault.lines[0], wrong[i][1]);
        fault_clear(&fault);
    }
}

static void read_bad(const char *path, Fault *fault) {
    Beam beam = {.force = 7};
    CHECK(!beam_read(&beam, path, NULL, 0, fault));
    CHECK(beam.force == 7 && !beam.name);
}

TEST(every_bad_beam_gives_exactly_its_faults) {
    scratch_check_faults("tests/data/bad/beams", read_bad);
}
