#include "plan/population.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/normal.h"
#include "check.h"
#include "scratch.h"

static Profile manual_chair(void) {
    Profile profile = {0};
    Fault fault = {0};
    CHECK(profile_read(&profile, scratch_source("assets/profiles/manual-chair.json"), &fault));
    check_say(&fault);
    return profile;
}

static Population shipped(const char *name) {
    char path[100];
    Population population = {0};
    Fault fault = {0};
    snprintf(path, sizeof path, "assets/populations/%s.json", name);
    CHECK(population_read(&population, scratch_source(path), &fault));
    check_say(&fault);
    return population;
}

TEST(quantiles_of_the_normal_distribution_are_those_of_the_tables) {
    CHECK_NEAR(normal_quantile(0.5), 0, 1e-15);
    CHECK_NEAR(normal_quantile(0.975), 1.959963984540054, 3e-9);
    CHECK_NEAR(normal_quantile(0.05), -1.644853626951473, 3e-9);
    CHECK_NEAR(normal_quantile(0.001), -3.090232306167814, 5e-9);
    CHECK_NEAR(normal_quantile(1 - 1e-6), 4.753424308822899, 6e-9);
}

TEST(drivers_differ_as_the_population_says) {
    enum { DRIVERS = 2000 };
    Profile chair = manual_chair();
    Population population = shipped("manual-jp");
    double sum = 0, squares = 0, log_speed = 0, log_push = 0, both = 0;
    for (size_t k = 1; k <= DRIVERS; k++) {
        Profile own = chair;
        PopulationStart start = population_draw(&population, k, 1, &own);
        CHECK(fabs(start.x) <= 0.06 && fabs(start.y) <= 0.06 && fabs(start.heading) <= 0.105);
        CHECK(own.caution >= 1.5 && own.caution <= 4.5 && own.hands >= 0);
        sum += own.free_speed;
        squares += own.free_speed * own.free_speed;
        log_speed += log(own.free_speed / 0.615) * log(own.free_speed / 0.615);
        log_push += log(own.push / chair.push) * log(own.push / chair.push);
        both += log(own.free_speed / 0.615) * log(own.push / chair.push);
    }
    double mean = sum / DRIVERS;
    CHECK_NEAR(mean, 0.69, 0.01); /* Boyce et al. 1999 */
    CHECK_NEAR(sqrt(squares / DRIVERS - mean * mean), 0.35, 0.02);
    CHECK_NEAR(both / sqrt(log_speed * log_push), 0.5, 0.06); /* rho, a little less for the spread between runs */
    Profile nominal = chair;
    PopulationStart start = population_draw(&population, 0, 1, &nominal);
    CHECK(memcmp(&nominal, &chair, sizeof chair) == 0 && start.x == 0 && start.y == 0 && start.heading == 0);
    population_free(&population);
    profile_free(&chair);
}

/* A rectangle turns the corner from W into W exactly when length + 2 width <= 2 sqrt(2) W; Steinfeld: "less than 80 %"
 * at 0.915 m, 50 % at 0.85 m, 95 % at 1.00 m. */
TEST(as_many_chairs_fit_round_a_corner_as_were_counted) {
    enum { DRIVERS = 2000 };
    Profile chair = manual_chair();
    Population population = shipped("whm");
    const double widths[] = {0.85, 0.915, 1.00, 1.10};
    const double shares[] = {0.50, 0.76, 0.95, 1.00}, near[] = {0.03, 0.03, 0.02, 0.01};
    for (int w = 0; w < 4; w++) {
        int fit = 0;
        for (size_t k = 1; k <= DRIVERS; k++) {
            Profile own = chair;
            population_draw(&population, k, 1, &own);
            fit += own.length + 2 * own.width <= 2 * M_SQRT2 * widths[w];
        }
        CHECK_NEAR((double)fit / DRIVERS, shares[w], near[w]);
    }
    population_free(&population);
    profile_free(&chair);
}

/* Rows in the opposite order, and a row that changes nothing, leave each driver as it is. */
TEST(a_row_disturbs_no_other) {
    Profile chair = manual_chair();
    Population population = shipped("manual-jp"), changed = shipped("manual-jp");
    PopulationRow *rows = memory_zeroed(population.count + 1, sizeof *rows);
    rows[0] = population.rows[0];
    rows[0].name = "body.mass";
    for (size_t r = 0; r < profile_table()->count; r++)
        if (strcmp(profile_table()->rows[r].name, "body.mass") == 0)
            rows[0].profile = &profile_table()->rows[r];
    rows[0].law = LAW_FACTOR;
    rows[0].middle = 1;
    rows[0].spread = 0;
    rows[0].low = -HUGE_VAL;
    rows[0].high = HUGE_VAL;
    for (size_t r = 0; r < population.count; r++)
        rows[population.count - r] = population.rows[r];
    memory_free(changed.rows);
    changed.rows = rows;
    changed.count = population.count + 1;
    for (size_t k = 1; k <= 50; k++) {
        Profile one = chair, other = chair;
        PopulationStart start = population_draw(&population, k, 1, &one);
        PopulationStart moved = population_draw(&changed, k, 1, &other);
        CHECK(memcmp(&one, &other, sizeof one) == 0 && memcmp(&start, &moved, sizeof start) == 0);
    }
    population_free(&changed);
    population_free(&population);
    profile_free(&chair);
}

TEST(bad_populations_are_told_with_their_places) {
    Population population = {0};
    Fault fault = {0};
    CHECK(!population_read(&population, scratch_source("tests/data/bad/populations/nothing.json"), &fault));
    CHECK(fault.total == 1 && strstr(fault.lines[0], ":1:1: rows must be a list of 1 to 30 rows"));
    fault_clear(&fault);
    CHECK(!population_read(&population, scratch_source("tests/data/bad/populations/rows.json"), &fault));
    static const char *const told[] = {"no \"profile\"",     "row is \"body.breadth\"", "law is \"uniform\"",
                                       "level is \"crowd\"", "mean must be a number",   "no spread of at least 0",
                                       "\"spread\"",         "no \"provenance\"",       "a row must be an object",
                                       "a second row",       "low is 80, must be"};
    for (size_t t = 0; t < sizeof told / sizeof *told; t++) {
        bool found = false;
        for (size_t f = 0; f < fault.count; f++)
            found |= strstr(fault.lines[f], told[t]) != NULL;
        if (!found)
            printf("not told: %s\n", told[t]);
        CHECK(found);
    }
    fault_clear(&fault);
    CHECK(!population.rows);
}
