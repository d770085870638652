#include <math.h>
#include <string.h>

#include "check.h"
#include "cranks.h"

/* Expected numbers are of a second program, written from the equations alone in another language. */

/* Checks to a relative tolerance. */
static void near(double got, double expected, double tolerance) {
    CHECK_NEAR(got, expected, fabs(expected) * tolerance);
}

TEST(constants_of_the_desk_rig) {
    Tree tree = cranks_tree("");
    near(tree.mass, 0.0551349510705, 1e-12);
    near(tree.sine_stiffness[0] / (pow(M_PI / 0.25, 4) * 0.125), 13.168771005685, 1e-12);
    near(sqrt(tree.sine_stiffness[0] / (tree.mass / 2)) / (2 * M_PI), 194.208838159, 1e-11);
    near(tree.axial_stiffness, 23411148.454551, 1e-12);
    CHECK(tree.coordinates == 11);
}

TEST(kinematics_of_the_ideal_mechanism) {
    Tree tree = cranks_tree("drive.frequency=10");
    double state[TREE_STATES_MOST];
    tree_ideal(&tree, 1, tree.omega, state);
    const double *rate = state + tree.coordinates;
    CHECK_NEAR(state[0], 0.22689452608982, 1e-13);
    CHECK_NEAR(state[1], 3.02601574707735, 1e-13);
    CHECK_NEAR(state[2], -0.41856348730875, 1e-13);
    CHECK_NEAR(rate[0], 1.1047575834155, 1e-13);
    CHECK_NEAR(rate[1], 6.4630013261941, 1e-13);
    CHECK_NEAR(rate[2], 9.2586538632542, 1e-13);
    TreePose pose = tree_pose(&tree, 1 / tree.omega, state);
    for (size_t i = 0; i < 3; i++) {
        CHECK_NEAR(pose.apart[i], 0, 1e-15);
        CHECK_NEAR(pose.apart_rate[i], 0, 1e-13);
    }
}

/* The ideal state at theta 1 and `size` times a deviation of every coordinate and rate. */
static void deviate(const Tree *tree, double size, double *state) {
    static const double by[22] = {5e-5, 1e-4, -2e-4, 1e-6, 2e-4, -3e-5, -1e-4, 4e-5, 1e-5, -2e-5, 3e-5,
                                  .01,  .05,  -.04,  1e-3, .03,  -.01,  .02,   .015, .001, -.002, .003};
    tree_ideal(tree, 1, tree->omega, state);
    for (size_t i = 0; i < 2 * tree->coordinates; i++)
        state[i] += size * by[i];
}

static TreePose rates_at(const Tree *tree, const double *state, BallPlace place, double *rates) {
    TreePose pose = tree_pose(tree, 1 / tree->omega, state);
    double force[3], moment[3];
    ball_push(tree, &pose, place, force, moment);
    tree_rates(tree, &pose, state, force, moment, rates);
    return pose;
}

TEST(accelerations_in_flight) {
    static const double expected[11] = {-79.460177539924, 1369.2014355231, 1192.1320072465, -549.54561331888,
                                        -519.11607362138, 820.50738613760, 365.89055808343, -1049.6798775096,
                                        -6.6993265299038, 20.08,           -30.12};
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=1e-4");
    double state[TREE_STATES_MOST], rates[TREE_STATES_MOST];
    deviate(&tree, 1, state);
    TreePose pose = rates_at(&tree, state, BALL_OPEN, rates);
    for (size_t i = 0; i < 11; i++)
        near(rates[11 + i], expected[i], 1e-10);
    BallReading reading = ball_read(&tree, &pose);
    near(reading.distance - 1e-4, -4.044701863913e-5, 1e-10);
    near(reading.rate, 1.283985439214e-2, 1e-10);
    near(cranks_energy(&tree, state), 0.412503026145422, 1e-12);
}

TEST(accelerations_in_contact) {
    static const double expected[11] = {320.08392548068,  9314.8952025794, 94167.292673374, 18601.592941467,
                                        -2384.6627620029, 2932.6884864910, 15337.663970377, -10493.701939235,
                                        374.78666113431,  25.609912158161, 13.733246918871};
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=1e-4");
    double state[TREE_STATES_MOST], rates[TREE_STATES_MOST];
    deviate(&tree, 3, state);
    TreePose pose = rates_at(&tree, state, BALL_CONTACT, rates);
    near(ball_read(&tree, &pose).push, 1229.518905369, 1e-10);
    for (size_t i = 0; i < 11; i++)
        near(rates[11 + i], expected[i], 1e-10);
}

TEST(the_acceleration_of_the_ball_is_the_derivative_of_its_velocity) {
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=1e-4,crank.tilt=20");
    double state[TREE_STATES_MOST], rates[TREE_STATES_MOST], second[3], next[TREE_STATES_MOST], last[TREE_STATES_MOST];
    const double h = 1e-6;
    deviate(&tree, 1, state);
    TreePose pose = rates_at(&tree, state, BALL_OPEN, rates);
    tree_apart_acceleration(&tree, &pose, rates, second);
    for (size_t i = 0; i < 2 * tree.coordinates; i++) {
        next[i] = state[i] + h * rates[i];
        last[i] = state[i] - h * rates[i];
    }
    TreePose after = tree_pose(&tree, 1 / tree.omega + h, next), before = tree_pose(&tree, 1 / tree.omega - h, last);
    for (size_t i = 0; i < 3; i++)
        CHECK_NEAR(second[i], (after.apart_rate[i] - before.apart_rate[i]) / (2 * h), 1e-4);
}

/* Lagrange's equations, by differences of kinetic and whole energy along independent coordinates. */
TEST(lagrange_holds_in_every_row) {
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=1e-2,crank.tilt=22.9,coupler.damping_ratio=0,"
                            "slider.damping=0,universal.damping=0,support.damping_ratio=0");
    size_t n = tree.coordinates;
    double state[TREE_STATES_MOST], rates[TREE_STATES_MOST];
    deviate(&tree, 3, state);
    rates_at(&tree, state, BALL_OPEN, rates);
    double size[TREE_MOST];
    for (size_t k = 0; k < n; k++)
        size[k] = k == 0 ? 1e-4 : k < 3 ? 1e-3 : k == 3 ? 1e-6 : 1e-4;
    const double h = 1e-6;
    for (size_t k = 0; k < n; k++) {
        double momentum[2], part = 0;
        for (int side = 0; side < 2; side++) {
            double moved[TREE_STATES_MOST], step = side ? h : -h;
            for (size_t i = 0; i < n; i++) {
                moved[i] = state[i] + step * state[n + i] + step * step / 2 * rates[n + i];
                moved[n + i] = state[n + i] + step * rates[n + i];
            }
            double up[TREE_STATES_MOST], down[TREE_STATES_MOST], by = 10 * size[k];
            memcpy(up, moved, sizeof up);
            memcpy(down, moved, sizeof down);
            up[n + k] += by;
            down[n + k] -= by;
            momentum[side] = (cranks_kinetic_energy(&tree, up) - cranks_kinetic_energy(&tree, down)) / (2 * by);
        }
        double up[TREE_STATES_MOST], down[TREE_STATES_MOST];
        memcpy(up, state, sizeof up);
        memcpy(down, state, sizeof down);
        up[k] += size[k];
        down[k] -= size[k];
        double change = (momentum[1] - momentum[0]) / (2 * h);
        double kinetic = (cranks_kinetic_energy(&tree, up) - cranks_kinetic_energy(&tree, down)) / (2 * size[k]);
        double whole = (cranks_energy(&tree, up) - cranks_energy(&tree, down)) / (2 * size[k]);
        part = fabs(change) + fabs(kinetic) + fabs(whole - kinetic) + fabs(momentum[0]) * tree.omega;
        CHECK_NEAR((change - kinetic + (whole - kinetic)) / part, 0, 1e-6);
    }
}
