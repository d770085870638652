/* Tests the slider crank beside other people's: the flexible planar slider crank of Simeon, and what its clearance
 * becomes as it goes to 0. */

#include <math.h>
#include <string.h>

#include "check.h"
#include "crank/ball.h"
#include "crank/stepper.h"
#include "cranks.h"

/* The mechanism with an ideal joint as a spring. */
typedef struct Sprung {
    const Tree *tree;
    double since; /* s, time of the tree at the beginning */
} Sprung;

static void rates_of(const void *context, double time, const double *state, double *rates) {
    const Sprung *sprung = context;
    double force[3], moment[3];
    TreePose pose = tree_pose(sprung->tree, sprung->since + time, state);
    ball_push(sprung->tree, &pose, BALL_CONTACT, force, moment);
    tree_rates(sprung->tree, &pose, state, force, moment, rates);
}

static void follow(const Sprung *sprung, double until, double *state) {
    size_t count = 2 * sprung->tree->coordinates;
    double scale[TREE_STATES_MOST], rates[TREE_STATES_MOST], next[TREE_STATES_MOST], next_rates[TREE_STATES_MOST];
    for (size_t i = 0; i < count; i++)
        scale[i] = i < count / 2 ? 1e-6 : 1e-2;
    Stepper stepper = {count, scale, 1e-3, rates_of, sprung};
    double time = 0, step = 1e-6;
    rates_of(sprung, 0, state, rates);
    while (time < until) {
        step = fmin(step, until - time);
        double error = stepper_try(&stepper, time, step, state, rates, next, next_rates);
        if (error <= 1) {
            time += step;
            memcpy(state, next, count * sizeof *state);
            memcpy(rates, next_rates, count * sizeof *rates);
        }
        step = stepper_next(step, error);
    }
}

/* Simeon, "DAEs and PDEs in elastic multibody systems", 1998; the data are those of the test set for initial value
 * problems, "slider crank". That rod stretches, too, and vibrates along itself without damping by 1e-5 m; its axial
 * shapes are two quadratics with a mass matrix of their own, so that the phase of that vibration is its own. Here the
 * rod does not stretch, and agreement is to about a hundredth of the amplitudes of bending. */
TEST(the_flexible_planar_slider_crank_of_simeon) {
    enum { BENDING = 2 };
    Tree tree = cranks_tree(
        "crank.tilt=90,crank.offset_y=0,crank.offset_z=0,crank.radius=0.15,coupler.length=0.3,"
        "coupler.damping_ratio=0,coupler.end_mass=0,coupler.shortening=false,coupler.axial=0,slider.damping=0,"
        "slider.mass=0.075552,universal.damping=0,joint.clearance=0,joint.damping=0,"
        "joint.stiffness=1e9,gravity.acceleration=0,support.stiffness_x=1e12,"
        "support.stiffness_y=1e12,support.stiffness_z=1e12,support.mass=1e6");
    double side = 0.008, length = 0.3, modulus = 2e11, stiffness = modulus * side * side * side * side / 12;
    tree.mass = 7870 * side * side * length;
    for (int n = 0; n < BENDING; n++)
        tree.sine_stiffness[n] = stiffness * pow((n + 1) * M_PI / length, 4) * length / 2;
    tree.omega = -150;
    double state[TREE_STATES_MOST] = {0};
    size_t zeta = 3 + tree.axial + tree.bending;
    tree_ideal(&tree, M_PI / 2, -150, state);
    state[tree.coordinates + zeta] = 0.4448961;
    Sprung sprung = {&tree, M_PI / 2 / -150};
    follow(&sprung, 0.1, state);
    CHECK_NEAR(state[zeta], 1.8932e-4, 0.015 * 1.9e-4);
    CHECK_NEAR(state[zeta + 1], -2.376e-5, 0.015 * 1.9e-4);
    CHECK_NEAR(state[2], -0.3311735, 1e-5);
    CHECK_NEAR(state[0], 0.1697373, 1e-5);
}

/* Runs the crank until it has settled, and keeps the slider at angles of one revolution and its largest force. */
static double slider_of(double clearance, double *slider, size_t angles) {
    enum { SETTLE = 25 };
    char settings[100];
    snprintf(settings, sizeof settings, "drive.frequency=10,joint.clearance=%g", clearance);
    Tree tree = cranks_tree(settings);
    Turn turn = turn_create(&tree, TURN_FINE);
    for (int i = 0; i < SETTLE; i++)
        turn_cycle(&turn);
    turn.peak[0] = 0;
    for (size_t i = 0; i < angles; i++) {
        while (turn.time < tree.period * (double)i / (double)angles)
            turn_step(&turn, tree.period * (double)i / (double)angles - turn.time);
        slider[i] = turn.state[0];
    }
    turn_cycle(&turn);
    return turn.peak[0];
}

LONG_TEST(the_clearance_goes_to_nothing) {
    enum { ANGLES = 720, CASES = 5 };
    static const struct {
        double clearance, peak; /* m, N */
    } expected[CASES] = {{1e-6, 34.512}, {3e-6, 34.509}, {1e-5, 34.65}, {3e-5, 38.70}, {1e-4, 51.16}};
    double elastic[ANGLES], slider[ANGLES];
    CHECK_NEAR(slider_of(0, elastic, ANGLES), 34.515, 0.01);
    for (size_t k = 0; k < CASES; k++) {
        double peak = slider_of(expected[k].clearance, slider, ANGLES), off = 0;
        for (size_t i = 0; i < ANGLES; i++)
            off = fmax(off, fabs(slider[i] - elastic[i]));
        CHECK(off / expected[k].clearance > 1.15 && off / expected[k].clearance < 1.3);
        CHECK_NEAR(peak, expected[k].peak, 0.01);
    }
}
