#include <math.h>

#include "check.h"
#include "oscillator.h"
#include "peer.h"

/* Returns the largest relative difference of the two states after some cycles. */
static double apart_after(const char *setting, double frequency, int cycles, double tolerance) {
    Rig rig = oscillator_beam_rig("ibs", setting);
    rig_drive(&rig, frequency, rig.force);
    double start[128] = {0}, state[128], apart = 0, length = 0;
    Motion motion = motion_create(&rig, 0);
    Peer *peer = peer_create(&rig, start, tolerance);
    for (int i = 0; i < cycles; i++) {
        CHECK(motion_cycle(&motion) == CYCLE_GOOD);
        peer_cycle(peer);
    }
    motion_state(&motion, state);
    for (size_t i = 0; i < rig.free.states; i++) {
        apart += pow(state[i] - peer_state(peer)[i], 2);
        length += state[i] * state[i];
    }
    CHECK(motion.switches == peer_switches(peer));
    CHECK(motion.switches > 4 * (size_t)cycles);
    peer_destroy(peer);
    motion_destroy(&motion);
    rig_clear(&rig);
    return sqrt(apart / length);
}

TEST(cvode_agrees_over_forty_cycles_of_a_periodic_response) {
    CHECK_NEAR(apart_after("beam.modes=4", 190, 40, 1e-10), 0, 1e-8);
    CHECK_NEAR(apart_after("beam.modes=12", 290, 40, 1e-10), 0, 1e-8);
}

TEST(cvode_comes_nearer_with_its_tolerance) {
    double coarse = apart_after("beam.modes=4", 290, 10, 1e-6), fine = apart_after("beam.modes=4", 290, 10, 1e-10);
    CHECK(fine < coarse / 100);
}
