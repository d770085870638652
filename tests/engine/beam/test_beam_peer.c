#include <math.h>
#include <stdio.h>

#include "beam/beam_cycle.h"
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

/* Frequencies that nothing was tuned to. */
static const double untuned[] = {43.7, 67.3, 88.1, 121.9, 149.3, 167.7, 187.1, 211.3, 233.9, 262.7, 287.3, 309.1};
enum { UNTUNED = sizeof untuned / sizeof *untuned };

/* Halves a state until its tip is between the walls, where CVODE can begin. */
static void put_inside(const Rig *rig, double *state) {
    Motion motion = motion_create(rig, 0);
    motion_set_state(&motion, state);
    while (fabs(motion_deflection(&motion)) >= rig->clearance) {
        for (size_t i = 0; i < rig->free.states; i++)
            state[i] /= 2;
        motion_set_state(&motion, state);
    }
    motion_destroy(&motion);
}

/* Returns how far CVODE is from the motion after some cycles from a state, as a share of the state's length. */
static double apart_from(const Rig *rig, const double *start, size_t cycles) {
    double state[128], apart = 0, length = 0;
    for (size_t i = 0; i < 128 && i < rig->free.states; i++)
        state[i] = start[i];
    put_inside(rig, state);
    Peer *peer = peer_create(rig, state, 1e-11);
    CHECK(orbit_map(beam_cycle_of(rig), state, cycles, NULL, NULL) == ORBIT_GOOD);
    for (size_t i = 0; i < cycles; i++)
        peer_cycle(peer);
    for (size_t i = 0; i < rig->free.states; i++) {
        apart += pow(state[i] - peer_state(peer)[i], 2);
        length += state[i] * state[i];
    }
    peer_destroy(peer);
    return sqrt(apart / length);
}

/* From a certified orbit of a short period for that period, from other motions for two cycles. */
LONG_TEST(cvode_agrees_at_twelve_untuned_frequencies_of_both_sets) {
    static const char *const sets[] = {"ibs", "ibs-r"};
    int seen[RESPONSE_INTERRUPTED + 1] = {0};
    for (int s = 0; s < 2; s++)
        for (int f = 0; f < UNTUNED; f++) {
            Beam beam = oscillator_beam(sets[s], NULL);
            Fault fault = {0};
            Rig rig;
            Response response;
            beam.frequency = untuned[f];
            CHECK(rig_build(&rig, &beam, beam.name, &fault));
            beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
            bool orbit = response.orbit.period > 0;
            const double *from = orbit ? response.orbit.point : section_last(&response.section);
            size_t cycles = orbit && response.orbit.period < 4 ? response.orbit.period : 2;
            double apart = apart_from(&rig, from, cycles);
            printf("     %-5s %5g Hz: %-14s period %2zu, apart %.1e after %zu cycles\n", sets[s], untuned[f],
                   response_name(&response), response.orbit.period, apart, cycles);
            CHECK(apart < 1e-6);
            CHECK(response_is_told(response.verdict));
            seen[response.verdict]++;
            response_clear(&response);
            rig_clear(&rig);
            beam_free(&beam);
        }
    CHECK(seen[RESPONSE_PERIODIC] > 0 && seen[RESPONSE_CHAOTIC] > 0);
}
