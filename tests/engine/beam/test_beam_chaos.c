#include <math.h>

#include "beam/beam_cycle.h"
#include "check.h"
#include "oscillator.h"

enum { STATES_MOST = 128 };

/* The logistic map after a transient. */
static void logistic(double parameter, double *series, size_t count) {
    double x = 0.3;
    for (int i = 0; i < 1000; i++)
        x = parameter * x * (1 - x);
    for (size_t i = 0; i < count; i++)
        series[i] = x = parameter * x * (1 - x);
}

TEST(the_zero_one_test_tells_the_logistic_maps_orders_from_its_chaos) {
    enum { COUNT = 2000 };
    static const double parameters[] = {3.55, 3.97}, expected[] = {0, 0.998}, digit[] = {0.01, 0.001};
    for (int k = 0; k < 2; k++) {
        double series[COUNT];
        logistic(parameters[k], series, COUNT);
        CHECK_NEAR(chaos_zero_one(series, COUNT), expected[k], digit[k] / 2);
    }
}

TEST(the_exponent_of_the_logistic_map_at_four_is_the_logarithm_of_two) {
    enum { COUNT = 20000 };
    double growth[COUNT], x = 0.3;
    for (int i = 0; i < COUNT; i++) {
        growth[i] = log(fabs(4 - 8 * x));
        x = 4 * x * (1 - x);
    }
    ChaosExponent exponent = chaos_exponent(growth, COUNT);
    CHECK_NEAR(exponent.value, log(2), 4 * exponent.error);
    CHECK(exponent.error > 0 && exponent.error < 0.02);
}

/* Lorenz's equations ---------------------------------------------------------------------------------------------- */

enum { LORENZ = 3, LORENZ_ALL = LORENZ * (1 + LORENZ) /* the state, then tangents */ };

/* Computes x' = 10 (y - x), y' = x (28 - z) - y, z' = x y - 8/3 z, and the derivatives of the tangents. */
static void lorenz_rates(const double *at, double *rate) {
    double x = at[0], y = at[1], z = at[2];
    rate[0] = 10 * (y - x);
    rate[1] = x * (28 - z) - y;
    rate[2] = x * y - 8.0 / 3 * z;
    for (int t = LORENZ; t < LORENZ_ALL; t += LORENZ) {
        rate[t] = 10 * (at[t + 1] - at[t]);
        rate[t + 1] = at[t] * (28 - z) - x * at[t + 2] - at[t + 1];
        rate[t + 2] = at[t] * y + x * at[t + 1] - 8.0 / 3 * at[t + 2];
    }
}

/* Makes a fourth-order Runge-Kutta step. */
static void lorenz_step(double *at, double step) {
    static const double part[] = {0, 0.5, 0.5, 1}, weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    double rate[LORENZ_ALL] = {0}, begin[LORENZ_ALL], probe[LORENZ_ALL];
    for (int i = 0; i < LORENZ_ALL; i++)
        begin[i] = at[i];
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < LORENZ_ALL; i++)
            probe[i] = begin[i] + part[k] * step * rate[i];
        lorenz_rates(probe, rate);
        for (int i = 0; i < LORENZ_ALL; i++)
            at[i] += weight[k] * step * rate[i];
    }
}

/* A motion with two modes lends the memory of its tangents, four numbers each; the last stays 0. */
static void renew_lorenz(Motion *room, double *at, double *growth) {
    for (int t = 0; t < LORENZ; t++) {
        double tangent[LORENZ + 1] = {at[LORENZ * (1 + t)], at[LORENZ * (1 + t) + 1], at[LORENZ * (1 + t) + 2], 0};
        motion_set_tangent(room, (size_t)t, tangent);
    }
    CycleMotion same = beam_cycle_motion(room);
    chaos_renew_tangents(&same, growth);
    for (int t = 0; t < LORENZ; t++) {
        double tangent[LORENZ + 1];
        motion_tangent(room, (size_t)t, tangent);
        for (int i = 0; i < LORENZ; i++)
            at[LORENZ * (1 + t) + i] = tangent[i];
    }
}

TEST(lorenzs_equations_have_their_exponents) {
    enum { COUNT = 10000, STEPS = 400 /* steps of 0.0025 s per renewal */ };
    static double largest[COUNT];
    double at[LORENZ_ALL] = {1, 1, 20, 1, 0, 0, 0, 1, 0, 0, 0, 1}, growth[LORENZ] = {0};
    Rig rig = oscillator_beam_rig("ibs", "beam.modes=2");
    Motion room = motion_create(&rig, LORENZ);
    for (int i = -50; i < COUNT; i++) { /* the first renewals approach the attractor */
        double before = growth[0];
        for (int s = 0; s < STEPS; s++)
            lorenz_step(at, 0.0025);
        renew_lorenz(&room, at, growth);
        if (i >= 0)
            largest[i] = growth[0] - before;
        else
            growth[0] = growth[1] = growth[2] = 0;
    }
    ChaosExponent exponent = chaos_exponent(largest, COUNT);
    CHECK_NEAR(exponent.value, 0.9056, 3 * exponent.error);
    CHECK(exponent.error > 1e-5 && exponent.error < 2e-3);
    CHECK_NEAR(growth[1] / COUNT, 0, 1e-3);
    CHECK_NEAR((growth[0] + growth[1] + growth[2]) / COUNT, -(10 + 1 + 8.0 / 3), 1e-6);
    motion_destroy(&room);
    rig_clear(&rig);
}

/* Beams ----------------------------------------------------------------------------------------------------------- */

/* In half its own period the mode reverses every tangent and shrinks it by exp(-zeta omega T). */
TEST(a_damped_mode_has_exactly_the_exponent_minus_zeta_omega) {
    static const double ratios[] = {0, 0.001, 0.07, 0.5, 0.9};
    for (int k = 0; k < 5; k++) {
        Oscillator mass = {.omega = 3, .damping_ratio = ratios[k], .clearance = 1e9, .stiffness = 1};
        Rig rig = oscillator_rig(&mass);
        rig_drive(&rig, 3 * sqrt(1 - ratios[k] * ratios[k]) / M_PI, 2);
        Motion motion = motion_create(&rig, 1);
        motion_unit_tangents(&motion);
        CycleMotion same = beam_cycle_motion(&motion);
        enum { CYCLES = 200 };
        double growth[CYCLES] = {0};
        for (int i = 0; i < CYCLES; i++) {
            motion_cycle(&motion);
            chaos_renew_tangents(&same, &growth[i]);
        }
        ChaosExponent exponent = chaos_exponent(growth, CYCLES);
        CHECK_NEAR(exponent.value / rig.period, -ratios[k] * 3, 1e-12);
        CHECK_NEAR(exponent.error, 0, 1e-12);
        motion_destroy(&motion);
        rig_clear(&rig);
    }
}

TEST(the_exponents_of_both_directions_of_a_mode_add_up_to_its_damping) {
    Oscillator mass = {.omega = 3, .damping_ratio = 0.07, .clearance = 1e9, .stiffness = 1};
    Rig rig = oscillator_rig(&mass);
    rig_drive(&rig, 1, 2);
    Motion motion = motion_create(&rig, 2);
    motion_unit_tangents(&motion);
    CycleMotion same = beam_cycle_motion(&motion);
    double growth[2] = {0, 0};
    const int cycles = 2000;
    for (int i = 0; i < cycles; i++) {
        motion_cycle(&motion);
        chaos_renew_tangents(&same, growth);
    }
    CHECK_NEAR((growth[0] + growth[1]) / (cycles * rig.period), -2 * 0.07 * 3, 1e-12);
    motion_destroy(&motion);
    rig_clear(&rig);
}

/* Returns the sum of all exponents, 1/s, over 200 cycles, and the fraction of time in contact. The fastest direction
 * shrinks by e^20 per cycle, so tangents are renewed eight times per cycle. */
static double exponent_sum(const Rig *rig, double *contact_share) {
    const int cycles = 200;
    size_t states = rig->free.states;
    Motion motion = motion_create(rig, states);
    motion_unit_tangents(&motion);
    CycleMotion same = beam_cycle_motion(&motion);
    double growth[STATES_MOST] = {0}, sum = 0;
    for (int i = 0; i < cycles; i++) {
        for (int part = 1; part <= 8; part++) {
            while (motion.phase < rig->period * part / 8)
                motion_step(&motion, rig->period * part / 8 - motion.phase);
            chaos_renew_tangents(&same, growth);
        }
        CHECK(motion_cycle(&motion) == CYCLE_GOOD);
    }
    for (size_t t = 0; t < states; t++)
        sum += growth[t];
    *contact_share = motion.contact_time / (cycles * rig->period);
    motion_destroy(&motion);
    return sum / (cycles * rig->period);
}

TEST(the_sum_of_all_exponents_is_what_damps_in_order_and_in_chaos_whichever_way_the_contact_is_released) {
    static const char *const settings[] = {"beam.modes=4",      "drive.frequency=190", "drive.frequency=300",
                                           "shaker.damping=15", "joint.clearance=0",   "joint.damping=1000"};
    for (size_t s = 0; s < 2 * sizeof settings / sizeof *settings; s++) {
        Rig rig = oscillator_beam_rig("ibs", settings[s / 2]);
        rig.release = s % 2 ? RELEASE_GAP : RELEASE_FORCE;
        double share, sum = exponent_sum(&rig, &share);
        CHECK(share > 0.3 && share < 1 + 1e-9);
        CHECK_NEAR(sum / beam_cycle_exponent_sum(&rig, share), 1, 1e-6);
        CHECK_NEAR(regime_trace(&rig.free) / beam_cycle_exponent_sum(&rig, 0), 1, 1e-9);
        CHECK_NEAR(regime_trace(&rig.contact) / beam_cycle_exponent_sum(&rig, 1), 1, 1e-9);
        rig_clear(&rig);
    }
}
