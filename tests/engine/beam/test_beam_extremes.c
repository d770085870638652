#include <math.h>
#include <string.h>

#include "beam/beam_cycle.h"
#include "beam/lanes.h"
#include "check.h"
#include "scratch.h"
#include "oscillator.h"

static Beam changed(const char *const *settings, size_t count) {
    Beam beam = {0};
    Fault fault = {0};
    CHECK(beam_read(&beam, scratch_source("assets/beams/ibs.json"), settings, count, &fault));
    check_say(&fault);
    return beam;
}

static Rig rig_of(Beam *beam) {
    Fault fault = {0};
    Rig rig;
    CHECK(rig_build(&rig, beam, "a beam", &fault));
    fault_clear(&fault);
    beam_free(beam);
    return rig;
}

/* Critical damping ------------------------------------------------------------------------------------------------ */

/* A mass of 1 kg in contact, x'' + 4 (1 + off) x' + (1 + 3) x = 3 g: for off = 0, x - 3 g / 4 = (g / 4 + (v + g / 2)
 * t) exp(-2 t) from x = g; `off` changes x by about `off` of its path. */
static void check_critical(double off, int release) {
    const double gap = 0.1, velocity = 0.3;
    Oscillator mass = {.omega = 1, .clearance = gap, .stiffness = 3, .damping = 4 * (1 + off), .release = release};
    Rig rig = oscillator_rig(&mass);
    Motion motion = motion_create(&rig, 0);
    motion_set_state(&motion, (double[]){gap * (1 + 1e-12), velocity});
    CHECK(motion.place == MOTION_UPPER);
    double time = 0, a = gap / 4, b = velocity + gap / 2;
    for (int i = 0; i < 20; i++) {
        time += motion_step(&motion, 0.02);
        double decay = exp(-2 * time);
        CHECK_NEAR(motion_deflection(&motion), 3 * gap / 4 + (a + b * time) * decay, 1e-8);
        CHECK_NEAR(motion_velocity(&motion), (b - 2 * (a + b * time)) * decay, 1e-8);
    }
    CHECK(motion.place == MOTION_UPPER);
    motion_destroy(&motion);
    rig_clear(&rig);
}

TEST(a_critically_damped_contact_moves_by_its_closed_form) {
    static const double off[] = {0, 2.3e-16, -2.3e-16, 1e-15, -1e-15, 1e-13, -1e-13, 1e-11, -1e-11, 1e-9, -1e-9};
    for (size_t i = 0; i < sizeof off / sizeof *off; i++)
        for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++)
            check_critical(off[i], release);
}

/* Resonance ------------------------------------------------------------------------------------------------------- */

/* x'' + x = sin(omega t) from rest: x = (sin(omega t) - omega sin t) / (1 - omega^2), which grows. */
TEST(an_undamped_mode_driven_near_its_own_frequency_grows_and_at_it_diverges) {
    static const double off[] = {0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-6, 1e-4};
    for (int i = 0; i < 7; i++) {
        Oscillator mass = {.omega = 1, .clearance = 1e3, .stiffness = 1};
        Rig rig = oscillator_rig(&mass);
        double omega = 1 + off[i];
        rig_drive(&rig, omega / (2 * M_PI), 1);
        Motion motion = motion_create(&rig, 0);
        CycleStatus status = CYCLE_GOOD;
        for (int cycle = 0; cycle < 10; cycle++)
            status = motion_cycle(&motion);
        if (off[i] < 1e-8) {
            CHECK(status == CYCLE_DIVERGED);
        } else {
            CHECK(status == CYCLE_GOOD);
            CHECK_NEAR(motion_deflection(&motion), -omega * sin(20 * M_PI / omega) / (1 - omega * omega), 1e-6);
        }
        motion_destroy(&motion);
        rig_clear(&rig);
    }
}

/* Sharing --------------------------------------------------------------------------------------------------------- */

/* Returns the relative distance of the last states of a rig built for `frequency` and of one built for 1 Hz and
 * shared. */
static double shared_apart(const char *const *settings, size_t count, double frequency) {
    Beam slow = changed(settings, count), fast = changed(settings, count);
    double force = fast.force, clearance = fast.clearance, end[2][128], difference = 0, length = 0;
    fast.frequency = frequency;
    slow.frequency = 1;
    Rig rigs[2] = {rig_of(&fast), rig_of(&slow)};
    for (int i = 0; i < 2; i++) {
        LanesRun run = {.frequency = frequency, .force = force, .clearance = clearance, .cycles = 20, .end = end[i]};
        lanes_run(&rigs[i], &run, 1, NULL);
        CHECK(run.status == CYCLE_GOOD && run.recorded == 20);
    }
    for (size_t i = 0; i < rigs[0].free.states; i++) {
        difference += (end[0][i] - end[1][i]) * (end[0][i] - end[1][i]);
        length += end[0][i] * end[0][i];
    }
    rig_clear(&rigs[0]);
    rig_clear(&rigs[1]);
    return sqrt(difference / length);
}

TEST(runs_of_a_rig_that_was_made_for_a_slower_drive_are_as_exact) {
    static const char *const one[] = {"beam.modes=1", "joint.clearance=1e-7", "drive.force=5000"};
    static const char *const soft[] = {"beam.modes=1", "joint.clearance=1e-7", "drive.force=5000",
                                       "joint.stiffness=1e4"};
    static const char *const four[] = {"beam.modes=4", "joint.clearance=1e-7", "drive.force=5000"};
    CHECK_NEAR(shared_apart(one, 3, 300), 0, 1e-9);
    CHECK_NEAR(shared_apart(soft, 4, 300), 0, 1e-9);
    CHECK_NEAR(shared_apart(one, 3, 5000), 0, 1e-9);
    CHECK_NEAR(shared_apart(four, 3, 20000), 0, 1e-9);
}

/* Steps ----------------------------------------------------------------------------------------------------------- */

/* Simulates a cycle in steps of a small part of a cell, smaller after a switch. */
static void fine_cycle(Motion *motion) {
    const double longest = motion->rig->cell / 37, shortest = motion->rig->cell / 1e4;
    double step = shortest, period = motion->rig->period;
    while (motion->phase < period && motion->status == CYCLE_GOOD) {
        size_t switches = motion->switches;
        motion_step(motion, fmin(step, period - motion->phase));
        step = motion->switches == switches ? fmin(1.3 * step, longest) : shortest;
    }
    motion_cycle(motion);
}

/* Returns the largest relative differences of state and peaks in a cycle. */
typedef struct Apart {
    double state, peak;
} Apart;

static void compare(const Motion *motion, const Motion *fine, Apart *apart) {
    double state[128], other[128], difference = 0, length = 0;
    motion_state(motion, state);
    motion_state(fine, other);
    for (size_t i = 0; i < motion->rig->free.states; i++) {
        difference += (state[i] - other[i]) * (state[i] - other[i]);
        length += state[i] * state[i];
    }
    apart->state = fmax(apart->state, sqrt(difference / length));
    for (int side = 0; side < 2; side++)
        if (fine->peak[side] > 0)
            apart->peak = fmax(apart->peak, fabs(motion->peak[side] / fine->peak[side] - 1));
}

/* Compares 40 cycles from rest with the same cycles in fine steps. */
static Apart step_apart(const char *const *settings, size_t count) {
    Beam beam = changed(settings, count);
    Rig rig = rig_of(&beam);
    Motion motion = motion_create(&rig, 0), fine = motion_create(&rig, 0);
    Apart apart = {0};
    for (int i = 0; i < 40; i++) {
        motion.peak[0] = motion.peak[1] = 0;
        motion_copy(&fine, &motion);
        CHECK(motion_cycle(&motion) == CYCLE_GOOD);
        fine_cycle(&fine);
        compare(&motion, &fine, &apart);
    }
    motion_destroy(&motion);
    motion_destroy(&fine);
    rig_clear(&rig);
    return apart;
}

static void check_steps(const char *const *settings, size_t count) {
    Apart apart = step_apart(settings, count);
    CHECK_NEAR(apart.state, 0, 1e-10);
    CHECK_NEAR(apart.peak, 0, 1e-9);
}

TEST(no_switch_and_no_peak_depends_on_the_length_of_the_steps) {
    static const char *const modes[] = {"beam.modes=1", "beam.modes=4", "beam.modes=12"};
    static const char *const damping[] = {"joint.damping=0", "joint.damping=200", "joint.damping=5000",
                                          "joint.damping=100000"};
    static const char *const releases[] = {"joint.release=force", "joint.release=gap"};
    for (int i = 0; i < 3 * 4 * 2; i++)
        check_steps((const char *const[]){modes[i / 8], damping[i / 2 % 4], releases[i % 2]}, 3);
}

/* The damper's effect ends long before the shortest period of a mode. */
TEST(a_contact_damped_far_beyond_the_critical_has_its_peaks_and_switches) {
    static const char *const soft[] = {"joint.release=gap",   "beam.modes=1",         "joint.damping=3000",
                                       "joint.stiffness=1e5", "joint.clearance=2e-7", "drive.frequency=150",
                                       "drive.force=5000"};
    static const char *const hard[] = {"joint.damping=3e5", "joint.stiffness=1e9"};
    check_steps(soft, sizeof soft / sizeof *soft);
    check_steps(hard, sizeof hard / sizeof *hard);
}

/* The tip leaves at nearly zero speed and returns to the wall within half a cell. */
TEST(a_tip_that_is_back_at_the_wall_within_a_cell_has_left_it) {
    static const char *const settings[] = {"beam.length=0.383953795",
                                           "beam.thickness=0.00689654632",
                                           "beam.modes=1",
                                           "beam.damping_ratio=0.9",
                                           "pivot.translational_stiffness=29965.1714",
                                           "pivot.rotational_stiffness=0",
                                           "shaker.position=0.0629737623",
                                           "shaker.stiffness=6226311.58",
                                           "shaker.moving_mass=0.0117172143",
                                           "shaker.damping=137.497633",
                                           "drive.frequency=94.0426349",
                                           "drive.force=196.5338",
                                           "joint.clearance=2.60371497e-07",
                                           "joint.stiffness=29770886.9",
                                           "joint.damping=966.977793",
                                           "joint.release=gap",
                                           "beam.elements=30"};
    check_steps(settings, sizeof settings / sizeof *settings);
}

/* The tip starts exactly at the wall and moves in: it touches once and, held by the spring of the base, leaves
 * within a cell. */
TEST(a_touch_exactly_at_the_wall_is_one_touch) {
    Oscillator mass = {.omega = 1, .clearance = 0.5, .damping = 100, .release = RELEASE_GAP};
    Rig rig = oscillator_rig(&mass);
    Motion motion = motion_create(&rig, 0);
    motion_set_state(&motion, (double[]){0.5, 0.1});
    while (motion.phase < 1)
        motion_step(&motion, 1 - motion.phase);
    CHECK(motion.switches == 2);
    CHECK(motion.place == MOTION_OPEN);
    motion_destroy(&motion);
    rig_clear(&rig);
}

/* Places ---------------------------------------------------------------------------------------------------------- */

/* Returns the largest violation of the tip's place, as a fraction of the clearance: outside the walls while touching
 * or leaving, inside them while open. */
static double misplaced(const char *const *settings, size_t count, int cycles) {
    Beam beam = changed(settings, count);
    Rig rig = rig_of(&beam);
    Motion motion = motion_create(&rig, 0);
    double worst = 0;
    for (int i = 0; i < cycles; i++) {
        while (motion.phase < rig.period && motion.status == CYCLE_GOOD) {
            MotionPlace before = motion.place;
            motion_step(&motion, rig.period - motion.phase);
            double depth = fabs(motion_deflection(&motion)) - rig.clearance;
            bool inside = motion.place != MOTION_OPEN, crossed = inside != (before != MOTION_OPEN);
            worst = fmax(worst, crossed ? fabs(depth) : inside ? -depth : depth);
        }
        CHECK(motion_cycle(&motion) == CYCLE_GOOD);
    }
    motion_destroy(&motion);
    double clearance = rig.clearance;
    rig_clear(&rig);
    return worst / clearance;
}

/* With much damping the tip leaves the wall at nearly zero speed, and may return within a cell. */
TEST(the_tip_is_where_its_place_says) {
    static const char *const settings[][4] = {
        {"joint.damping=200", "joint.stiffness=1.5e7", "joint.release=force", "beam.modes=12"},
        {"joint.damping=200", "joint.stiffness=1e9", "joint.release=gap", "beam.modes=40"},
        {"joint.damping=20000", "joint.stiffness=1e9", "joint.release=force", "beam.modes=12"},
        {"joint.damping=300000", "joint.stiffness=1e9", "joint.release=gap", "beam.modes=12"},
        {"joint.damping=300000", "joint.stiffness=1.5e7", "joint.release=force", "beam.modes=12"},
        {"joint.damping=300000", "joint.stiffness=1e9", "joint.release=force", "beam.modes=12"},
        {"joint.damping=1000000", "joint.stiffness=1e6", "joint.release=force", "beam.modes=12"},
    };
    for (size_t s = 0; s < sizeof settings / sizeof *settings; s++)
        CHECK_NEAR(misplaced(settings[s], 4, 200), 0, 1e-9);
}

/* A drive of 1,698 Hz on one mode of 30 Hz: a sixteenth of its period is less than a quarter of the mode's in contact.
 */
TEST(a_drive_faster_than_the_modes_switches_at_the_wall) {
    static const char *const settings[] = {"beam.length=0.339196782",
                                           "beam.thickness=0.00707965813",
                                           "beam.modes=1",
                                           "beam.damping_ratio=0.9",
                                           "pivot.translational_stiffness=12692118.8",
                                           "pivot.rotational_stiffness=961.477116",
                                           "shaker.position=0.018092951",
                                           "shaker.moving_mass=0.162372738",
                                           "shaker.stiffness=31640.3373",
                                           "shaker.damping=162.517916",
                                           "drive.frequency=1698.49182",
                                           "drive.force=363.04862",
                                           "joint.clearance=0",
                                           "joint.stiffness=168799368",
                                           "joint.damping=4424.43348"};
    Beam beam = changed(settings, sizeof settings / sizeof *settings);
    Rig rig = rig_of(&beam);
    Motion motion = motion_create(&rig, 0);
    motion_set_state(&motion, (double[]){33e-6, 69e-6});
    double largest = 0, crossing = 0;
    while (motion.phase < rig.period && motion.status == CYCLE_GOOD) {
        bool lower = motion.place == MOTION_LOWER || motion.place == MOTION_LOWER_LEAVING;
        motion_step(&motion, rig.period - motion.phase);
        double deflection = fabs(motion_deflection(&motion));
        if (lower != (motion.place == MOTION_LOWER || motion.place == MOTION_LOWER_LEAVING))
            crossing = fmax(crossing, deflection);
        largest = fmax(largest, deflection);
    }
    CHECK_NEAR(crossing / largest, 0, 1e-9);
    motion_destroy(&motion);
    rig_clear(&rig);
}

/* Ends ------------------------------------------------------------------------------------------------------------ */

TEST(a_beam_without_a_force_rests_between_walls_that_touch_it) {
    static const char *const settings[][3] = {{"joint.clearance=0", "drive.force=0", "joint.release=force"},
                                              {"joint.clearance=0", "drive.force=0", "joint.release=gap"}};
    for (int release = 0; release < 2; release++) {
        Beam beam = changed(settings[release], 3), same = changed(settings[release], 3);
        Rig rig = rig_of(&same);
        Response response;
        beam_cycle_respond(&response, &rig, &beam, NULL, NULL);
        CHECK_TEXT(response_verdict_name(response.verdict), "periodic");
        CHECK(response.orbit.period == 1 && response.peaks.max == 0);
        response_clear(&response);
        rig_clear(&rig);
        beam_free(&beam);
    }
}

/* With 9e8 cells per cycle of the drive ten cycles take an hour, without a chance to interrupt. */
TEST(vibrations_too_fast_to_follow_through_a_cycle_of_the_drive_are_a_fault) {
    static const char *const settings[] = {"beam.length=0.02", "shaker.position=0.01", "drive.frequency=1",
                                           "beam.modes=64", "beam.elements=200"};
    Beam beam = changed(settings, 5);
    Fault fault = {0};
    Rig rig;
    bool built = rig_build(&rig, &beam, "a beam", &fault);
    CHECK(!built);
    CHECK(fault.count == 1 && strstr(fault.lines[0], "drive.frequency") && strstr(fault.lines[0], "beam.modes"));
    if (built)
        rig_clear(&rig);
    fault_clear(&fault);
    beam_free(&beam);
}
