#include "study/welch.h"

#include <math.h>

#include "check.h"

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
