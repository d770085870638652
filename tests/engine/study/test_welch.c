#include "study/welch.h"

#include <math.h>

#include "check.h"
#include "study/montecarlo.h"

/* Values of the usual tables, to the last of their digits. */
TEST(student_s_quantiles_are_those_of_the_tables) {
    CHECK_NEAR(welch_student(0.975, 1), 12.7062047, 1e-6);
    CHECK_NEAR(welch_student(0.95, 1), 6.3137515, 1e-6);
    CHECK_NEAR(welch_student(0.975, 4), 2.7764451, 1e-6);
    CHECK_NEAR(welch_student(0.95, 10), 1.8124611, 1e-6);
    CHECK_NEAR(welch_student(0.975, 30), 2.0422725, 1e-6);
    CHECK_NEAR(welch_student(0.025, 30), -2.0422725, 1e-6);
    CHECK_NEAR(welch_student(0.975, 1e6), 1.9599664, 1e-5);
}

/* Equal deviations and counts: the degrees are 2 (n - 1), as in Student's own test. */
TEST(means_are_compared_as_by_hand) {
    WelchSample a = {10, 1, 5}, b = {12, 1, 5};
    Welch welch = welch_compare(&a, &b, 0.1);
    CHECK_NEAR(welch.degrees, 8, 1e-12);
    CHECK_NEAR(welch.t, 2 / sqrt(0.4), 1e-12);
    CHECK_NEAR(welch.high - welch.difference, 2.3060041 * sqrt(0.4), 1e-6);
    CHECK(welch.verdict == WELCH_DIFFERS);
    b.mean = 10.5;
    CHECK(welch_compare(&a, &b, 0.1).verdict == WELCH_CANNOT_TELL);
    a.deviation = b.deviation = 0.2;
    CHECK(welch_compare(&a, &b, 0.1).verdict == WELCH_AGREES);
}

TEST(too_few_runs_say_nothing) {
    WelchSample one = {10, 0, 1}, many = {11, 1, 50}, none = {0, 0, 0}, same = {10, 0, 5};
    CHECK(welch_compare(&one, &many, 0.1).verdict == WELCH_TOO_FEW);
    CHECK(welch_compare(&many, &none, 0.1).verdict == WELCH_TOO_FEW);
    CHECK(welch_compare(&same, &same, 0.1).verdict == WELCH_TOO_FEW);
    CHECK(isfinite(welch_compare(&same, &many, 0.1).t)); /* no deviation (b), but one (d) */
}

/* The examples of Newcombe, Two-sided confidence intervals for the single proportion, 1998, to their four digits. */
TEST(shares_have_the_limits_of_wilson) {
    static const struct {
        size_t good, all;
        double low, high;
    } known[] = {
        {81, 263, 0.2553, 0.3662}, {15, 148, 0.0624, 0.1605}, {0, 20, 0.0000, 0.1611}, {1, 29, 0.0061, 0.1718}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        Share share = montecarlo_share(known[k].good, known[k].all);
        CHECK_NEAR(share.low, known[k].low, 5.1e-5);
        CHECK_NEAR(share.high, known[k].high, 5.1e-5);
    }
    CHECK(isnan(montecarlo_share(0, 0).low) && isnan(montecarlo_share(0, 0).value));
}

/* Upper 2.5 and 5 % points of the usual tables. */
TEST(fisher_s_quantiles_are_those_of_the_tables) {
    CHECK_NEAR(welch_fisher(0.975, 10, 10), 3.7168, 5e-5);
    CHECK_NEAR(welch_fisher(0.95, 4, 20), 2.8661, 5e-5);
    CHECK_NEAR(welch_fisher(0.975, 4, 4), 9.6045, 5e-5);
    CHECK_NEAR(welch_fisher(0.95, 1, 8), welch_student(0.975, 8) * welch_student(0.975, 8), 1e-6);
    CHECK_NEAR(welch_fisher(0.025, 4, 10) * welch_fisher(0.975, 10, 4), 1, 1e-8);
}

TEST(deviations_are_compared_by_their_ratio) {
    WelchSample measured = {10, 1, 5}, simulated = {10, 2, 11}, one = {10, 0, 1}, same = {10, 0, 5};
    WelchScatter scatter = welch_scatter(&measured, &simulated);
    CHECK_NEAR(scatter.ratio, 2, 1e-12);
    CHECK_NEAR(scatter.low, 2 / sqrt(8.8439), 1e-4);  /* F with 10 and 4 degrees */
    CHECK_NEAR(scatter.high, 2 * sqrt(4.4683), 1e-4); /* with 4 and 10 */
    CHECK(isnan(welch_scatter(&one, &simulated).ratio) && isnan(welch_scatter(&same, &simulated).low));
}
