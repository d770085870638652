#include "experiment/beam_experiment.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "base/stop.h"
#include "base/parameters_number.h"
#include "base/random.h"
#include "base/text.h"
#include "beam/beam_cycle.h"
#include "beam/lanes.h"
#include "cycle/motion_class.h"
#include "experiment/beam_numbers.h"
#include "study/types.h"

const char *const beam_experiment_window[] = {"drive.frequency", "beam.length", "joint.clearance", "drive.force"};

/* Number of trials simulated together: enough to fill the lanes, and few enough that two threads share a window of
 * types. */
enum { BATCH = 16, LONG = 100000 /* cycles: longer trials run singly, to save memory */ };

static const Observable observables[BEAM_OBSERVABLES] = {
    [BEAM_REGULAR] = {"regular", "1", "periodic (1) or not within the cycles seen (0)"},
    [BEAM_PERIOD] = {"period", "1", "period in cycles of the drive, 0 for none"},
    [BEAM_PEAK_MIN] = {"peak_min", "N", "smallest peak force"},
    [BEAM_PEAK_MAX] = {"peak_max", "N", "largest peak force"},
    [BEAM_PEAK_MEAN] = {"peak_mean", "N", "mean peak force"},
    [BEAM_TOUCHES] = {"touches", "1", "peaks a cycle, of both sides"},
    [BEAM_CLEARANCE_RATIO] = {"clearance_ratio", "1", "clearance by the static deflection of the tip, g/a"},
    [BEAM_MOTION] = {"motion", "1", "kind of motion"},
    [BEAM_LYAPUNOV] = {"lyapunov", "1", "largest exponent a cycle"},
    [BEAM_LYAPUNOV_ERROR] = {"lyapunov_error", "1", "standard error of the largest exponent"},
    [BEAM_ZERO_ONE] = {"zero_one", "1", "K of the 0-1 test"},
    [BEAM_ROTATION] = {"rotation", "1", "rotation number of a quasi-periodic motion"},
    [BEAM_HALF_LIFE] = {"half_life", "1", "half-life of a transient in cycles"},
    [BEAM_ATTRACTOR_PEAK] = {"attractor_peak", "N", "largest force on the orbit where it settles"},
};

static const Observable series = {"peak", "N", "peak force of each cycle and side"};

/* Initial deflection and velocity of the tip; NAN: drawn from the seed. */
typedef struct Start {
    double deflection, velocity; /* m, m/s */
} Start;

static const Parameter start_rows[] = {
    {.name = "start.deflection",
     .kind = PARAMETER_NUMBER,
     .offset = offsetof(Start, deflection),
     .unit = "m",
     .low = -1,
     .high = 1,
     .meaning = "deflection of the tip at the start"},
    {.name = "start.velocity",
     .kind = PARAMETER_NUMBER,
     .offset = offsetof(Start, velocity),
     .unit = "m/s",
     .low = -1000,
     .high = 1000,
     .meaning = "velocity of the tip at the start"},
};
static const ParameterTable start_table = {"start", start_rows, sizeof start_rows / sizeof *start_rows};

typedef struct Given {
    Beam beam;
    bool owned; /* the experiment owns the beam */
    bool thorough;
    size_t lanes, lane_cycles; /* that are watched in thorough trials */
    Rig rig;                   /* of the nominal beam */
} Given;

/* Parameters ------------------------------------------------------------------------------------------------------ */

static bool is_of_start(const Parameter *row) {
    return row >= start_rows && row < start_rows + start_table.count;
}

static bool is_number(const Parameter *row) {
    return row->kind == PARAMETER_NUMBER || row->kind == PARAMETER_WHOLE;
}

static const Parameter *find_parameter(const void *given, const char *name) {
    (void)given;
    const Parameter *row = parameters_find(beam_table(), name);
    row = row ? row : parameters_find(&start_table, name);
    return row && is_number(row) ? row : NULL;
}

static void tell_unknown(const void *given, const char *name, const char *place, Fault *fault) {
    (void)given;
    char path[200];
    snprintf(path, sizeof path, "%s", place);
    JsonFile file = {.path = path, .root = json_null()};
    JsonNode node = json_root(&file);
    const Parameter *row = parameters_find(beam_table(), name);
    if (row)
        fault_add(fault, "%s%s is not a number: %s", place, row->name, row->meaning);
    else
        parameters_fault_unknown(beam_table(), name, &node, fault);
}

static double nominal(const void *given, const char *name) {
    const Parameter *row = find_parameter(given, name);
    return !row || is_of_start(row) ? 0 : parameters_number_get(row, &((const Given *)given)->beam);
}

/* Trials ---------------------------------------------------------------------------------------------------------- */

/* The beam and initial state of a trial. */
typedef struct Case {
    Trial *trial;
    Beam beam; /* its texts belong to the nominal beam */
    Start start;
    bool made;
} Case;

/* Moves the first error to the trial. */
static void keep_fault(Trial *trial, Fault *fault) {
    trial->fault = text_copy(fault->lines[0]);
    trial->done = true;
    fault_clear(fault);
}

/* Sets the trial's values in the nominal beam; if they are invalid, the trial gets the reason. */
static void make_case(const Given *given, const char *const *names, size_t name_count, Trial *trial, Case *made) {
    *made = (Case){.trial = trial, .beam = given->beam, .start = {NAN, NAN}};
    Fault fault = {0};
    Arena none = {0}; /* numbers need no memory */
    for (size_t i = 0; i < name_count; i++) {
        const Parameter *row = find_parameter(given, names[i]);
        JsonFile file = {.path = "", .root = json_number(trial->at[i])};
        JsonNode node = json_root(&file);
        if (row)
            parameters_read_value(row, is_of_start(row) ? (void *)&made->start : (void *)&made->beam, &node, &none,
                                  &fault);
        else
            fault_add(&fault, "%s is not a numeric parameter of a beam", names[i]);
        json_decref(file.root);
    }
    if (fault.total || !beam_check(&made->beam, given->beam.name, &fault)) {
        keep_fault(trial, &fault);
        made->made = true;
    }
}

/* Returns the static deflection of the tip under the drive's amplitude without the joint, m. */
static double static_deflection(const Modes *modes, double force) {
    double sum = 0;
    for (size_t i = 0; i < modes->count; i++)
        sum += modes->tip[i] * modes->shaker[i] / (modes->frequency[i] * modes->frequency[i]);
    return fabs(sum * force);
}

/* Returns the largest velocity of the tip without the joint, m/s. */
static double free_speed(const Beam *beam, const Rig *rig) {
    Rig own = rig_share(rig, beam->frequency, beam->force, beam->clearance);
    double speed = own.omega * rig_free_amplitude(&own);
    rig_clear_shared(&own);
    return speed;
}

/* Sets the steady response without the joint, if it stays within the clearance. */
static bool start_free(const Case *one, const Rig *rig, double *state) {
    Rig own = rig_share(rig, one->beam.frequency, one->beam.force, one->beam.clearance);
    bool inside =
        rig_free_amplitude(&own) < one->beam.clearance && isnan(one->start.deflection) && isnan(one->start.velocity);
    if (inside)
        regime_state(&own.free, own.steady_free.cosine, state);
    rig_clear_shared(&own);
    return inside;
}

/* Computes the initial state (states) of a case. */
static void make_start(const Case *one, const Rig *rig, double *state) {
    bool free = one->trial->seed == BEAM_EXPERIMENT_FREE;
    if (free && start_free(one, rig, state))
        return;
    Random random = random_seed(free ? TYPES_STARTS - 1 : one->trial->seed, 0);
    bool chance = one->trial->seed != 0;
    double across = chance ? 2 * random_uniform(&random) - 1 : 0, along = chance ? 2 * random_uniform(&random) - 1 : 0;
    double deflection = isnan(one->start.deflection) ? across * one->beam.clearance : one->start.deflection;
    double velocity = !isnan(one->start.velocity) ? one->start.velocity
                      : chance                    ? along * free_speed(&one->beam, rig)
                                                  : 0;
    double compliance = 0;
    const Modes *modes = &rig->modes;
    for (size_t i = 0; i < modes->count; i++)
        compliance += modes->tip[i] * modes->tip[i] / (modes->frequency[i] * modes->frequency[i]);
    for (size_t i = 0; i < modes->count; i++) {
        double shape = modes->tip[i] / (modes->frequency[i] * modes->frequency[i] * compliance);
        state[i] = modes->frequency[i] * shape * deflection;
        state[modes->count + i] = shape * velocity;
    }
}

/* Lists the peaks (2 x cycles) of cycles with contact. */
static void list_peaks(Trial *trial, const double *peak, size_t cycles) {
    trial->series = memory_zeroed(2 * cycles, sizeof *trial->series);
    double sum = 0, smallest = HUGE_VAL, largest = 0;
    for (size_t i = 0; i < 2 * cycles; i++)
        if (peak[i] > 0) {
            trial->series[trial->series_count++] = peak[i];
            sum += peak[i];
            smallest = fmin(smallest, peak[i]);
            largest = fmax(largest, peak[i]);
        }
    size_t count = trial->series_count;
    double *observed = trial->observed;
    observed[BEAM_PEAK_MIN] = !cycles ? (double)NAN : count ? smallest : 0;
    observed[BEAM_PEAK_MAX] = !cycles ? (double)NAN : largest;
    observed[BEAM_PEAK_MEAN] = !cycles ? (double)NAN : count ? sum / (double)count : 0;
    observed[BEAM_TOUCHES] = cycles ? (double)count / (double)cycles : (double)NAN;
}

static void begin_observed(const Case *one, const Rig *rig) {
    for (size_t i = 0; i < BEAM_OBSERVABLES; i++)
        one->trial->observed[i] = NAN;
    double deflection = static_deflection(&rig->modes, one->beam.force);
    one->trial->observed[BEAM_CLEARANCE_RATIO] = deflection > 0 ? one->beam.clearance / deflection : (double)NAN;
}

static void tell_regular(Trial *trial, bool regular, size_t period) {
    trial->observed[BEAM_REGULAR] = regular;
    trial->observed[BEAM_PERIOD] = (double)period;
}

/* Runs ------------------------------------------------------------------------------------------------------------ */

/* Returns the numbers per lane: two states, then four numbers per cycle. */
static size_t lane_room(const Case *one, size_t states) {
    return 2 * states + 4 * (size_t)one->beam.cycles;
}

static LanesRun make_lane(const Case *one, size_t states, double *room) {
    size_t cycles = (size_t)one->beam.cycles;
    return (LanesRun){.frequency = one->beam.frequency,
                      .force = one->beam.force,
                      .clearance = one->beam.clearance,
                      .start = room,
                      .end = room + states,
                      .transient_cycles = one->beam.transient_cycles,
                      .cycles = one->beam.cycles,
                      .peak = room + 2 * states,
                      .deflection = room + 2 * states + 2 * cycles,
                      .velocity = room + 2 * states + 3 * cycles};
}

static void tell_lane(const Case *one, const LanesRun *lane) {
    Trial *trial = one->trial;
    bool whole = lane->recorded == (size_t)lane->cycles;
    trial->done = whole || lane->status != CYCLE_GOOD;
    list_peaks(trial, lane->peak, lane->recorded);
    if (lane->status != CYCLE_GOOD)
        trial->observed[BEAM_MOTION] = motion_class_of_record(lane->status, SECTION_UNDECIDED, true);
    if (!whole)
        return;
    int period = section_period(lane->deflection, lane->velocity, lane->recorded, 2 * M_PI * lane->frequency,
                                RIG_REST * lane->clearance);
    trial->observed[BEAM_MOTION] = motion_class_of_record(lane->status, period, trial->series_count > 0);
    if (period != SECTION_UNDECIDED)
        tell_regular(trial, period != SECTION_NONE, (size_t)period);
}

/* Runs `count` quick trials of one rig from `states` (count x states), which receive their last states. */
static void run_quickly(Case **cases, size_t count, const Rig *rig, double *states, const Stop *stop) {
    size_t size = 2 * rig->modes.count, each = lane_room(cases[0], size);
    LanesRun *lanes = memory_zeroed(count, sizeof *lanes);
    double *room = memory_zeroed(count * each, sizeof *room);
    for (size_t i = 0; i < count; i++) {
        memcpy(room + i * each, states + i * size, size * sizeof *room);
        lanes[i] = make_lane(cases[i], size, room + i * each);
    }
    lanes_run(rig, lanes, count, stop);
    for (size_t i = 0; i < count; i++) {
        tell_lane(cases[i], &lanes[i]);
        memcpy(states + i * size, lanes[i].end, size * sizeof *room);
    }
    memory_free(room);
    memory_free(lanes);
}

static void tell_response(Trial *trial, const Response *response) {
    double *observed = trial->observed;
    list_peaks(trial, response->section.peak, response->section.count);
    size_t period = motion_class_attractor(response, &observed[BEAM_ATTRACTOR_PEAK]);
    if (response_is_told(response->verdict))
        tell_regular(trial, motion_class_is_regular(response), period);
    observed[BEAM_MOTION] = motion_class_of(response);
    observed[BEAM_ROTATION] = response->rotation.value;
    if (response->verdict == RESPONSE_TRANSIENT)
        observed[BEAM_HALF_LIFE] = motion_class_life(response);
    observed[BEAM_LYAPUNOV] = response->exponent.value;
    observed[BEAM_LYAPUNOV_ERROR] = response->exponent.error;
    observed[BEAM_ZERO_ONE] = response->zero_one;
}

/* Runs one trial with full analysis from `state`, which receives its last recorded state. */
static void run_thoroughly(const Given *given, const Case *one, const Rig *rig, double *state, const Stop *stop) {
    Rig own = rig_share(rig, one->beam.frequency, one->beam.force, one->beam.clearance);
    Response response;
    beam_cycle_respond(&response, &own, &one->beam, state, stop);
    response_confirm(&response, beam_cycle_of(&own), &(SurvivalTask){given->lanes, given->lane_cycles, 1, stop});
    tell_response(one->trial, &response);
    one->trial->done = response.verdict != RESPONSE_INTERRUPTED && !(given->lanes && response_is_quick(&response));
    if (response.section.count)
        memcpy(state, section_last(&response.section), response.section.states * sizeof *state);
    response_clear(&response);
    rig_clear_shared(&own);
}

static void run_cases(const Given *given, Case **cases, size_t count, const Rig *rig, double *states,
                      const Stop *stop) {
    for (size_t i = 0; i < count; i++) {
        begin_observed(cases[i], rig);
        cases[i]->made = true;
    }
    if (!given->thorough)
        run_quickly(cases, count, rig, states, stop);
    for (size_t i = 0; i < count && given->thorough && !stop_requested(stop); i++)
        run_thoroughly(given, cases[i], rig, states + i * 2 * rig->modes.count, stop);
}

/* Returns the rig of a case: the nominal one, or `own`, built for the case. NULL: the trial has the reason. */
static const Rig *find_rig(const Given *given, Case *one, Rig *own) {
    Fault fault = {0};
    if (beam_numbers_same_rig(&one->beam, &given->beam) && beam_numbers_followed(&one->beam, &given->rig))
        return &given->rig;
    if (rig_build(own, &one->beam, given->beam.name, &fault))
        return own;
    keep_fault(one->trial, &fault);
    one->made = true;
    return NULL;
}

/* Runs the trials that share a rig together. */
static void run_apart(const Given *given, Case *cases, size_t count, const Stop *stop) {
    Case **group = memory_zeroed(count, sizeof *group);
    for (size_t i = 0; i < count && !stop_requested(stop); i++) {
        Rig own = {0};
        const Rig *rig = cases[i].made ? NULL : find_rig(given, &cases[i], &own);
        if (!rig)
            continue;
        size_t members = 0, size = 2 * rig->modes.count;
        for (size_t j = i; j < count; j++)
            if (!cases[j].made && beam_numbers_same_rig(&cases[i].beam, &cases[j].beam) &&
                beam_numbers_followed(&cases[j].beam, rig))
                group[members++] = &cases[j];
        double *states = memory_zeroed(members * size, sizeof *states);
        for (size_t j = 0; j < members; j++)
            make_start(group[j], rig, states + j * size);
        run_cases(given, group, members, rig, states, stop);
        memory_free(states);
        if (rig == &own)
            rig_clear(&own);
    }
    memory_free(group);
}

/* Carried runs ---------------------------------------------------------------------------------------------------- */

static void run_carried(const Given *given, Case *cases, size_t count, BeamCarry *carry, const Stop *stop) {
    for (size_t i = 0; i < count && !stop_requested(stop); i++) {
        Rig own = {0};
        const Rig *rig = cases[i].made ? NULL : find_rig(given, &cases[i], &own);
        if (!rig)
            continue;
        double *state = memory_zeroed(2 * rig->modes.count, sizeof *state);
        if (!beam_carry_apply(carry, &rig->modes, state))
            make_start(&cases[i], rig, state);
        run_cases(given, &(Case *){&cases[i]}, 1, rig, state, stop);
        beam_carry_store(carry, &rig->modes, state);
        memory_free(state);
        if (rig == &own)
            rig_clear(&own);
    }
}

/* `carry`: one after another, continuing from its state; NULL: each from its own initial state. */
static void run_trials(const Given *given, const char *const *names, size_t name_count, Trial *trials, size_t count,
                       BeamCarry *carry, const Stop *stop) {
    Case *cases = memory_zeroed(count, sizeof *cases);
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < BEAM_OBSERVABLES; k++)
            trials[i].observed[k] = NAN;
        make_case(given, names, name_count, &trials[i], &cases[i]);
    }
    if (carry)
        run_carried(given, cases, count, carry, stop);
    else
        run_apart(given, cases, count, stop);
    memory_free(cases);
}

static void run(const void *context, const char *const *names, size_t name_count, Trial *trials, size_t count,
                bool carry, const Stop *stop) {
    BeamCarry from_start = {0};
    run_trials(context, names, name_count, trials, count, carry ? &from_start : NULL, stop);
    beam_carry_clear(&from_start);
}

void beam_experiment_run_on(const Experiment *experiment, const char *name, Trial *trials, size_t count,
                            BeamCarry *carry, const Stop *stop) {
    run_trials(experiment->given, &name, 1, trials, count, carry, stop);
}

/* Opening --------------------------------------------------------------------------------------------------------- */

static bool begin(Experiment *experiment, Given *given, const char *place, Fault *fault) {
    if (!rig_build(&given->rig, &given->beam, place, fault)) {
        if (given->owned)
            beam_free(&given->beam);
        memory_free(given);
        return false;
    }
    *experiment = (Experiment){.kind = "beam",
                               .observables = observables,
                               .observable_count = BEAM_OBSERVABLES,
                               .series = &series,
                               .regular = BEAM_REGULAR,
                               .outcome = BEAM_PERIOD,
                               .periods = true,
                               .measure = BEAM_PEAK_MAX,
                               .verdict = BEAM_MOTION,
                               .verdicts = motion_class_names,
                               .verdict_count = MOTION_CLASSES,
                               .verdict_quick = MOTION_CLASS_NOT_PERIODIC,
                               .carries = true,
                               .special = BEAM_EXPERIMENT_FREE,
                               .batch = given->beam.cycles > LONG ? 1 : BATCH,
                               .given = given,
                               .parameter = find_parameter,
                               .unknown = tell_unknown,
                               .nominal = nominal,
                               .run = run};
    return true;
}

bool beam_experiment_open(Experiment *experiment, const char *path, const char *const *settings, size_t setting_count,
                          Fault *fault) {
    Given *given = memory_zeroed(1, sizeof *given);
    given->owned = true;
    if (!beam_read(&given->beam, path, settings, setting_count, fault)) {
        memory_free(given);
        return false;
    }
    return begin(experiment, given, path, fault);
}

bool beam_experiment_of(Experiment *experiment, const Beam *beam, const char *place, Fault *fault) {
    Given *given = memory_zeroed(1, sizeof *given);
    given->beam = *beam;
    return begin(experiment, given, place, fault);
}

void beam_experiment_be_thorough(Experiment *experiment, size_t lanes, size_t cycles) {
    Given *given = experiment->given;
    given->thorough = experiment->slow = true;
    given->lanes = lanes;
    given->lane_cycles = cycles;
    experiment->identity = digest_chain(digest_chain(digest_chain(experiment->identity, 1), lanes), cycles);
}

void beam_experiment_close(Experiment *experiment) {
    Given *given = experiment->given;
    rig_clear(&given->rig);
    if (given->owned)
        beam_free(&given->beam);
    memory_free(given);
    *experiment = (Experiment){0};
}
