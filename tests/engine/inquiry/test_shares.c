#include "inquiry/shares.h"

#include <math.h>
#include <string.h>

#include "case.h"
#include "check.h"
#include "scratch.h"

static Population whm(void) {
    Population population = {0};
    Fault fault = {0};
    CHECK(population_read(&population, scratch_source("assets/populations/whm.json"), &fault));
    check_say(&fault);
    return population;
}

static void corridor_house(House *house, double width) {
    json_t *plan = case_corridor(width);
    case_add_person(plan, "manual-chair", 14, 0, 0);
    case_made(house, plan, -1, NULL);
}

/* Returns how many of the drivers have a body that this closed form lets through, with some more room all round. */
static size_t expected(const House *house, size_t count, double width, double more, bool corner) {
    Population population = whm();
    size_t through = 0;
    for (size_t k = 1; k <= count; k++) {
        Profile body = *house->people[0].profile;
        population_draw(&population, k, house->seed, &body);
        double w = body.width - 2 * more, longest = corner ? 2 * (M_SQRT2 * width - w) : HUGE_VAL;
        through += w <= width && body.length - 2 * more <= longest;
    }
    population_free(&population);
    return through;
}

static Shares find(const House *house, size_t count, int jobs, const Stop *stop) {
    Population population = whm();
    Shares shares;
    shares_find(&shares, house, &population, count, SIZE_MAX, jobs, stop);
    population_free(&population);
    return shares;
}

static size_t fit(const Shares *shares) {
    return shares->drivers - shares->count[PASSAGE_NONE];
}

TEST(a_corridor_lets_those_through_who_are_narrower) {
    enum { COUNT = 60 };
    House house;
    corridor_house(&house, 0.66);
    Shares shares = find(&house, COUNT, 1, NULL), again = find(&house, COUNT, 3, NULL);
    CHECK(shares.drivers == COUNT && shares.tried < COUNT / 2 && !shares.interrupted);
    CHECK(fit(&shares) >= expected(&house, COUNT, 0.66, -0.004, false));
    CHECK(fit(&shares) <= expected(&house, COUNT, 0.66, 0.004, false));
    CHECK(shares.count[PASSAGE_DRIVES] <= fit(&shares));
    CHECK(shares.count[PASSAGE_DRIVES] >= expected(&house, COUNT, 0.66, -0.006, false));
    CHECK(shares.refused > 0 && *shares.what);
    CHECK(memcmp(again.count, shares.count, sizeof shares.count) == 0 && again.tried == shares.tried);
    CHECK(again.refused == shares.refused && strcmp(again.what, shares.what) == 0);
    house_free(&house);
}

TEST(nobody_is_counted_after_an_interruption) {
    House house;
    corridor_house(&house, 0.66);
    Stop stop = {0};
    stop_request(&stop);
    Shares shares = find(&house, 10, 1, &stop);
    CHECK(shares.interrupted && shares.drivers == 10 && fit(&shares) == 10);
    CHECK(shares.count[PASSAGE_DRIVES] == 0);
    house_free(&house);
}

TEST(who_is_not_of_the_population_has_no_shares) {
    House house;
    json_t *plan = case_corridor(0.9);
    case_add_person(plan, "electric-chair", 14, 0, 0);
    case_made(&house, plan, -1, NULL);
    Shares shares = find(&house, 5, 1, NULL);
    CHECK(shares.drivers == 0 && shares.tried == 0 && !shares.interrupted);
    house_free(&house);
}

/* A body longer than the legs are wide turns if l <= 2 (sqrt(2) W - w) (route.h). */
LONG_TEST(a_corner_lets_those_through_whom_the_closed_form_lets_through) {
    enum { COUNT = 24 };
    House house;
    case_house(&house, "corner-1.00-1.00", -1, (const char *const[]){"profile.manual-chair.drive.skid_time=0", NULL});
    Shares shares = find(&house, COUNT, 2, NULL);
    CHECK(fit(&shares) >= expected(&house, COUNT, 1.0, -0.004, true));
    CHECK(fit(&shares) <= expected(&house, COUNT, 1.0, 0.004, true));
    CHECK(shares.count[PASSAGE_DRIVES] <= fit(&shares) && shares.count[PASSAGE_SKIDS] == 0);
    house_free(&house);
}
