#include <math.h>
#include <stdio.h>
#include <string.h>

#include "beam/response.h"
#include "check.h"
#include "oscillator.h"

static Rig rig_of(Beam *beam) {
    Fault fault = {0};
    Rig rig;
    CHECK(rig_build(&rig, beam, "a beam", &fault));
    fault_clear(&fault);
    beam_free(beam);
    return rig;
}

/* Critical damping ------------------------------------------------------------------------------------------------ */

/* A mass of 1 kg in contact, x'' + 4 (1 + off) x' + (1 + 3) x = 3 g: but for `off`, which moves it by some `off` of its
 * way, x - 3 g / 4 = (g / 4 + (v + g / 2) t) exp(-2 t) from x = g. */
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

/* Places ---------------------------------------------------------------------------------------------------------- */

/* How far the tip is where its place says that it is not, of the clearance: outside the walls where it touches or
 * leaves, inside them where it is open. */
static double misplaced(const char *const *settings, size_t count, int cycles) {
    Beam beam = {0};
    Fault fault = {0};
    char path[200];
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", check_source());
    CHECK(beam_read(&beam, path, settings, count, &fault));
    Rig rig = rig_of(&beam);
    Motion motion = motion_create(&rig, 0);
    double worst = 0;
    for (int i = 0; i < cycles; i++) {
        while (motion.phase < rig.period && motion.status == MOTION_GOOD) {
            MotionPlace before = motion.place;
            motion_step(&motion, rig.period - motion.phase);
            double depth = fabs(motion_deflection(&motion)) - rig.clearance;
            bool inside = motion.place != MOTION_OPEN, crossed = inside != (before != MOTION_OPEN);
            worst = fmax(worst, crossed ? fabs(depth) : inside ? -depth : depth);
        }
        CHECK(motion_cycle(&motion) == MOTION_GOOD);
    }
    motion_destroy(&motion);
    double clearance = rig.clearance;
    rig_clear(&rig);
    return worst / clearance;
}

/* With much damping the tip leaves the wall at next to no speed, and may leave it and be back within a cell. */
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

/* Ends ------------------------------------------------------------------------------------------------------------ */

TEST(a_beam_without_a_force_rests_between_walls_that_touch_it) {
    for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++) {
        Beam beam = oscillator_beam("ibs", "joint.clearance=0");
        beam.force = 0;
        beam.release = release;
        Fault fault = {0};
        Rig rig;
        CHECK(rig_build(&rig, &beam, "ibs", &fault));
        Response response;
        response_run(&response, &rig, &beam, NULL, NULL);
        CHECK_TEXT(response_verdict_name(response.verdict), "periodic");
        CHECK(response.orbit.period == 1 && response.peaks.max == 0);
        response_clear(&response);
        rig_clear(&rig);
        beam_free(&beam);
    }
}

/* 9e8 cells in a cycle of the drive: an hour for ten cycles, in which nothing can stop it. */
TEST(vibrations_too_fast_to_follow_through_a_cycle_of_the_drive_are_a_fault) {
    static const char *const settings[] = {"beam.length=0.02", "shaker.position=0.01", "drive.frequency=1",
                                           "beam.modes=64", "beam.elements=200"};
    Beam beam = {0};
    Fault fault = {0};
    char path[200];
    snprintf(path, sizeof path, "%s/assets/beams/ibs.json", check_source());
    CHECK(beam_read(&beam, path, settings, 5, &fault));
    Rig rig;
    bool built = rig_build(&rig, &beam, "a beam", &fault);
    CHECK(!built);
    CHECK(fault.count == 1 && strstr(fault.lines[0], "drive.frequency") && strstr(fault.lines[0], "beam.modes"));
    if (built)
        rig_clear(&rig);
    fault_clear(&fault);
    beam_free(&beam);
}
