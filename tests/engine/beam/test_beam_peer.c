#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "beam/beam_cycle.h"
#include "check.h"
#include "experiment/beam_experiment.h"
#include "oscillator.h"
#include "peer.h"
#include "study/study.h"

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
TEST(cvode_agrees_at_twelve_untuned_frequencies_of_both_sets) {
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

/* A second driver: what a beam is, told without the program's stepping, orbits, tangents and verdicts. CVODE goes from
 * rest through the transient; a motion is periodic when it repeats; a second one, a millionth away, tells by how much
 * they part in each cycle. */
enum { SETTLING = 300, WATCHED = 160, LONGEST = 64 /* cycles, of a period */, BATCHES = 16 };

typedef struct Told {
    size_t period;          /* 0: it did not repeat */
    double peak;            /* N, largest force in the cycles watched, or on the orbit */
    double exponent, blur;  /* per cycle, and standard error */
    double forces[WATCHED]; /* N, largest of each cycle */
} Told;

static double distance(const double *a, const double *b, size_t states) {
    double sum = 0;
    for (size_t i = 0; i < states; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum);
}

/* Returns the mean of values and sets its standard error, from the means of batches. */
static double mean_of(const double *values, size_t count, double *error) {
    double sum = 0, square = 0;
    size_t size = count / BATCHES;
    for (size_t b = 0; b < BATCHES; b++) {
        double mean = 0;
        for (size_t i = 0; i < size; i++)
            mean += values[b * size + i] / (double)size;
        sum += mean;
        square += mean * mean;
    }
    double mean = sum / BATCHES;
    *error = sqrt(fmax(0, square / BATCHES - mean * mean) / (BATCHES - 1));
    return mean;
}

/* Returns the period after which the last states (count x states) repeat, or 0. */
static size_t find_period(const double *states, size_t count, size_t size) {
    static const double zero[PEER_STATES_MOST];
    const double *last = states + (count - 1) * size;
    for (size_t p = 1; p <= LONGEST; p++) {
        double apart = 0;
        for (size_t k = 0; k < LONGEST; k++)
            apart = fmax(apart, distance(last - k * size, last - (k + p) * size, size));
        if (apart < 1e-3 * distance(last, zero, size))
            return p;
    }
    return 0;
}

static Told drive(const Rig *rig) {
    Told told = {0};
    size_t size = rig->free.states;
    double start[PEER_STATES_MOST] = {0}, beside[PEER_STATES_MOST], growth[WATCHED];
    double *states = memory_zeroed(WATCHED * size, sizeof *states);
    Peer *peer = peer_create(rig, start, 1e-8), *other = peer_create(rig, start, 1e-8);
    for (int i = 0; i < SETTLING; i++)
        peer_cycle(peer);
    for (size_t i = 0; i < WATCHED; i++) {
        const double *at = peer_state(peer);
        double length = distance(at, start, size), apart = i ? distance(at, peer_state(other), size) : 1;
        for (size_t k = 0; k < size; k++) /* at first all modes are moved */
            beside[k] = at[k] + 1e-6 * length * (i ? (peer_state(other)[k] - at[k]) / apart : 1 / sqrt((double)size));
        peer_move(other, beside, SETTLING + i);
        peer_cycle(peer);
        peer_cycle(other);
        growth[i] = log(distance(peer_state(peer), peer_state(other), size) / (1e-6 * length));
        told.forces[i] = peer_peak(peer);
        memcpy(states + i * size, peer_state(peer), size * sizeof *states);
    }
    told.period = find_period(states, WATCHED, size);
    for (size_t i = told.period ? WATCHED - told.period : 0; i < WATCHED; i++)
        told.peak = fmax(told.peak, told.forces[i]);
    told.exponent = mean_of(growth, WATCHED, &told.blur);
    peer_destroy(peer);
    peer_destroy(other);
    memory_free(states);
    return told;
}

typedef struct Driven {
    const char *set, *setting; /* NULL: none */
    double frequency;
    Told told;
    Response response;
    double least, most; /* N, of the program's largest forces in as many cycles, from STARTS random starts */
} Driven;

enum { STARTS = 256 };

/* True if a motion repeats so soon that the second driver can tell. */
static bool repeats(const Response *response) {
    return response->orbit.period > 0 && response->orbit.period <= LONGEST;
}

/* Finds how much the largest force in WATCHED cycles depends on the start. */
static void find_range(Driven *one, Beam *beam) {
    Experiment experiment;
    Fault fault = {0};
    beam->transient_cycles = SETTLING;
    beam->cycles = WATCHED;
    one->least = HUGE_VAL;
    if (!beam_experiment_of(&experiment, beam, beam->name, &fault)) {
        fault_clear(&fault);
        return;
    }
    Study study = {.experiment = &experiment, .passes = {STUDY_RESET}, .pass_count = 1, .runs = STARTS, .seed = 1};
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 1});
    for (size_t i = 0; i < STARTS; i++) {
        double peak = study.trials[i].observed[BEAM_PEAK_MAX];
        one->least = fmin(one->least, peak);
        one->most = fmax(one->most, peak);
    }
    study_clear(&study);
    beam_experiment_close(&experiment);
}

static void drive_both(void *context, size_t i) {
    Driven *one = (Driven *)context + i;
    Beam beam = oscillator_beam(one->set, one->setting);
    Fault fault = {0};
    Rig rig;
    beam.frequency = one->frequency;
    if (rig_build(&rig, &beam, beam.name, &fault)) {
        beam_cycle_respond(&one->response, &rig, &beam, NULL, NULL);
        one->told = drive(&rig);
        if (!repeats(&one->response))
            find_range(one, &beam);
        rig_clear(&rig);
    }
    fault_clear(&fault);
    beam_free(&beam);
}

/* The period, four digits of the largest force of an orbit, and the exponent within four standard errors. Of a motion
 * that does not repeat, the largest force is one of those from other starts. */
static void compare(const Driven *one) {
    const Response *response = &one->response;
    const Told *told = &one->told;
    const double digits = 1e-4, apart = hypot(told->blur, response->exponent.error);
    bool orbit = repeats(response);
    CHECK(response_is_told(response->verdict));
    CHECK(told->period == (orbit ? response->orbit.period : 0));
    CHECK_NEAR(told->exponent, response->exponent.value, 4 * apart + (orbit ? 0.01 : 0));
    if (orbit) {
        CHECK_NEAR(told->peak / response->orbit_peak, 1, digits);
    } else {
        CHECK(told->peak > (1 - digits) * one->least && told->peak < (1 + digits) * one->most);
    }
}

/* Drives all by both programs, prints what either says, and compares. */
static void compare_all(Driven *all, size_t count) {
    parallel_for(2, count, drive_both, all);
    for (size_t i = 0; i < count; i++) {
        const Response *response = &all[i].response;
        const Told *told = &all[i].told;
        printf("     %-5s %7g Hz %s: %-14s period %2zu %8.2f N %+.4f | CVODE period %2zu %8.2f N %+.3f \u00b1 %.3f\n",
               all[i].set, all[i].frequency, all[i].setting ? all[i].setting : "", response_name(response),
               response->orbit.period, response->orbit.period ? response->orbit_peak : response->peaks.max,
               response->exponent.value, told->period, told->peak, told->exponent, told->blur);
        compare(&all[i]);
        response_clear(&all[i].response);
    }
}

LONG_TEST(a_second_driver_tells_the_same_at_twelve_untuned_frequencies_of_both_sets) {
    static const char *const sets[] = {"ibs", "ibs-r"};
    Driven *all = memory_zeroed(2 * UNTUNED, sizeof *all);
    for (size_t i = 0; i < 2 * UNTUNED; i++) {
        all[i].set = sets[i / UNTUNED];
        all[i].frequency = untuned[i % UNTUNED];
    }
    compare_all(all, 2 * UNTUNED);
    memory_free(all);
}

/* Beams other than the two sets, and places where a small error would show: just beyond the end of the branch without
 * contact (63.0773 N), between two folds (276.632 and 276.658 Hz), a hard contact, a heavy tip, a narrow joint and one
 * without damping. */
LONG_TEST(a_second_driver_tells_the_same_of_other_beams_and_near_folds_and_touches) {
    static const struct {
        const char *set, *setting;
        double frequency;
    } hard[] = {{"ibs", "drive.force=63.1", 250},
                {"ibs", NULL, 276.645},
                {"ibs-r", "joint.stiffness=6e7", 233.3},
                {"ibs-r", "beam.tip_mass=0.1", 147.3},
                {"ibs-r", "joint.clearance=0.00002", 291.7},
                {"ibs", "joint.damping=0", 191.3}};
    enum { HARD = sizeof hard / sizeof *hard };
    Driven all[HARD] = {0};
    for (size_t i = 0; i < HARD; i++) {
        all[i].set = hard[i].set;
        all[i].setting = hard[i].setting;
        all[i].frequency = hard[i].frequency;
    }
    compare_all(all, HARD);
}
