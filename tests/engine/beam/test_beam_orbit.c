#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/stop.h"
#include "beam/beam_cycle.h"
#include "check.h"
#include "oscillator.h"

enum { STATES_MOST = 128 };

/* Compares the derivative of three cycles in one direction by tangents and by central differences. */
static void check_derivative(const char *setting, int release) {
    Rig rig = oscillator_beam_rig("ibs", setting);
    rig.release = release;
    size_t states = rig.free.states;
    double start[STATES_MOST], along[STATES_MOST], up[STATES_MOST], down[STATES_MOST];
    double *derivative = memory_zeroed(states * states, sizeof *derivative);
    oscillator_start(&rig, 3, start);
    CHECK(orbit_map(beam_cycle_of(&rig), start, 40, NULL, NULL) == ORBIT_GOOD);
    oscillator_start(&rig, 4, along);
    const double small = 1e-6;
    for (size_t i = 0; i < states; i++) {
        up[i] = start[i] + small * along[i];
        down[i] = start[i] - small * along[i];
    }
    CHECK(orbit_map(beam_cycle_of(&rig), start, 3, derivative, NULL) == ORBIT_GOOD);
    CHECK(orbit_map(beam_cycle_of(&rig), up, 3, NULL, NULL) == ORBIT_GOOD &&
          orbit_map(beam_cycle_of(&rig), down, 3, NULL, NULL) == ORBIT_GOOD);
    double apart = 0, length = 0;
    for (size_t i = 0; i < states; i++) {
        double exact = 0, difference = (up[i] - down[i]) / (2 * small);
        for (size_t k = 0; k < states; k++)
            exact += derivative[k * states + i] * along[k];
        apart += (exact - difference) * (exact - difference);
        length += exact * exact;
    }
    CHECK_NEAR(sqrt(apart / length), 0, 1e-4);
    memory_free(derivative);
    rig_clear(&rig);
}

TEST(tangents_are_the_derivative_of_the_map_whichever_way_the_contact_is_released) {
    for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++) {
        check_derivative("drive.frequency=190", release);
        check_derivative("drive.frequency=290", release);
        check_derivative("drive.frequency=300", release);
        check_derivative("joint.clearance=0", release);
    }
}

TEST(newtons_orbit_is_found_from_nearby_and_repeats) {
    Rig rig = oscillator_beam_rig("ibs", "drive.frequency=290");
    double start[STATES_MOST], again[STATES_MOST];
    oscillator_start(&rig, 1, start);
    CHECK(orbit_map(beam_cycle_of(&rig), start, 100, NULL, NULL) == ORBIT_GOOD);
    Orbit orbit;
    CHECK(orbit_find(&orbit, beam_cycle_of(&rig), start, 1, NULL) == ORBIT_GOOD);
    CHECK(orbit.error < 1e-11);
    CHECK(orbit_is_stable(&orbit));
    memcpy(again, orbit.point, orbit.states * sizeof *again);
    CHECK(orbit_map(beam_cycle_of(&rig), again, 5, NULL, NULL) == ORBIT_GOOD);
    CHECK_NEAR(orbit_distance(&orbit, beam_cycle_of(&rig), again, NULL), 0, 1e-10);
    orbit_clear(&orbit);
    rig_clear(&rig);
}

TEST(a_search_that_is_stopped_finds_nothing) {
    Rig rig = oscillator_beam_rig("ibs", "drive.frequency=290");
    double state[STATES_MOST] = {0};
    CHECK(orbit_map(beam_cycle_of(&rig), state, 100, NULL, NULL) == ORBIT_GOOD);
    Stop stop = {1};
    Orbit orbit;
    CHECK(orbit_find(&orbit, beam_cycle_of(&rig), state, 1, &stop) == ORBIT_INTERRUPTED && !orbit.point);
    CHECK(orbit_map(beam_cycle_of(&rig), state, 1, NULL, &stop) == ORBIT_INTERRUPTED);
    rig_clear(&rig);
}

/* The slowest multiplier is also the factor by which a deviation shrinks per cycle. */
TEST(the_largest_multiplier_is_how_fast_the_orbit_is_approached) {
    Rig rig = oscillator_beam_rig("ibs", "drive.frequency=20");
    double state[STATES_MOST] = {0};
    CHECK(orbit_map(beam_cycle_of(&rig), state, 300, NULL, NULL) == ORBIT_GOOD);
    Orbit orbit;
    CHECK(orbit_find(&orbit, beam_cycle_of(&rig), state, 2, NULL) == ORBIT_GOOD);
    for (size_t i = 0; i < orbit.states; i++)
        state[i] = orbit.point[i] * (1 + 1e-4);
    CHECK(orbit_map(beam_cycle_of(&rig), state, 6, NULL, NULL) == ORBIT_GOOD); /* until only the slowest is left */
    double before = orbit_distance(&orbit, beam_cycle_of(&rig), state, NULL);
    CHECK(orbit_map(beam_cycle_of(&rig), state, 4, NULL, NULL) == ORBIT_GOOD);
    CHECK_NEAR(orbit_distance(&orbit, beam_cycle_of(&rig), state, NULL) / before, orbit.largest * orbit.largest,
               0.05 * orbit.largest);
    orbit_clear(&orbit);
    rig_clear(&rig);
}

/* Runs a beam from an initial state. */
static Response respond(const char *name, const char *setting, unsigned start) {
    Beam beam = oscillator_beam(name, setting);
    Rig rig = oscillator_beam_rig(name, setting);
    double state[STATES_MOST];
    Response response;
    oscillator_start(&rig, start, state);
    beam_cycle_respond(&response, &rig, &beam, state, NULL);
    rig_clear(&rig);
    beam_free(&beam);
    return response;
}

TEST(released_at_the_gap_the_peak_is_little_higher_and_the_verdict_the_same) {
    Beam beam = oscillator_beam("ibs", "joint.release=gap");
    Fault fault = {0};
    beam.frequency = 190;
    Rig rig;
    CHECK(rig_build(&rig, &beam, "ibs", &fault));
    Response response;
    beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
    CHECK(response.verdict == RESPONSE_PERIODIC && response.orbit.period == 1);
    CHECK_NEAR(response.peaks.max, 571.5, 1);
    response_clear(&response);
    beam.frequency = 300;
    rig_drive(&rig, 300, beam.force);
    beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
    CHECK(response.verdict == RESPONSE_CHAOTIC);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

TEST(a_beam_without_a_force_rests_and_one_that_does_not_reach_the_joint_does_not_touch) {
    static const char *const settings[] = {"drive.force=0", "joint.clearance=0.001"};
    for (int s = 0; s < 2; s++) {
        Response response = respond("ibs", settings[s], 0);
        CHECK(response.verdict == RESPONSE_PERIODIC && response.orbit.period == 1);
        CHECK(response.peaks.count == 0);
        response_clear(&response);
    }
}

TEST(a_response_that_is_stopped_says_nothing_of_periods) {
    Beam beam = oscillator_beam("ibs", NULL);
    Rig rig = oscillator_beam_rig("ibs", NULL);
    Stop stop = {1};
    Response response;
    beam_cycle_respond(&response, &rig, &beam, NULL, &stop);
    CHECK(response.verdict == RESPONSE_INTERRUPTED);
    CHECK(response.section.count == 0 && response.trace.rows == 0);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

TEST(the_trace_holds_the_peaks_force_and_no_force_inside_the_clearance) {
    Response response = respond("ibs", "drive.frequency=190", 0);
    double largest = 0;
    CHECK(response.trace.rows == (size_t)RESPONSE_TRACE_CYCLES * BEAM_SAMPLES);
    for (size_t row = 0; row < response.trace.rows; row++) {
        const double *at = trace_row(&response.trace, row);
        CHECK_NEAR(at[0], (double)row / 190 / BEAM_SAMPLES, 1e-12);
        CHECK(fabs(at[1]) > 0.127e-3 || at[3] == 0);
        largest = fmax(largest, fabs(at[3]));
    }
    CHECK(largest <= response.peaks.max && largest > 0.97 * response.peaks.max);
    response_clear(&response);
}

/* Runs from a state that only decays, without drive and contact. */
TEST(a_beam_that_comes_to_rest_is_periodic) {
    Beam beam = oscillator_beam("ibs", "drive.force=0");
    Rig rig = oscillator_beam_rig("ibs", "drive.force=0");
    double start[STATES_MOST];
    oscillator_start(&rig, 1, start);
    Response response;
    beam_cycle_respond(&response, &rig, &beam, start, NULL);
    CHECK_TEXT(response_verdict_name(response.verdict), "periodic");
    CHECK(response.orbit.period == 1);
    CHECK(response.peaks.max == 0);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

/* Settles a motion on its orbit and tells the largest forces of both sides on it. */
static OrbitImage settle(const Rig *rig, const double *start, Orbit *orbit, double peak[CYCLE_SIDES]) {
    Cycle cycle = beam_cycle_of(rig);
    double state[STATES_MOST];
    memcpy(state, start, rig->free.states * sizeof *state);
    CHECK(orbit_map(cycle, state, 600, NULL, NULL) == ORBIT_GOOD);
    CHECK(orbit_settle(orbit, cycle, state, 4, 1e-2, NULL) == ORBIT_GOOD);
    Motion motion = motion_create(rig, 0);
    motion_set_state(&motion, orbit->point);
    for (size_t i = 0; i < orbit->period; i++)
        motion_cycle(&motion);
    memcpy(peak, motion.peak, sizeof motion.peak);
    motion_destroy(&motion);
    return orbit_image(orbit, cycle, NULL);
}

/* A start and its mirror image: at 64 Hz set B has a pair of orbits, which hit one side harder than the other; at 203.7
 * Hz a period of 4 cannot be its own image; at 190 Hz one orbit is. */
TEST(the_mirror_image_of_a_start_leads_to_the_mirror_image_of_its_orbit) {
    static const struct {
        const char *setting;
        size_t period;
        OrbitImage image;
    } cases[] = {{"drive.frequency=64", 1, ORBIT_IMAGE_OTHER},
                 {"drive.frequency=203.7", 4, ORBIT_IMAGE_OTHER},
                 {"drive.frequency=190", 1, ORBIT_IMAGE_OWN}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        Rig rig = oscillator_beam_rig("ibs", cases[c].setting);
        Cycle cycle = beam_cycle_of(&rig);
        double start[STATES_MOST] = {0}, peak[CYCLE_SIDES], mirrored[CYCLE_SIDES];
        Orbit orbit, image;
        CHECK(settle(&rig, start, &orbit, peak) == cases[c].image);
        CycleMotion motion = cycle_create(cycle, 0, NULL);
        cycle.kind->set_state(motion.own, start);
        cycle.kind->mirror(motion.own);
        cycle.kind->state(motion.own, start);
        CHECK(settle(&rig, start, &image, mirrored) == cases[c].image);
        CHECK(orbit.period == cases[c].period && image.period == orbit.period);
        printf("     %s: %.3f and %.3f N, from the mirror image %.3f and %.3f N\n", cases[c].setting, peak[0], peak[1],
               mirrored[0], mirrored[1]);
        CHECK((orbit_distance(&orbit, cycle, image.point, NULL) > 1e-2) == (cases[c].image == ORBIT_IMAGE_OTHER));
        cycle.kind->set_state(motion.own, orbit.point);
        cycle.kind->mirror(motion.own);
        cycle.kind->state(motion.own, start);
        CHECK_NEAR(orbit_distance(&image, cycle, start, NULL), 0, 1e-8);
        CHECK_NEAR(image.largest, orbit.largest, 1e-8);
        for (int side = 0; side < CYCLE_SIDES; side++)
            CHECK_NEAR(mirrored[side], peak[1 - side], 1e-6);
        CHECK((fabs(peak[0] - peak[1]) > 10) == (cases[c].image == ORBIT_IMAGE_OTHER));
        cycle_destroy(&motion);
        orbit_clear(&orbit);
        orbit_clear(&image);
        rig_clear(&rig);
    }
}
