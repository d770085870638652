/* Tests the slider crank beside those of others: the flexible planar one of Simeon and the spatial rigid one of IFToMM,
 * and with a clearance that goes to 0. */

#include <math.h>
#include <stdio.h>
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
 * problems, "slider crank", whose rod begins at the crank, so that its second bending has the other sign. */
typedef struct SimeonStart {
    double stretch, stretch_rate; /* m, m/s, of the rod; the slider is as much further out */
    double second_rate;           /* m/s, of the second bending */
} SimeonStart;

typedef struct SimeonRod {
    bool stretches, shortens; /* along itself; when it bends */
} SimeonRod;

/* Runs 0.1 s and returns the place of the first coordinate of bending. */
static size_t simeon(SimeonRod rod, SimeonStart start, double state[TREE_STATES_MOST]) {
    enum { BENDING = 2, SLIDER_PLACE = 0, STRETCH_PLACE = 3 };
    char settings[500];
    snprintf(settings, sizeof settings,
             "crank.tilt=90,crank.offset_y=0,crank.offset_z=0,crank.radius=0.15,coupler.length=0.3,"
             "coupler.damping_ratio=0,coupler.end_mass=0,coupler.shortening=%s,coupler.axial=%d,slider.damping=0,"
             "slider.mass=0.075552,universal.damping=0,joint.clearance=0,joint.damping=0,"
             "joint.stiffness=1e9,gravity.acceleration=0,support.stiffness_x=1e12,"
             "support.stiffness_y=1e12,support.stiffness_z=1e12,support.mass=1e6",
             rod.shortens ? "true" : "false", rod.stretches);
    Tree tree = cranks_tree(settings);
    double side = 0.008, length = 0.3, modulus = 2e11, stiffness = modulus * side * side * side * side / 12;
    tree.mass = 7870 * side * side * length;
    tree.axial_stiffness = modulus * side * side / length;
    for (int n = 0; n < BENDING; n++)
        tree.sine_stiffness[n] = stiffness * pow((n + 1) * M_PI / length, 4) * length / 2;
    tree.omega = -150;
    size_t zeta = 3 + tree.axial + tree.bending;
    tree_ideal(&tree, M_PI / 2, -150, state);
    state[tree.coordinates + zeta] = 0.4448961;
    state[tree.coordinates + zeta + 1] = start.second_rate;
    state[SLIDER_PLACE] += start.stretch;
    state[tree.coordinates + SLIDER_PLACE] += start.stretch_rate;
    if (rod.stretches) {
        state[STRETCH_PLACE] = start.stretch;
        state[tree.coordinates + STRETCH_PLACE] = start.stretch_rate;
    }
    Sprung sprung = {&tree, M_PI / 2 / -150};
    follow(&sprung, 0.1, state);
    return zeta;
}

/* Without stretch agreement is to about a hundredth of the amplitudes of bending. */
TEST(the_flexible_planar_slider_crank_of_simeon) {
    double state[TREE_STATES_MOST] = {0};
    size_t zeta = simeon((SimeonRod){false, false}, (SimeonStart){0}, state);
    CHECK_NEAR(state[zeta], 1.8932e-4, 0.015 * 1.9e-4);
    CHECK_NEAR(state[zeta + 1], -2.376e-5, 0.015 * 1.9e-4);
    CHECK_NEAR(state[2], -0.3311735, 1e-5);
    CHECK_NEAR(state[0], 0.1697373, 1e-5);
}

/* The reference starts with a rod that its own inertia stretches: by 16.9 um, the slider as much further out. Without
 * that the rod vibrates along itself, undamped, at 4.6 kHz with that amplitude, and slider and angle are off by 1.12e-5
 * m and 1.19e-5 at 0.1 s; from the reference's start they are off by 3.6e-7 m and 2e-7. */
static const SimeonStart simeon_stretched = {0.169327969e-4, -0.268938672e-5, -0.463434311e-2};

TEST(the_same_crank_with_a_coupler_that_stretches) {
    double state[TREE_STATES_MOST] = {0}, unstretched[TREE_STATES_MOST] = {0};
    size_t zeta = simeon((SimeonRod){true, false}, simeon_stretched, state);
    CHECK_NEAR(state[zeta], 1.8932e-4, 0.015 * 1.9e-4);
    CHECK_NEAR(state[zeta + 1], -2.376e-5, 0.015 * 1.9e-4);
    CHECK_NEAR(state[0], 0.1697373, 1e-6);
    CHECK_NEAR(state[2], -0.3311735, 1e-6);
    simeon((SimeonRod){true, false}, (SimeonStart){0}, unstretched);
    CHECK_NEAR(unstretched[0], state[0], 0.17e-4);
    CHECK_NEAR(unstretched[2], state[2], 0.17e-4);
}

/* Bending that shortens the rod makes its first bending a third larger. A prototype had 2.567e-4; here it is 2.549e-4
 * of a rod that does not stretch, and 2.577e-4 and 2.559e-4 of one that does, from the two starts: what is between them
 * is the phase of its undamped vibration along itself. */
TEST(the_same_crank_with_a_coupler_that_bending_shortens) {
    static const struct {
        bool stretches;
        SimeonStart start;
        double bending; /* m */
    } cases[] = {{false, {0, 0, 0}, 2.5494e-4}, {true, {0, 0, 0}, 2.5769e-4}, {true, simeon_stretched, 2.5587e-4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double state[TREE_STATES_MOST] = {0};
        size_t zeta = simeon((SimeonRod){cases[i].stretches, true}, cases[i].start, state);
        CHECK_NEAR(state[zeta], cases[i].bending, 1e-8);
        CHECK_NEAR(state[zeta], 2.567e-4, 0.015 * 1.9e-4);
        CHECK_NEAR(state[2], -0.3311735, 1.5e-5);
    }
}

/* The spatial rigid slider crank of the IFToMM library of benchmarks: a crank of 0.08 m and 0.12 kg that turns by its
 * weight and an initial 6 rad/s, a rod of 0.3 m and 0.5 kg, a slider of 2 kg. Data as in EXUDYN's example of it; its
 * universal joint has another first axis than ours, so that the rod's inertia about itself, 0.0004 kg m2, enters by
 * another angle. As one freedom: T = M(theta) theta'^2 / 2 and V(theta), from the rigid mechanism alone. */
typedef struct Benchmark {
    const Tree *tree;
    double across, about; /* kg m2, of the rod beyond that of a slender one, and about itself */
    bool level;           /* the universal joint's first axis is z, as ours; otherwise x, as the benchmark's */
} Benchmark;

/* Returns twice the kinetic energy at theta' = 1, and the potential. */
static double benchmark_mass(const Benchmark *benchmark, double theta, double *potential) {
    const Tree *tree = benchmark->tree;
    double state[TREE_STATES_MOST], end[3], slider[3] = {0}, turn = 0, squares = 0;
    tree_ideal(tree, theta, 1, state);
    TreePin pin = tree_pin(tree, theta, 1);
    slider[0] = state[tree->coordinates];
    for (size_t i = 0; i < 3; i++) {
        end[i] = pin.rate[i];
        squares += end[i] * end[i] + end[i] * slider[i] + slider[i] * slider[i];
        turn += (end[i] - slider[i]) * (end[i] - slider[i]);
    }
    double y = pin.at[1], z = pin.at[2], angle = (y * end[2] - z * end[1]) / (y * y + z * z);
    double spin =
        benchmark->level ? sin(state[2]) * state[tree->coordinates + 1] : angle * (pin.at[0] - state[0]) / tree->length;
    *potential = tree->unbalance_weight * cos(theta) + tree->mass * tree->gravity * z / 2;
    return tree->inertia + tree->slider_mass * slider[0] * slider[0] + tree->mass / 3 * squares +
           benchmark->across * turn / (tree->length * tree->length) + benchmark->about * spin * spin;
}

static double benchmark_acceleration(const Benchmark *benchmark, double theta, double rate) {
    const double h = 1e-4;
    double above, below, here;
    double mass_above = benchmark_mass(benchmark, theta + h, &above),
           mass_below = benchmark_mass(benchmark, theta - h, &below), mass = benchmark_mass(benchmark, theta, &here);
    return -((mass_above - mass_below) / (4 * h) * rate * rate + (above - below) / (2 * h)) / mass;
}

/* Advances theta and theta' by Runge and Kutta's classical method. */
static void benchmark_advance(const Benchmark *benchmark, double seconds, double *theta, double *rate) {
    const double dt = 2e-4;
    for (long n = lround(seconds / dt); n > 0; n--) {
        double a1 = benchmark_acceleration(benchmark, *theta, *rate), v2 = *rate + dt / 2 * a1;
        double a2 = benchmark_acceleration(benchmark, *theta + dt / 2 * *rate, v2), v3 = *rate + dt / 2 * a2;
        double a3 = benchmark_acceleration(benchmark, *theta + dt / 2 * v2, v3), v4 = *rate + dt * a3;
        double a4 = benchmark_acceleration(benchmark, *theta + dt * v3, v4);
        *theta += dt / 6 * (*rate + 2 * v2 + 2 * v3 + v4);
        *rate += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
}

/* Returns the rigid tree with an ideal joint as a spring. */
static Tree benchmark_tree(void) {
    Tree tree = cranks_tree("crank.radius=0.08,crank.offset_y=0.1,crank.offset_z=0.12,coupler.length=0.3,"
                            "coupler.end_mass=0,coupler.axial=0,slider.mass=2,slider.damping=0,universal.damping=0,"
                            "joint.clearance=0,joint.damping=0,joint.stiffness=1e9,support.stiffness_x=1e12,"
                            "support.stiffness_y=1e12,support.stiffness_z=1e12,support.mass=1e6,drive.motor=0.05");
    double mass = 0.12, lever = 0.04;
    tree.motor = 0;
    tree.inertia = 0.0001 + mass * lever * lever;
    tree.unbalance_weight = mass * lever * tree.gravity;
    tree.mass = 0.5;
    tree.bending = 0;
    tree.rod = 3;
    tree.coordinates = 7;
    return tree;
}

TEST(the_spatial_slider_crank_of_iftomm) {
    static const struct {
        double time, slider, published, tolerance; /* s, m, m (Gonzalez), m */
    } rows[] = {{0.1, 0.2267872, 0.2267854, 5e-6},
                {0.5, 0.1849526, 0.1849528, 5e-6},
                {1, 0.2117217, 0.2117547, 5e-5},
                {5, 0.2407196, 0.2407618, 5e-5}};
    Tree tree = benchmark_tree();
    Benchmark benchmark = {&tree, 0.00025, 0.0004, false};
    double theta = 0, rate = 6, time = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        benchmark_advance(&benchmark, rows[i].time - time, &theta, &rate);
        time = rows[i].time;
        CHECK_NEAR(tree_ideal_slider(&tree, theta), rows[i].slider, 1e-7);
        CHECK_NEAR(tree_ideal_slider(&tree, theta), rows[i].published, rows[i].tolerance);
    }
}

/* With our universal joint and a rod that is not slender the one freedom gives 0.2267963 and 0.1850412, as a second
 * program did; our tree has slender rods only, so that it is held, with a spring for its joint, against the one freedom
 * of such a rod. */
TEST(the_tree_with_a_spring_for_its_joint_is_the_rigid_mechanism) {
    static const double times[] = {0.1, 0.5};
    Tree tree = benchmark_tree();
    Benchmark slender = {&tree, 0, 0, true}, thick = {&tree, 0.00025, 0.0004, true};
    static const double known[] = {0.2267963, 0.1850412};
    double thick_theta = 0, thick_rate = 6;
    double state[TREE_STATES_MOST] = {0}, theta = 0, rate = 6, time = 0;
    tree_ideal(&tree, 0, 6, state);
    Sprung sprung = {&tree, 0};
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        benchmark_advance(&slender, times[i] - time, &theta, &rate);
        benchmark_advance(&thick, times[i] - time, &thick_theta, &thick_rate);
        follow(&sprung, times[i] - time, state);
        time = times[i];
        CHECK_NEAR(state[0], tree_ideal_slider(&tree, theta), 1e-7);
        CHECK_NEAR(tree_ideal_slider(&tree, thick_theta), known[i], 1e-7);
    }
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
