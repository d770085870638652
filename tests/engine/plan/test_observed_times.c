/* Tests what the measured runs of a route say: mean and deviation of its times, and what contradicts them. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "plan/observed_times.h"

static double times[] = {10, 11, 12, 15};
static const char *people[] = {"b", "a", "b", "c"};

TEST(mean_and_deviation_follow_from_the_times) {
    ObservedTimes of_times = observed_times_of(&(Observed){.runs = 1, .times = {times, 4}, .touches = -1});
    CHECK_NEAR(of_times.mean, 12, 1e-12);
    CHECK_NEAR(of_times.deviation, sqrt(14.0 / 3), 1e-12);
    CHECK(of_times.runs == 4);
    ObservedTimes given = observed_times_of(&(Observed){.mean = 9, .deviation = 2, .runs = 5, .touches = -1});
    CHECK(given.mean == 9 && given.deviation == 2 && given.runs == 5);
    ObservedTimes one = observed_times_of(&(Observed){.runs = 1, .times = {times, 1}, .touches = -1});
    CHECK(one.mean == 10 && one.deviation == 0 && one.runs == 1);
    CHECK(observed_times_of(&(Observed){.runs = 1, .touches = -1}).runs == 0);
}

TEST(people_are_numbered_in_the_order_in_which_they_first_drive) {
    const Observed observed = {.times = {times, 4}, .drivers = {people, 4}};
    static const size_t expected[] = {0, 1, 0, 2};
    for (size_t i = 0; i < 4; i++)
        CHECK(observed_times_person(&observed, i) == expected[i]);
}

TEST(a_rounded_mean_agrees_with_its_times_and_another_one_is_a_fault) {
    static const struct {
        Observed observed;
        const char *says; /* NULL: agrees */
    } cases[] = {
        {{.runs = 1, .touches = -1}, NULL},
        {{.mean = 12.04, .runs = 1, .times = {times, 4}, .touches = -1}, NULL},
        {{.mean = 12.06, .runs = 1, .times = {times, 4}, .touches = -1}, "must be that of its times, 12.000 s"},
        {{.deviation = 2.2, .runs = 4, .times = {times, 4}, .touches = 4}, NULL},
        {{.deviation = 2, .runs = 1, .times = {times, 4}, .touches = -1}, "must be that of its times, 2.160 s"},
        {{.runs = 5, .times = {times, 4}, .touches = -1}, "5 runs and 4 times"},
        {{.runs = 1, .times = {times, 4}, .drivers = {people, 3}, .touches = -1}, "3 drivers and 4 times"},
        {{.mean = 9, .runs = 2, .touches = 3}, "3 touches, must be at most its 2 runs"},
        {{.deviation = 1, .runs = 1, .touches = -1}, "neither \"mean\" nor \"times\""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char fault[200];
        bool good = observed_times_check(&cases[i].observed, fault, sizeof fault);
        CHECK(good == !cases[i].says);
        CHECK(good || strstr(fault, cases[i].says));
    }
}
