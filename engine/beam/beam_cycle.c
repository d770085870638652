#include "beam/beam_cycle.h"

#include <math.h>

#include "base/memory.h"
#include "beam/lanes.h"
#include "cycle/survival.h"

static const TraceColumn columns[] = {[BEAM_TIME] = {"time", "s"},
                                      [BEAM_DEFLECTION] = {"displacement", "m"},
                                      [BEAM_VELOCITY] = {"velocity", "m/s"},
                                      [BEAM_FORCE] = {"force", "N"}};

static size_t states_of(const void *given) {
    return ((const Rig *)given)->free.states;
}

static double period_of(const void *given) {
    return ((const Rig *)given)->period;
}

static double rest_state(const void *given) {
    return rig_rest_state(given);
}

/* A cycle of a beam is short: a request to stop waits for its end. */
static void *create(const void *given, size_t tangents, const Stop *stop) {
    (void)stop;
    Motion *motion = memory_zeroed(1, sizeof *motion);
    *motion = motion_create(given, tangents);
    return motion;
}

static void destroy(void *motion) {
    motion_destroy(motion);
    memory_free(motion);
}

static void copy(void *to, const void *from) {
    motion_copy(to, from);
}

static void state_of(const void *motion, double *state) {
    motion_state(motion, state);
}

static void set_state(void *motion, const double *state) {
    motion_set_state(motion, state);
}

static void tangent_of(const void *motion, size_t index, double *tangent) {
    motion_tangent(motion, index, tangent);
}

static void set_tangent(void *motion, size_t index, const double *tangent) {
    motion_set_tangent(motion, index, tangent);
}

static void unit_tangents(void *motion) {
    motion_unit_tangents(motion);
}

static void mirror(void *own) {
    Motion *motion = own;
    double half = motion->rig->period / 2, *state = memory_zeroed(motion->rig->free.states, sizeof *state);
    while (motion->status == CYCLE_GOOD && motion->phase < half)
        motion_step(motion, half - motion->phase);
    motion_state(motion, state);
    for (size_t i = 0; i < motion->rig->free.states; i++)
        state[i] = -state[i];
    motion_set_state(motion, state);
    memory_free(state);
}

static CycleStatus run(void *motion) {
    return motion_cycle(motion);
}

static CycleStatus status_of(const void *motion) {
    return ((const Motion *)motion)->status;
}

static CycleTally tally_of(const void *own) {
    const Motion *motion = own;
    return (CycleTally){.switches = motion->switches, .grazes = motion->grazes, .contact_time = motion->contact_time};
}

static double *peaks_of(void *motion) {
    return ((Motion *)motion)->peak;
}

static void tip_of(const void *motion, double *tip) {
    tip[0] = motion_deflection(motion);
    tip[1] = motion_velocity(motion);
}

static void sample(void *own, int part, double *row) {
    Motion *motion = own;
    double until = motion->rig->period * (part + 1) / BEAM_SAMPLES;
    row[BEAM_DEFLECTION] = motion_deflection(motion);
    row[BEAM_VELOCITY] = motion_velocity(motion);
    row[BEAM_FORCE] = motion_force(motion);
    while (motion->status == CYCLE_GOOD && motion->phase < until)
        motion_step(motion, until - motion->phase);
}

static size_t saved_size(const void *given) {
    return motion_saved_size(given);
}

static void save(const void *motion, double *saved) {
    motion_save(motion, saved);
}

static void restore(void *motion, const double *saved) {
    motion_restore(motion, saved);
}

static double rest_tip(const void *given) {
    return rig_rest_deflection(given);
}

static void many(const void *given, CycleRun *runs, size_t count, const Stop *stop) {
    const Rig *rig = given;
    LanesRun *lanes = memory_zeroed(count, sizeof *lanes);
    for (size_t i = 0; i < count; i++)
        lanes[i] = (LanesRun){.frequency = rig->omega / (2 * M_PI),
                              .force = rig->force,
                              .clearance = rig->clearance,
                              .start = runs[i].start,
                              .cycles = (int)runs[i].cycles,
                              .peak = runs[i].peak,
                              .deflection = runs[i].deflection,
                              .velocity = runs[i].velocity,
                              .end = runs[i].end};
    lanes_run(rig, lanes, count, stop);
    for (size_t i = 0; i < count; i++) {
        runs[i].status = lanes[i].status;
        runs[i].recorded = lanes[i].recorded;
    }
    memory_free(lanes);
}

const CycleKind beam_cycle = {.columns = columns,
                              .column_count = sizeof columns / sizeof *columns,
                              .samples = BEAM_SAMPLES,
                              .closing = 1e-11,
                              .cycles_least = BEAM_CYCLES_LEAST,
                              .cycles_most = BEAM_CYCLES_MOST,
                              .lanes = SURVIVAL_LANES,
                              .lane_cycles = SURVIVAL_CYCLES,
                              .lane_apart = 300,
                              .together = 16,
                              .states = states_of,
                              .period = period_of,
                              .rest_tip = rest_tip,
                              .rest_state = rest_state,
                              .create = create,
                              .destroy = destroy,
                              .copy = copy,
                              .state = state_of,
                              .set_state = set_state,
                              .tangent = tangent_of,
                              .set_tangent = set_tangent,
                              .unit_tangents = unit_tangents,
                              .mirror = mirror,
                              .run = run,
                              .status = status_of,
                              .tally = tally_of,
                              .peaks = peaks_of,
                              .tip = tip_of,
                              .sample = sample,
                              .saved_size = saved_size,
                              .save = save,
                              .restore = restore,
                              .many = many};

Cycle beam_cycle_of(const Rig *rig) {
    return (Cycle){&beam_cycle, rig};
}

CycleMotion beam_cycle_motion(Motion *motion) {
    return (CycleMotion){beam_cycle_of(motion->rig), motion, motion->rig->free.states, motion->tangents};
}

void beam_cycle_respond(Response *response, const Rig *rig, const Beam *beam, const double *start, const Stop *stop) {
    response_run(response, beam_cycle_of(rig), beam->transient_cycles, beam->cycles, start, stop);
}

double beam_cycle_exponent_sum(const Rig *rig, double contact_share) {
    const Modes *modes = &rig->modes;
    double sum = 0;
    for (size_t i = 0; i < modes->count; i++)
        sum -= modes->damping[i * modes->count + i] + contact_share * rig->damping * modes->tip[i] * modes->tip[i];
    return sum;
}
