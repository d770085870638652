#include <complex.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "oscillator.h"

enum { STATES_MOST = 128 };

/* Returns the ratio of the velocities at release and touch, and the contact time, of a mass that flies to the upper
 * wall. */
static double collide(double ratio, int release, double *time) {
    Oscillator mass = {.omega = 1e-5, .clearance = 1, .stiffness = 1, .damping = 2 * ratio, .release = release};
    Rig rig = oscillator_rig(&mass);
    Motion motion = motion_create(&rig, 0);
    motion_set_state(&motion, (double[]){0, 1});
    while (motion.place == MOTION_OPEN)
        motion_step(&motion, HUGE_VAL);
    CHECK(motion.place == MOTION_UPPER);
    CHECK_NEAR(motion_deflection(&motion), 1, 1e-12);
    double before = motion_velocity(&motion);
    *time = 0;
    while (motion.place == MOTION_UPPER)
        *time += motion_step(&motion, HUGE_VAL);
    double after = motion_velocity(&motion);
    motion_destroy(&motion);
    rig_clear(&rig);
    return -after / before;
}

TEST(a_collision_released_at_zero_force_has_its_closed_form) {
    static const double ratios[] = {0.01, 0.05, 0.1, 0.2, 0.5};
    static const double table[] = {0.969265, 0.858758, 0.744079, 0.571740, 0.298436};
    for (int i = 0; i < 5; i++) {
        double z = ratios[i], w = sqrt(1 - z * z), time;
        double restitution = collide(z, RELEASE_FORCE, &time);
        double expected = (M_PI - atan2(2 * z * w, w * w - z * z)) / w;
        CHECK_NEAR(time, expected, 1e-9);
        CHECK_NEAR(restitution, exp(-z * expected), 1e-9);
        CHECK_NEAR(restitution, table[i], 1e-6);
    }
}

TEST(a_collision_released_at_the_gap_has_its_closed_form) {
    static const double ratios[] = {0.01, 0.05, 0.1, 0.2, 0.5};
    for (int i = 0; i < 5; i++) {
        double z = ratios[i], w = sqrt(1 - z * z), time;
        CHECK_NEAR(collide(z, RELEASE_GAP, &time), exp(-M_PI * z / w), 1e-9);
        CHECK_NEAR(time, M_PI / w, 1e-9);
    }
}

TEST(a_mass_between_two_springs_has_the_period_of_half_a_swing_each_and_two_flights) {
    Oscillator mass = {.omega = 1e-5, .clearance = 0.3, .stiffness = 4};
    Rig rig = oscillator_rig(&mass);
    Motion motion = motion_create(&rig, 0);
    motion_set_state(&motion, (double[]){0, 0.7});
    double time = 0, first = 0;
    int seen = 0;
    while (seen < 4) {
        MotionPlace place = motion.place;
        time += motion_step(&motion, HUGE_VAL);
        if (place == MOTION_OPEN && motion.place == MOTION_UPPER && seen++ == 0)
            first = time;
    }
    CHECK_NEAR((time - first) / 3, 2 * M_PI / 2 + 4 * 0.3 / 0.7, 1e-8);
    motion_destroy(&motion);
    rig_clear(&rig);
}

TEST(the_steady_amplitude_is_the_sum_over_modes) {
    Rig rig = oscillator_beam_rig("ibs", NULL);
    for (double frequency = 20; frequency < 500; frequency += 37) {
        rig_drive(&rig, frequency, 225);
        double complex sum = 0;
        const Modes *modes = &rig.modes;
        for (size_t i = 0; i < modes->count; i++) {
            double omega = modes->frequency[i];
            sum += modes->tip[i] * modes->shaker[i] * 225 /
                   (omega * omega - rig.omega * rig.omega + I * 2 * 0.03 * omega * rig.omega);
        }
        CHECK_NEAR(rig_free_amplitude(&rig), cabs(sum), 1e-12 * cabs(sum));
    }
    rig_clear(&rig);
}

TEST(an_orbit_without_impacts_is_there_exactly_when_the_steady_amplitude_is_below_the_clearance) {
    Rig rig = oscillator_beam_rig("ibs", NULL);
    double state[STATES_MOST];
    for (double frequency = 30; frequency < 500; frequency += 53) {
        for (int above = 0; above < 2; above++) {
            rig_drive(&rig, frequency, 1);
            double touching = rig.clearance / rig_free_amplitude(&rig);
            rig_drive(&rig, frequency, touching * (above ? 1 + 1e-11 : 1 - 1e-11));
            regime_state(&rig.free, rig.steady_free.cosine, state);
            Motion motion = motion_create(&rig, 0);
            motion_set_state(&motion, state);
            for (int i = 0; i < 20; i++)
                CHECK(motion_cycle(&motion) == CYCLE_GOOD);
            CHECK((motion.switches > 0) == above);
            motion_destroy(&motion);
        }
    }
    rig_clear(&rig);
}

TEST(an_orbit_that_grazes_is_counted) {
    Rig rig = oscillator_beam_rig("ibs", NULL);
    double state[STATES_MOST];
    rig_drive(&rig, 150, 1);
    rig_drive(&rig, 150, rig.clearance / rig_free_amplitude(&rig) * (1 - 1e-7));
    regime_state(&rig.free, rig.steady_free.cosine, state);
    Motion motion = motion_create(&rig, 0);
    motion_set_state(&motion, state);
    for (int i = 0; i < 10; i++)
        motion_cycle(&motion);
    CHECK(motion.switches == 0);
    CHECK(motion.grazes == 20);
    motion_destroy(&motion);
    rig_clear(&rig);
}

/* Compares a motion with its mirror image, deflections and force with the opposite sign, to the last bit. */
TEST(the_mirror_image_of_a_motion_is_a_motion) {
    for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++) {
        Rig rig = oscillator_beam_rig("ibs", release == RELEASE_GAP ? "joint.release=gap" : NULL);
        double start[STATES_MOST], state[STATES_MOST], mirror[STATES_MOST];
        size_t states = rig.free.states;
        oscillator_start(&rig, 5, start);
        Motion motion = motion_create(&rig, 0);
        motion_set_state(&motion, start);
        for (int i = 0; i < 60; i++)
            motion_cycle(&motion);
        motion_state(&motion, state);
        double peak = motion.peak[0];
        rig_drive(&rig, 1 / rig.period, -rig.force);
        for (size_t i = 0; i < states; i++)
            start[i] = -start[i];
        motion_set_state(&motion, start);
        motion.peak[1] = 0;
        for (int i = 0; i < 60; i++)
            motion_cycle(&motion);
        motion_state(&motion, mirror);
        double apart = 0;
        for (size_t i = 0; i < states; i++)
            apart = fmax(apart, fabs(state[i] + mirror[i]));
        CHECK_NEAR(apart, 0, 0);
        CHECK_NEAR(motion.peak[1], peak, 0);
        CHECK(motion.switches > 200);
        motion_destroy(&motion);
        rig_clear(&rig);
    }
}

/* Returns the relative distance between the motion from the mirrored state of half a period earlier and the mirror
 * image of the motion, after some cycles. */
static double apart_by_half_a_period(const char *setting, int release, int cycles) {
    Rig rig = oscillator_beam_rig("ibs", setting);
    rig.release = release;
    size_t states = rig.free.states;
    double state[STATES_MOST], mirror[STATES_MOST], apart = 0, length = 0;
    oscillator_start(&rig, 5, state);
    Motion motion = motion_create(&rig, 0), image = motion_create(&rig, 0);
    motion_set_state(&motion, state);
    for (int i = 0; i <= cycles; i++) {
        while (motion.phase < rig.period / 2)
            motion_step(&motion, rig.period / 2 - motion.phase);
        motion_state(&motion, state);
        if (i == 0) {
            for (size_t k = 0; k < states; k++)
                mirror[k] = -state[k];
            motion_set_state(&image, mirror);
        } else {
            motion_cycle(&image);
        }
        motion_cycle(&motion);
    }
    motion_state(&image, mirror);
    for (size_t k = 0; k < states; k++) {
        apart += (state[k] + mirror[k]) * (state[k] + mirror[k]);
        length += state[k] * state[k];
    }
    motion_destroy(&motion);
    motion_destroy(&image);
    rig_clear(&rig);
    return sqrt(apart / length);
}

/* The drive half a period later is its own mirror image. In chaos rounding errors grow by exp(0.9) per cycle. */
TEST(the_mirror_image_half_a_period_later_is_a_motion) {
    for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++) {
        CHECK_NEAR(apart_by_half_a_period("drive.frequency=190", release, 100), 0, 1e-11);
        CHECK_NEAR(apart_by_half_a_period("drive.frequency=290", release, 100), 0, 1e-11);
        CHECK_NEAR(apart_by_half_a_period("drive.frequency=300", release, 5), 0, 1e-11);
        CHECK_NEAR(apart_by_half_a_period("drive.frequency=300", release, 15), 0, 1e-11 * exp(10 * 0.9));
        CHECK_NEAR(apart_by_half_a_period("joint.clearance=0", release, 100), 0, 1e-11);
    }
}

/* Returns the energy in the contact's spring, if the place is one of contact. */
static double spring_energy(const Motion *motion, MotionPlace place) {
    double depth = fabs(motion_deflection(motion)) - motion->rig->clearance;
    return motion_in_contact(place) ? motion->rig->stiffness * depth * depth / 2 : 0;
}

/* Returns the stored energy: of the beam and, in contact, of the spring. */
static double stored_energy(const Motion *motion, double *state) {
    double energy = spring_energy(motion, motion->place);
    motion_state(motion, state);
    for (size_t i = 0; i < motion->rig->free.states; i++)
        energy += state[i] * state[i] / 2;
    return energy;
}

/* Returns the input power, W, and the power of the dashpots. */
static double power_in(const Motion *motion, double *taken) {
    const Rig *rig = motion->rig;
    size_t n = rig->modes.count;
    double state[STATES_MOST], shaker = 0, *rate = state + n;
    motion_state(motion, state);
    double tip = motion_in_contact(motion->place) ? motion_velocity(motion) : 0;
    *taken = rig->damping * tip * tip;
    for (size_t i = 0; i < n; i++) {
        shaker += rig->modes.shaker[i] * rate[i];
        for (size_t j = 0; j < n; j++)
            *taken += rate[i] * rig->modes.damping[i * n + j] * rate[j];
    }
    return rig->force * sin(rig->omega * motion->phase) * shaker;
}

/* Adds work and losses of a step that begins at `motion`, by the eight-point Gauss-Legendre rule. */
static void integrate(const Motion *motion, Motion *probe, double step, double *work, double *lost) {
    static const double at[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    static const double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    for (int k = 0; k < 8; k++) {
        double place = k < 4 ? -at[k] : at[k - 4], taken;
        motion_copy(probe, motion);
        motion_step(probe, step * (1 + place) / 2);
        double given = power_in(probe, &taken);
        *work += given * weight[k % 4] * step / 2;
        *lost += taken * weight[k % 4] * step / 2;
    }
}

static void check_energy(const char *setting, int release) {
    Rig rig = oscillator_beam_rig("ibs", setting);
    rig.release = release;
    double state[STATES_MOST], work = 0, lost = 0;
    Motion motion = motion_create(&rig, 0), before = motion_create(&rig, 0), probe = motion_create(&rig, 0);
    double begin = stored_energy(&motion, state);
    for (int cycle = 0; cycle < 1000; cycle++) {
        while (motion.phase < rig.period) {
            motion_copy(&before, &motion);
            size_t switches = motion.switches;
            double step = motion_step(&motion, rig.period - motion.phase);
            integrate(&before, &probe, step, &work, &lost);
            if (motion.switches != switches) /* a spring released before it has recovered keeps its energy */
                lost += spring_energy(&motion, before.place) - spring_energy(&motion, motion.place);
        }
        CHECK(motion_cycle(&motion) == CYCLE_GOOD);
    }
    double change = stored_energy(&motion, state) - begin;
    CHECK(work > 100);
    CHECK_NEAR((work - lost - change) / work, 0, 1e-9);
    motion_destroy(&motion);
    motion_destroy(&before);
    motion_destroy(&probe);
    rig_clear(&rig);
}

LONG_TEST(work_put_in_is_dissipated_or_stored_over_a_thousand_cycles) {
    for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++) {
        check_energy("beam.modes=4", release);
        check_energy("joint.clearance=0", release);
    }
}

TEST(a_dashpot_at_the_shaker_takes_what_it_must) {
    check_energy("shaker.damping=20", RELEASE_FORCE);
}

TEST(switches_that_never_end_are_bounded_and_said) {
    Oscillator mass = {.omega = 1000, .clearance = 0, .stiffness = 1e6};
    Rig rig = oscillator_rig(&mass);
    Motion motion = motion_create(&rig, 0);
    motion_set_state(&motion, (double[]){0, 1});
    CHECK(motion_cycle(&motion) == CYCLE_CHATTERS);
    CHECK(motion.switches == MOTION_SWITCHES_MOST + 1);
    CHECK(motion_cycle(&motion) == CYCLE_CHATTERS);
    CHECK(motion.switches == MOTION_SWITCHES_MOST + 1);
    motion_destroy(&motion);
    rig_clear(&rig);
}

TEST(with_no_clearance_there_is_always_contact) {
    for (int release = RELEASE_FORCE; release <= RELEASE_GAP; release++) {
        Rig rig = oscillator_beam_rig("ibs", "joint.clearance=0");
        rig.release = release;
        Motion motion = motion_create(&rig, 0);
        for (int i = 0; i < 100; i++) {
            CHECK(motion_cycle(&motion) == CYCLE_GOOD);
            CHECK(motion.place != MOTION_OPEN);
        }
        CHECK(motion.switches > 100);
        motion_destroy(&motion);
        rig_clear(&rig);
    }
}

TEST(a_copy_goes_on_as_its_original_does) {
    Rig rig = oscillator_beam_rig("ibs", NULL);
    Motion motion = motion_create(&rig, 2), copy = motion_create(&rig, 2);
    motion_unit_tangents(&motion);
    for (int i = 0; i < 7; i++)
        motion_cycle(&motion);
    motion_step(&motion, 1e-6);
    motion_copy(&copy, &motion);
    motion_cycle(&motion);
    motion_cycle(&copy);
    CHECK(memcmp(motion.memory, copy.memory, motion.memory_size * sizeof(double)) == 0);
    motion_destroy(&motion);
    motion_destroy(&copy);
    rig_clear(&rig);
}
