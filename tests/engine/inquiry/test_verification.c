/* Tests case files: valid and invalid ones, and that verdicts follow from values. */

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "base/stop.h"
#include "check.h"
#include "scratch.h"
#include "base/text.h"
#include "inquiry/case_run.h"

static bool read_shipped(Verification *verification, const char *path) {
    Fault fault = {0};
    bool good = verification_read(verification, scratch_source(path), &fault);
    check_say(&fault);
    return good;
}

TEST(every_shipped_case_is_read) {
    size_t count;
    char **paths = scratch_list("tests/cases", &count);
    CHECK(count > 20);
    for (size_t i = 0; i < count; i++) {
        Verification verification = {.path = NULL};
        CHECK(read_shipped(&verification, paths[i]));
        CHECK(verification.applies == (verification.check_count > 0));
        verification_free(&verification);
    }
    scratch_free_list(paths, count);
}

static void read_bad_case(const char *path, Fault *fault) {
    Verification verification = {.id = "untouched"};
    CHECK(!verification_read(&verification, path, fault));
    CHECK_TEXT(verification.id, "untouched");
}

TEST(a_bad_case_gives_exactly_its_faults_and_is_left_as_it_was) {
    scratch_check_faults("tests/data/bad/cases", read_bad_case);
}

static const CaseRunOptions *options_of(int jobs) {
    static char profiles[4096];
    static CaseRunOptions options;
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    options = (CaseRunOptions){.profiles = profiles, .seed = 1, .jobs = jobs};
    return &options;
}

/* A case of the shipped straight corridor, its person half as fast in a variant. */
static void draft_case(Verification *verification, const char *checks) {
    char path[SCRATCH_PATH], text[2048];
    snprintf(text, sizeof text,
             "{'format': 'clearance-case', 'version': 1, 'id': 'a', 'suite': 's', 'title': 't', 'house': "
             "'%s/houses/straight-corridor.json', 'variants': [{'id': 'slow', 'set': 'person.p1.speed=0.345 "
             "run.sample=0.1'}, {'id': 'fast'}], 'checks': [%s]}",
             check_source(), checks);
    scratch_write(path, text);
    Fault fault = {0};
    CHECK(verification_read(verification, path, &fault));
    check_say(&fault);
    remove(path);
}

TEST(a_value_within_its_limits_passes_and_one_outside_does_not) {
    Verification verification = {.path = NULL};
    draft_case(&verification, "{'measure': 'out', 'low': 1, 'high': 1, 'unit': '1', 'seeds': 2},"
                              "{'measure': 'time', 'high': 1, 'unit': 's'}");
    Fault fault = {0};
    case_run_all(&verification, 1, options_of(1), &fault);
    CHECK(!fault.total);
    CHECK(verification.checks[0].condition.verdict == VERDICT_PASSED);
    CHECK_NEAR(verification.checks[0].condition.value, 1, 0);
    CHECK(verification.checks[1].condition.verdict == VERDICT_FAILED);
    CHECK(case_run_verdict(&verification) == VERDICT_FAILED);
    verification_free(&verification);
}

TEST(a_ratio_compares_a_variant_with_another_and_does_not_depend_on_jobs) {
    double values[2];
    for (int jobs = 1; jobs <= 2; jobs++) {
        Verification verification = {.path = NULL};
        draft_case(&verification, "{'measure': 'time', 'variant': 'slow', 'than': 'fast', 'low': 1.8, 'high': 2.2, "
                                  "'unit': '1', 'seeds': 3}");
        Fault fault = {0};
        case_run_all(&verification, 1, options_of(jobs), &fault);
        CHECK(!fault.total);
        CHECK(case_run_verdict(&verification) == VERDICT_PASSED);
        values[jobs - 1] = verification.checks[0].condition.value;
        verification_free(&verification);
    }
    CHECK_NEAR(values[0], values[1], 0);
}

TEST(what_is_stopped_is_not_run) {
    static const Stop stop = {1};
    Verification verification = {.path = NULL};
    draft_case(&verification, "{'measure': 'out', 'low': 1, 'unit': '1'}");
    CaseRunOptions options = *options_of(1);
    options.stop = &stop;
    Fault fault = {0};
    case_run_all(&verification, 1, &options, &fault);
    CHECK(case_run_verdict(&verification) == VERDICT_NOT_RUN);
    CHECK(isnan(verification.checks[0].condition.value));
    verification_free(&verification);
}
