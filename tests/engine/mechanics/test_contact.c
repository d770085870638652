#include <math.h>

#include "check.h"
#include "mechanics/contact.h"

static ContactLaw law_of(double mass, double stiffness, double damping_ratio) {
    return (ContactLaw){.normal_stiffness = stiffness, .normal_damping = 2 * damping_ratio * sqrt(mass * stiffness)};
}

TEST(an_open_gap_has_no_force) {
    ContactLaw law = law_of(80, 20000, 0.5);
    CHECK(contact_normal(&law, 0, -3) == 0);
    CHECK(contact_normal(&law, 1e-9, -3) == 0);
}

TEST(a_closed_gap_never_pulls) {
    ContactLaw law = law_of(80, 20000, 0.5);
    for (double rate = -5; rate <= 5; rate += 0.01)
        for (double gap = -0.05; gap < 0.01; gap += 0.001)
            CHECK(contact_normal(&law, gap, rate) >= 0);
}

/* One collision, released at zero force: e = exp(-z t_c), t_c = (pi - atan2(2 z w, w^2 - z^2)) / w, w = sqrt(1 - z^2).
 */
TEST(restitution_is_the_closed_form_of_release_at_zero_force) {
    const double ratios[] = {0.01, 0.05, 0.1, 0.2, 0.5};
    const double expected[] = {0.969265, 0.858758, 0.744079, 0.571740, 0.298436};
    for (int i = 0; i < 5; i++) {
        const double mass = 80.2, stiffness = 20000, dt = 1e-6;
        ContactLaw law = law_of(mass, stiffness, ratios[i]);
        double gap = 0, rate = -1;
        do {
            rate += contact_normal(&law, gap - 1e-15, rate) / mass * dt;
            gap += rate * dt;
        } while (gap < 0 && contact_normal(&law, gap, rate) > 0);
        CHECK_NEAR(rate, expected[i], 2e-4);
    }
}

TEST(friction_opposes_sliding_and_stays_within_its_limit) {
    ContactLaw law = {.tangential_stiffness = 5000, .tangential_damping = 900, .friction = 0.3};
    double slip = 0, previous = 0;
    for (int i = 0; i < 1000; i++) {
        double force = contact_tangential(&law, 100, 0.2, 1e-3, &slip);
        CHECK(force <= 0 && force >= -30 - 1e-12);
        CHECK(force <= previous + 1e-12);
        previous = force;
    }
    CHECK_NEAR(previous, -30, 1e-9);
    /* After a reversal, a slipped spring yields at once instead of unwinding first. */
    double force = contact_tangential(&law, 100, -0.2, 1e-3, &slip);
    CHECK(force > -30);
}

TEST(a_held_load_creeps_nowhere) {
    ContactLaw law = {.tangential_stiffness = 5000, .tangential_damping = 900, .friction = 0.3};
    double slip = 0, position = 0, speed = 0;
    const double mass = 80, load = 20, dt = 1e-3;
    for (int i = 0; i < 20000; i++) {
        speed += (load + contact_tangential(&law, 100, speed, dt, &slip)) / mass * dt;
        position += speed * dt;
    }
    CHECK_NEAR(position, load / law.tangential_stiffness, 1e-9);
    CHECK_NEAR(speed, 0, 1e-12);
}

TEST(the_longest_step_is_the_edge_of_stability) {
    const double mass = 80.2;
    ContactLaw law = {.normal_stiffness = 20000, .normal_damping = 1791.4};
    double longest = contact_longest_step(&law, mass, 1);
    for (int above = 0; above < 2; above++) {
        double dt = longest * (above ? 1.01 : 0.99), x = 1, v = 0;
        for (int i = 0; i < 20000 && fabs(x) < 1e6; i++) {
            v += (-law.normal_stiffness * x - law.normal_damping * v) / mass * dt;
            x += v * dt;
        }
        CHECK((fabs(x) > 1e5) == above);
    }
}

TEST(between_two_laws_acts_their_mean) {
    const ContactLaw hard = {30000, 1800, 9000, 500, 0.5}, soft = {10000, 600, 1000, 100, 0.1};
    for (int turned = 0; turned < 2; turned++) {
        ContactLaw mean = turned ? contact_mean(&soft, &hard) : contact_mean(&hard, &soft);
        CHECK(mean.normal_stiffness == 20000);
        CHECK(mean.normal_damping == 1200);
        CHECK(mean.tangential_stiffness == 5000);
        CHECK(mean.tangential_damping == 300);
        CHECK(mean.friction == 0.3);
        for (double gap = -0.02; gap < 0; gap += 0.005) {
            double both = contact_normal(&hard, gap, -0.2) + contact_normal(&soft, gap, -0.2);
            CHECK_NEAR(contact_normal(&mean, gap, -0.2), both / 2, 1e-9);
        }
    }
}
