/* Tests the deviations within and between groups against a textbook example and against drawn numbers. */
#include <math.h>
#include <stddef.h>

#include "check.h"
#include "study/random_effects.h"

TEST(deviations_are_those_of_the_mean_squares) {
    /* three groups: means 2, 5, 11; MSW = (2 + 2 + 2) / 3 = 2; MSB = 2 (16 + 1 + 25) / 2 = 42; n0 = 2 */
    static const double values[] = {1, 3, 4, 6, 10, 12};
    static const size_t groups[] = {0, 0, 1, 1, 2, 2};
    RandomEffects found = random_effects_of(values, groups, 6);
    CHECK(found.groups == 3);
    CHECK_NEAR(found.within, sqrt(2), 1e-12);
    CHECK_NEAR(found.between, sqrt(20), 1e-12);
}

TEST(groups_that_differ_less_than_chance_have_no_deviation_of_their_own) {
    static const double values[] = {1, 9, 2, 8};
    static const size_t groups[] = {0, 0, 1, 1};
    CHECK(random_effects_of(values, groups, 4).between == 0);
}

TEST(one_value_of_each_group_or_one_group_tells_no_more_than_it_can) {
    static const double values[] = {1, 2, 4};
    static const size_t each[] = {0, 1, 2}, one[] = {0, 0, 0};
    CHECK(isnan(random_effects_of(values, each, 3).within) && isnan(random_effects_of(values, each, 3).between));
    CHECK_NEAR(random_effects_of(values, one, 3).within, sqrt(7.0 / 3), 1e-12);
    CHECK(isnan(random_effects_of(values, one, 3).between));
    CHECK(random_effects_of(values, each, 0).groups == 0);
}
