#include "check.h"

#include <math.h>
#include <stdint.h>

#include "base/random.h"
#include "rooms.h"
#include "route/fit.h"

/* Returns the longest rectangle of a width that turns from W1 into W2. */
static double longest(double width, double w1, double w2) {
    double least = HUGE_VAL;
    for (int i = 1; i < 4000; i++) {
        double t = M_PI_2 * i / 4000;
        least = fmin(least, (w1 * cos(t) + w2 * sin(t) - width) / (sin(t) * cos(t)));
    }
    return least;
}

LONG_TEST(fits_flips_within_a_centimetre_of_the_closed_form) {
    Random random = random_seed(7, 1);
    int tried = 0, wrong_above = 0, wrong_below = 0;
    while (tried < 200) {
        double width = 0.4 + 0.4 * random_uniform(&random), w2 = width + 0.05 + 0.6 * random_uniform(&random);
        double length = 0.8 + 0.8 * random_uniform(&random), low = width, high = 3;
        if (longest(width, high, w2) < length || longest(width, low, w2) > length)
            continue;
        while (high - low > 1e-6) {
            double w1 = (low + high) / 2;
            if (longest(width, w1, w2) < length)
                low = w1;
            else
                high = w1;
        }
        if (high < width + 0.05 || fmax(high, w2) + 0.02 > length)
            continue; /* shorter bodies may slide sideways */
        tried++;
        for (int side = -1; side <= 1; side += 2) {
            Rooms fixture;
            rooms_make_corner(&fixture, length, width, high + 0.01 * side, w2 + 0.01 * side, false);
            double margin = rooms_fit_margin(&fixture);
            wrong_above += side > 0 && margin < 0;
            wrong_below += side < 0 && margin >= 0;
            rooms_free(&fixture);
        }
    }
    CHECK_NEAR(wrong_above, 0, 0);
    CHECK_NEAR(wrong_below, 0, 0);
}

/* Returns the margin of the chair in a corner of two passages of one width: grown by m on every side,
 * l + 2 m = 2 (sqrt(2) W - w - 2 m). At its start it has 5 cm. */
static double margin_in_corner(double passage) {
    return fmin((2 * (M_SQRT2 * passage - 0.63) - 1.1) / 6, ROOMS_FIT_MOST);
}

TEST(fits_margin_in_a_corner_has_a_closed_form) {
    for (double w = 0.80; w < 0.95; w += 0.04) {
        Rooms fixture;
        rooms_make_corner(&fixture, 1.1, 0.63, w, w, false);
        CHECK_NEAR(rooms_fit_margin(&fixture), margin_in_corner(w), 0.002);
        rooms_free(&fixture);
    }
}

TEST(fits_margin_is_the_same_in_turned_shifted_and_mirrored_copies) {
    const double angles[] = {radians(10), radians(45), radians(113)};
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
        double w = 0.82 + 0.015 * (double)i; /* from below the limit, 0.834 m, to above it */
        Rooms fixture;
        rooms_make_corner(&fixture, 1.1, 0.63, w, w, i == 1);
        rooms_turn(&fixture, angles[i], vec2(1000.0 * (double)i, 0.037));
        CHECK_NEAR(rooms_fit_margin(&fixture), margin_in_corner(w), 0.002);
        rooms_free(&fixture);
    }
}

TEST(a_body_fits_where_it_can_be_driven_by_via_points) {
    Rooms fixture;
    rooms_make_two(&fixture, 0.63, 0.70, DOOR_OPEN);
    Rectangle body = search_body(fixture.query.profile);
    Goal exit = field_exit_goal(SIZE_MAX, 0, 0);
    Goal goals[] = {
        {.at = {1, 2.2}, .radius = 0.55, .exit = SIZE_MAX}, {.at = {4, 2.2}, .radius = 0.55, .exit = SIZE_MAX}, exit};
    FitPlace tightest;
    CHECK(fit_margin(&fixture.query, &body, goals, 3, -0.1, 0.1, &tightest) == FIT_KNOWN);
    CHECK_NEAR(tightest.margin + FIT_RESOLUTION / 2, 0.035, 0.002);
    CHECK_NEAR(vec2_distance(tightest.centre, vec2(3, 1.5)), 0, 0.7);
    rooms_free(&fixture);
}
