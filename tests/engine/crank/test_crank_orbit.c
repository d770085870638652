#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "check.h"
#include "crank/crank_cycle.h"
#include "cranks.h"
#include "cycle/motion_class.h"

/* Finds the orbit near the motion after some revolutions from the start. */
static Orbit settled_orbit(const Tree *tree, size_t transient, size_t period) {
    Cycle cycle = crank_cycle_of(tree);
    Orbit orbit = {0};
    double state[TREE_STATES_MOST];
    CycleMotion motion = cycle_create(cycle, 0, NULL);
    for (size_t i = 0; i < transient; i++)
        cycle_run(&motion);
    crank_cycle.state(motion.own, state);
    cycle_destroy(&motion);
    bool found = orbit_find(&orbit, cycle, state, period, NULL) == ORBIT_GOOD;
    CHECK(found);
    if (!found)
        orbit.point = memory_zeroed(TREE_STATES_MOST, sizeof *orbit.point);
    return orbit;
}

/* Returns the largest force in the revolution after the orbit's point. */
static double peak_of(const Tree *tree, const Orbit *orbit, int revolution) {
    CycleMotion motion = cycle_create(crank_cycle_of(tree), 0, NULL);
    crank_cycle.set_state(motion.own, orbit->point);
    for (int i = 0; i < revolution; i++)
        cycle_run(&motion);
    double *peak = crank_cycle.peaks(motion.own);
    peak[0] = 0;
    cycle_run(&motion);
    double value = peak[0];
    cycle_destroy(&motion);
    return value;
}

TEST(an_orbit_of_period_one_is_certified) {
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=1e-4");
    Orbit orbit = settled_orbit(&tree, 8, 1);
    double ideal[TREE_STATES_MOST];
    tree_ideal(&tree, 0, tree.omega, ideal);
    CHECK_NEAR(orbit.largest, 0.349387, 1e-5);
    CHECK_NEAR(ideal[0] + 1e-4 * orbit.point[0], 0.210818197531, 1e-10);
    CHECK_NEAR(peak_of(&tree, &orbit, 0), 51.1608, 1e-4);
    orbit_clear(&orbit);
}

LONG_TEST(orbits_of_other_speeds_are_certified) {
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=5e-5");
    Orbit orbit = settled_orbit(&tree, 20, 1);
    CHECK_NEAR(orbit.largest, 0.276768, 1e-5);
    CHECK(orbit.leaving == ORBIT_NEIMARK);
    CHECK_NEAR(peak_of(&tree, &orbit, 0), 39.8176, 1e-4);
    orbit_clear(&orbit);
    tree = cranks_tree("drive.frequency=6.666666666666667,joint.clearance=2.5e-4");
    orbit = settled_orbit(&tree, 60, 2);
    /* neighbours 1, 3 and 10 nm away give 0.557984, 0.557987 and 0.558014, and CVODE as much 10 nm away (see
     * test_crank_peer.c); a prototype had 0.557907 */
    CHECK_NEAR(orbit.largest, 0.557985, 1e-5);
    double first = peak_of(&tree, &orbit, 0), second = peak_of(&tree, &orbit, 1);
    CHECK_NEAR(fmax(first, second), 55.3092, 1e-4);
    CHECK_NEAR(fmin(first, second), 44.2053, 1e-4);
    orbit_clear(&orbit);
}

/* Returns the largest exponent over some revolutions after 60 others. */
static ChaosExponent exponent_of(const Tree *tree, size_t count) {
    CycleMotion motion = cycle_create(crank_cycle_of(tree), 1, NULL);
    double *growth = memory_zeroed(count, sizeof *growth), none = 0;
    for (size_t i = 0; i < 60; i++) {
        cycle_run(&motion);
        chaos_renew_tangents(&motion, &none);
    }
    for (size_t i = 0; i < count; i++) {
        cycle_run(&motion);
        chaos_renew_tangents(&motion, &growth[i]);
    }
    ChaosExponent exponent = chaos_exponent(growth, count);
    memory_free(growth);
    cycle_destroy(&motion);
    return exponent;
}

LONG_TEST(largest_exponents_of_chaotic_motions) {
    Tree tree = cranks_tree("");
    ChaosExponent exponent = exponent_of(&tree, 150);
    CHECK_NEAR(exponent.value, 1.21, 4 * 0.08);
    CHECK(exponent.value > 3 * exponent.error);
    tree = cranks_tree("drive.frequency=15,joint.clearance=5e-4");
    CHECK_NEAR(exponent_of(&tree, 300).value, 1.90, 4 * 0.07);
    tree = cranks_tree("drive.frequency=16.666666666666668");
    CHECK_NEAR(exponent_of(&tree, 150).value, 0.27, 4 * 0.09);
}

TEST(a_saved_motion_goes_on_with_the_same_bits) {
    Tree tree = cranks_tree("");
    CycleMotion motion = cycle_create(crank_cycle_of(&tree), 0, NULL),
                again = cycle_create(crank_cycle_of(&tree), 0, NULL);
    double saved[TREE_STATES_MOST + 2], one[TREE_STATES_MOST], other[TREE_STATES_MOST];
    CHECK(crank_cycle.saved_size(&tree) <= sizeof saved / sizeof *saved);
    cycle_run(&motion);
    crank_cycle.save(motion.own, saved);
    crank_cycle.restore(again.own, saved);
    cycle_run(&motion);
    cycle_run(&again);
    crank_cycle.state(motion.own, one);
    crank_cycle.state(again.own, other);
    CHECK(memcmp(one, other, motion.states * sizeof *one) == 0);
    cycle_destroy(&motion);
    cycle_destroy(&again);
}

TEST(a_request_ends_a_motion_within_its_revolution) {
    Tree tree = cranks_tree("");
    Stop stop = {0};
    CycleMotion motion = cycle_create(crank_cycle_of(&tree), 1, &stop);
    double row[CRANK_COLUMNS], state[TREE_STATES_MOST] = {0};
    crank_cycle.sample(motion.own, 0, row);
    stop_request(&stop);
    CHECK(cycle_run(&motion) == CYCLE_INTERRUPTED);
    CHECK(motion_class_of_record(cycle_status(&motion), 0, true) == MOTION_CLASS_UNDETERMINED);
    cycle_destroy(&motion);
    CHECK(orbit_map(crank_cycle_of(&tree), state, 1, NULL, &stop) == ORBIT_INTERRUPTED);
    Crank crank = cranks_read((const char *[]){NULL});
    CHECK(isnan(crank_cycle_ideal_force(&crank, &stop)));
    crank_free(&crank);
}

TEST(a_tangent_is_the_derivative_of_a_revolution) {
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=1e-4");
    Orbit orbit = settled_orbit(&tree, 8, 1);
    Cycle cycle = crank_cycle_of(&tree);
    CycleMotion motion = cycle_create(cycle, 1, NULL);
    double tangent[TREE_STATES_MOST] = {0}, state[TREE_STATES_MOST], moved[TREE_STATES_MOST], size = 0, apart = 0;
    const double by = 1e-3;
    crank_cycle.set_state(motion.own, orbit.point);
    tangent[1] = 3;
    crank_cycle.set_tangent(motion.own, 0, tangent);
    cycle_run(&motion);
    crank_cycle.tangent(motion.own, 0, tangent);
    memcpy(state, orbit.point, orbit.states * sizeof *state);
    memcpy(moved, orbit.point, orbit.states * sizeof *moved);
    moved[1] += 3 * by;
    CHECK(orbit_map(cycle, state, 1, NULL, NULL) == ORBIT_GOOD);
    CHECK(orbit_map(cycle, moved, 1, NULL, NULL) == ORBIT_GOOD);
    for (size_t i = 0; i < orbit.states; i++) {
        size += tangent[i] * tangent[i];
        apart += pow(tangent[i] - (moved[i] - state[i]) / by, 2);
    }
    CHECK(sqrt(apart / size) < 0.02);
    cycle_destroy(&motion);
    orbit_clear(&orbit);
}
