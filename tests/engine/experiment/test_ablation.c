#include "experiment/ablation.h"

#include <string.h>

#include "case.h"
#include "check.h"
#include "base/text.h"
#include "scratch.h"

enum { COUNT = 4 };

/* The first leg of a corner of 1.20 m takes the chairs to the corner, where F4 acts. */
static bool ablate(Ablation *ablation, const char *house, int jobs, const Stop *stop) {
    Population population = {0};
    Fault fault = {0};
    CHECK(population_read(&population, scratch_source("assets/populations/manual-jp.json"), &fault));
    char *profiles = text_copy(scratch_source("assets/profiles"));
    bool good =
        ablation_run(ablation, scratch_source(house), &(HouseOptions){.profiles = profiles, .seed = 1, .driving = -1},
                     &population, COUNT, jobs, stop, &fault);
    fault_clear(&fault);
    memory_free(profiles);
    population_free(&population);
    return good;
}

static const DriverRun *run(const Ablation *ablation, int variant, size_t k) {
    return &ablation->drivers[variant].runs[k * ablation->drivers[variant].person_count];
}

/* m, over all drivers */
static double mean_narrowest(const Ablation *ablation, int variant) {
    double sum = 0;
    for (size_t k = 0; k < COUNT; k++)
        sum += run(ablation, variant, k)->narrowest;
    return sum / COUNT;
}

LONG_TEST(each_variant_has_the_same_drivers_and_leaves_out_what_it_says) {
    Ablation ablation, again;
    CHECK(ablate(&ablation, "houses/corner-1.20-1.20.json", 2, NULL) && !ablation.interrupted);
    CHECK(ablate(&again, "houses/corner-1.20-1.20.json", 1, NULL));
    for (size_t k = 0; k < COUNT; k++) {
        for (int v = 0; v < ABLATIONS; v++) {
            CHECK(run(&ablation, v, k)->varies && run(&ablation, v, k)->completed);
            CHECK_NEAR(run(&again, v, k)->time, run(&ablation, v, k)->time, 0);
        }
        CHECK(run(&ablation, ABLATION_NO_WANDER, k)->contacts == 0);
        /* F4 hardly matters where the speed is as low as in the paper's corners. */
        double with = run(&ablation, ABLATION_PAPER, k)->time;
        CHECK_NEAR(run(&ablation, ABLATION_PAPER_NO_F4, k)->time, with, 0.2);
        CHECK(run(&ablation, ABLATION_PAPER_NO_LATERAL, k)->narrowest != run(&ablation, ABLATION_PAPER, k)->narrowest);
    }
    /* At the narrowest place errors lead one driver nearer to the wall and another one away from it: all drivers
     * together come nearer. */
    double whole = mean_narrowest(&ablation, ABLATION_WHOLE);
    CHECK(whole < mean_narrowest(&ablation, ABLATION_NO_WANDER));
    CHECK(mean_narrowest(&ablation, ABLATION_NO_RING) < whole);
    ablation_free(&ablation);
    ablation_free(&again);
}

TEST(an_interrupted_ablation_says_so_and_a_bad_house_is_an_error) {
    Ablation ablation;
    Stop stop = {0};
    stop_request(&stop);
    CHECK(ablate(&ablation, "houses/straight-corridor.json", 1, &stop) && ablation.interrupted);
    ablation_free(&ablation);
    CHECK(!ablate(&ablation, "houses/there-is-no-such-house.json", 1, NULL));
}

TEST(each_variant_but_the_whole_law_has_options_of_its_own) {
    for (int v = 0; v < ABLATIONS; v++) {
        CHECK(ablation_rows[v].name && ablation_rows[v].meaning);
        CHECK((ablation_rows[v].settings[0] != NULL || ablation_rows[v].driving >= 0) == (v != ABLATION_WHOLE));
    }
    CHECK(strcmp(ablation_rows[ABLATION_NO_RING].settings[0], "run.ring=off") == 0);
}
