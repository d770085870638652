#include <math.h>

#include "check.h"
#include "crank_peer.h"
#include "cranks.h"

/* Returns the largest difference of a coordinate after one revolution, in scales of the turn's errors. */
static double apart_after(const char *settings, double tolerance) {
    Tree tree = cranks_tree(settings);
    Turn turn = turn_create(&tree, 1e-11);
    CrankPeer *peer = crank_peer_create(&tree, tolerance);
    double most = 0;
    CHECK(turn_cycle(&turn) == CYCLE_GOOD);
    crank_peer_cycle(peer);
    CHECK(turn.switches == crank_peer_switches(peer));
    for (size_t i = 0; i < tree.coordinates; i++)
        most = fmax(most, fabs(turn.state[i] - crank_peer_state(peer)[i]) / turn.scale[i]);
    crank_peer_destroy(peer);
    return most;
}

TEST(cvode_agrees_over_a_revolution) {
    CHECK_NEAR(apart_after("drive.frequency=10,joint.clearance=1e-4", 1e-9), 0, 2e-6);
    CHECK_NEAR(apart_after("", 1e-9), 0, 5.4e-6);
}

TEST(cvode_comes_nearer_with_its_tolerance) {
    CHECK(apart_after("", 1e-9) < apart_after("", 1e-6) / 20);
}

TEST(cvode_switches_at_the_same_instants) {
    Tree tree = cranks_tree("drive.frequency=10,joint.clearance=1e-4");
    Turn turn = turn_create(&tree, 1e-12);
    CrankPeer *peer = crank_peer_create(&tree, 1e-12);
    for (size_t i = 0; i < 6; i++) {
        while (turn.switches == i)
            turn_step(&turn, HUGE_VAL);
        CHECK_NEAR(turn.time, crank_peer_switch(peer), 5e-12);
    }
    crank_peer_destroy(peer);
}
