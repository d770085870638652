/* Tests the drivers that a session runs in the background: they are those of `run --drivers`, bit for bit, are only run
 * when they are shown, and an edit cancels them. */

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "case.h"
#include "check.h"
#include "house/run.h"
#include "laboratory/house/crew.h"
#include "result/drivers.h"
#include "running_house.h"

static const Laboratory *const laboratory = &house_laboratory;

enum { DRIVERS_BIT = 1 << 9 };

/* Runs drivers as `run --drivers` does, and returns what is said of the first person. */
static uint64_t headless(const char *name, size_t count, int jobs, const char *const *settings, char said[256]) {
    House house;
    Population population = {0};
    Drivers drivers;
    Fault fault = {0};
    Arena arena = {0};
    char path[CHECK_PATH];
    case_house(&house, name, -1, settings);
    snprintf(path, sizeof path, "%s/assets/populations/manual-jp.json", check_source());
    CHECK(population_read(&population, path, &fault));
    drivers_run(&drivers, &house, &population, count, SIZE_MAX, jobs, NULL);
    snprintf(said, 256, "%s", result_drivers_brief(&house, &drivers, 0, &arena));
    uint64_t digest = crew_digest(&drivers);
    arena_clear(&arena);
    drivers_free(&drivers);
    population_free(&population);
    house_free(&house);
    return digest;
}

TEST(the_drivers_of_the_window_are_those_of_run_bit_for_bit) {
    House house;
    Fault fault = {0};
    char said[256];
    case_house(&house, "straight-corridor", -1, NULL);
    for (int step = 0; step < CREW_STEPS; step++) {
        Crew crew;
        CHECK(crew_make(&crew, step, &house, SIZE_MAX, 1 + step, NULL, &fault));
        CHECK(crew.count == crew_size(step, &house.plan) && crew.person_count == 1);
        CHECK(crew.digest == headless("straight-corridor", crew_size(step, &house.plan), 2 - step, NULL, said));
        CHECK_TEXT(crew.said[0], said);
        CHECK(crew.scene.count > 0);
        crew_clear(&crew);
    }
    house_free(&house);
}

TEST(a_house_says_how_many_drivers_the_window_runs_and_of_which_population) {
    House house;
    Fault fault = {0};
    Crew crew;
    case_house(&house, "straight-corridor", -1, NULL);
    house.plan.drivers = (PlanDrivers){.count = 4, .population = "whm", .place = ""};
    CHECK(crew_make(&crew, CREW_STEPS - 1, &house, SIZE_MAX, 1, NULL, &fault) && crew.count == 4);
    uint64_t digest = crew.digest;
    crew_clear(&crew);
    house.plan.drivers.population = "";
    CHECK(crew_make(&crew, CREW_STEPS - 1, &house, SIZE_MAX, 1, NULL, &fault) && crew.digest != digest);
    crew_clear(&crew);
    house.plan.drivers = (PlanDrivers){.count = 4, .population = "wmh", .place = "flat.json:3:4: "};
    CHECK(!crew_make(&crew, 0, &house, SIZE_MAX, 1, NULL, &fault));
    CHECK(strstr(fault.lines[0], "flat.json:3:4: unknown population \"wmh\"; known are manual-jp, whm"));
    fault_clear(&fault);
    house_free(&house);
}

/* Updates until the answer speaks of drivers. Returns false after 1000 s, which a busy machine may come near to. */
static bool wait_for(void *session, const char *words) {
    for (int turn = 0; turn < 100000; turn++) {
        laboratory->update(session, 0);
        if (strstr(laboratory->answer(session).detail, words))
            return true;
        usleep(10000);
    }
    return false;
}

TEST(drivers_run_when_they_are_shown_and_an_edit_cancels_them) {
    char said[256];
    void *session = running_house_open("straight-corridor", NULL, 0, NULL);
    running_house_finish(session, 0);
    CHECK(!(laboratory->layers_at_first & DRIVERS_BIT) && !laboratory->answer(session).doing);
    CHECK(!strstr(laboratory->answer(session).detail, "drivers"));
    laboratory->set_layers(session, laboratory->layers_at_first | DRIVERS_BIT);
    CHECK(wait_for(session, "10 out"));
    CHECK(wait_for(session, "100 out"));
    headless("straight-corridor", 100, 1, NULL, said);
    CHECK(strstr(laboratory->answer(session).detail, said));
    CHECK(running_house_set(session, "profile.manual-chair.body.width", 0.60));
    laboratory->update(session, 0);
    CHECK(!strstr(laboratory->answer(session).detail, "100 out"));
    CHECK(wait_for(session, "100 out"));
    laboratory->set_layers(session, laboratory->layers_at_first);
    running_house_finish(session, 0);
    CHECK(!strstr(laboratory->answer(session).detail, "drivers"));
    laboratory->close(session);
}
