/* Elementary functions beside the C library's with 64 bits of mantissa, and what needs no reference: special values,
 * symmetries, identities. bench_real does the same with more arguments. */
#include "base/real.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "accuracy.h"
#include "check.h"

enum { ARGUMENTS = 1000000 };

/* As numbers and by sign: -0 is not 0, and NaN is NaN. */
static bool same(double a, double b) {
    return isnan(a) ? isnan(b) : a == b && !signbit(a) == !signbit(b);
}

TEST(every_function_is_within_one_unit_in_the_last_place) {
    for (size_t i = 0; i < accuracy_count; i++) {
        Accuracy found = accuracy_measure(&accuracy_list[i], ARGUMENTS / 4);
        if (!(found.worst < 0.8))
            check_true(false, accuracy_list[i].name, __FILE__, __LINE__);
        CHECK_NEAR(found.worst, 0, 0.8);
    }
}

TEST(sine_cosine_of_special_angles) {
    CHECK(same(real_sin(0), 0) && same(real_sin(-0.0), -0.0) && real_cos(0) == 1 && real_cos(-0.0) == 1);
    CHECK(isnan(real_sin(HUGE_VAL)) && isnan(real_cos(-HUGE_VAL)) && isnan(real_sin(NAN)) && isnan(real_cos(NAN)));
    CHECK(real_sin(DBL_TRUE_MIN) == DBL_TRUE_MIN);
    CHECK(real_sin(M_PI_2) == 1 && real_cos(M_PI) == -1 && real_sin(-M_PI_2) == -1);
    /* what pi lacks, rounded to double, is its sine */
    CHECK(real_sin(M_PI) == 0x1.1a62633145c07p-53);
    CHECK(real_cos(M_PI_2) == 0x1.1a62633145c07p-54);
    /* known for being the double nearest to a multiple of pi/2 */
    CHECK_NEAR(real_cos(0x1.6ac5b262ca1ffp+849) / -4.687165924254628e-19, 1, 1e-15);
}

TEST(sine_is_odd_and_cosine_is_even_to_the_bit) {
    uint64_t state = 1;
    for (int i = 0; i < ARGUMENTS; i++) {
        double x = accuracy_spread(&state, -30, i % 2 ? 10 : 1023);
        SineCosine turn = real_sincos(x), back = real_sincos(-x);
        if (turn.sine != -back.sine || turn.cosine != back.cosine || turn.sine != real_sin(x) ||
            turn.cosine != real_cos(x)) {
            CHECK_NEAR(x, 0, 0);
            return;
        }
    }
}

TEST(the_squares_of_sine_and_cosine_add_up_to_one) {
    uint64_t state = 2;
    double worst = 0;
    for (int i = 0; i < ARGUMENTS; i++) {
        SineCosine turn = real_sincos(accuracy_spread(&state, -30, 1023));
        worst = fmax(worst, fabs(turn.sine * turn.sine + turn.cosine * turn.cosine - 1));
    }
    CHECK_NEAR(worst, 0, 2 * DBL_EPSILON);
}

TEST(the_angle_of_a_point_on_an_axis_or_at_the_end_of_numbers) {
    CHECK(same(real_atan2(0, 1), 0) && same(real_atan2(-0.0, 1), -0.0));
    CHECK(same(real_atan2(0, 0), 0) && same(real_atan2(-0.0, 0), -0.0));
    CHECK(real_atan2(0, -0.0) == M_PI && real_atan2(-0.0, -0.0) == -M_PI);
    CHECK(real_atan2(0, -3) == M_PI && real_atan2(-0.0, -3) == -M_PI);
    CHECK(real_atan2(1, 0) == M_PI_2 && real_atan2(-1, 0) == -M_PI_2 && real_atan2(2, -0.0) == M_PI_2);
    CHECK(real_atan2(1, 1) == M_PI_4 && real_atan2(-5, 5) == -M_PI_4 && real_atan2(1, -1) == 3 * M_PI_4);
    CHECK(real_atan2(HUGE_VAL, HUGE_VAL) == M_PI_4 && real_atan2(HUGE_VAL, -HUGE_VAL) == 3 * M_PI_4);
    CHECK(real_atan2(HUGE_VAL, 1) == M_PI_2 && real_atan2(1, -HUGE_VAL) == M_PI &&
          same(real_atan2(-1, HUGE_VAL), -0.0));
    CHECK(isnan(real_atan2(NAN, 1)) && isnan(real_atan2(1, NAN)) && isnan(real_atan2(HUGE_VAL, NAN)));
    CHECK(real_atan2(DBL_TRUE_MIN, DBL_MAX) == 0 && real_atan2(DBL_MAX, DBL_TRUE_MIN) == M_PI_2);
    CHECK(real_atan2(DBL_TRUE_MIN, DBL_TRUE_MIN) == M_PI_4 && real_atan2(DBL_MAX, DBL_MAX) == M_PI_4);
    CHECK(same(real_atan(-0.0), -0.0) && real_atan(HUGE_VAL) == M_PI_2 && real_atan(-1) == -M_PI_4);
}

TEST(a_mirrored_point_has_the_mirrored_angle_to_the_bit) {
    uint64_t state = 3;
    for (int i = 0; i < ARGUMENTS; i++) {
        double x = accuracy_spread(&state, -20, 20), y = accuracy_spread(&state, -20, 20);
        if (real_atan2(y, x) != -real_atan2(-y, x) || real_atan2(y, x) != real_atan2(4 * y, 4 * x)) {
            CHECK_NEAR(y, x, 0);
            return;
        }
    }
}

TEST(the_angle_of_a_direction_is_the_one_it_was_made_of) {
    double worst = 0;
    for (int i = -31415; i <= 31415; i++) {
        SineCosine turn = real_sincos(i * 1e-4);
        worst = fmax(worst, fabs(real_atan2(turn.sine, turn.cosine) - i * 1e-4));
    }
    CHECK_NEAR(worst, 0, 2 * DBL_EPSILON);
}

TEST(arcsine_and_arccosine_at_their_ends) {
    CHECK(same(real_asin(0), 0) && same(real_asin(-0.0), -0.0) && real_asin(1) == M_PI_2 && real_asin(-1) == -M_PI_2);
    CHECK(same(real_acos(1), 0) && real_acos(-1) == M_PI && real_acos(0) == M_PI_2);
    CHECK(isnan(real_asin(1.0000001)) && isnan(real_acos(-2)) && isnan(real_asin(NAN)) && isnan(real_acos(HUGE_VAL)));
    CHECK_NEAR(real_asin(0.5), M_PI / 6, DBL_EPSILON / 2);
    CHECK_NEAR(real_acos(0.5), M_PI / 3, DBL_EPSILON);
}

TEST(a_length_overflows_only_if_it_is_too_long) {
    CHECK(real_hypot(3, -4) == 5 && real_hypot(0x5p+1010, 0xcp+1010) == 0xdp+1010 && real_hypot(0, -0.0) == 0);
    CHECK(real_hypot(3 * DBL_TRUE_MIN, 4 * DBL_TRUE_MIN) == 5 * DBL_TRUE_MIN);
    CHECK(real_hypot(DBL_MAX, DBL_MAX) == HUGE_VAL && real_hypot(DBL_MAX, 1) == DBL_MAX);
    CHECK(real_hypot(NAN, -HUGE_VAL) == HUGE_VAL && isnan(real_hypot(NAN, 1)) && real_hypot(-7, 0) == 7);
}

TEST(exponential_and_logarithm_at_their_ends) {
    CHECK(real_exp(0) == 1 && real_exp(-0.0) == 1 && real_exp(HUGE_VAL) == HUGE_VAL && real_exp(-HUGE_VAL) == 0);
    CHECK(real_exp(709.79) == HUGE_VAL && isfinite(real_exp(709.78)) && real_exp(-745.14) == 0);
    CHECK(real_exp(-745.13) == DBL_TRUE_MIN && isnan(real_exp(NAN)));
    CHECK(same(real_log(1), 0) && real_log(0) == -HUGE_VAL && real_log(-0.0) == -HUGE_VAL);
    CHECK(real_log(HUGE_VAL) == HUGE_VAL && isnan(real_log(-1)) && isnan(real_log(-HUGE_VAL)) && isnan(real_log(NAN)));
    CHECK(real_log(2) == M_LN2 && real_log(M_E) == 1 && real_log(0.5) == -M_LN2);
    CHECK_NEAR(real_log(DBL_TRUE_MIN), -1074 * M_LN2, 1e-12);
    CHECK(same(real_log1p(0), 0) && same(real_log1p(-0.0), -0.0) && real_log1p(-1) == -HUGE_VAL);
    CHECK(isnan(real_log1p(-1.5)) && isnan(real_log1p(NAN)) && real_log1p(HUGE_VAL) == HUGE_VAL);
    CHECK(real_log1p(1e-300) == 1e-300 && real_log1p(1) == M_LN2 && real_log1p(DBL_MAX) == real_log(DBL_MAX));
}

TEST(the_logarithm_of_a_product_of_powers_of_two_is_their_number) {
    for (int k = -1022; k <= 1023; k++)
        CHECK_NEAR(real_log(ldexp(1, k)), (double)((long double)k * 0.693147180559945309417232L), 0);
    for (int k = -70; k <= 70; k++)
        CHECK_NEAR(real_log(real_exp(k * 10)), k * 10, 2 * DBL_EPSILON);
}

TEST(powers_of_ten_are_the_nearest_numbers) {
    for (int k = 0; k <= 22; k++) {
        CHECK(real_power_of_ten(k) == (double)powl(10, k));
        CHECK(real_power_of_ten(-k) == (double)(1 / powl(10, k)));
    }
}
